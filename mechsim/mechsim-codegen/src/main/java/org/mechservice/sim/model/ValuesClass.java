package org.mechservice.sim.model;

import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.emit.GeneratedClass;
import org.mechservice.sim.emit.ValuesPlan;
import org.mechservice.sim.equations.PowerEquations;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.closure.equations.UnwrappedAngles;
import org.mechservice.solver.dynamics.event.StateEvents;
import org.mechservice.solver.dynamics.event.WatchedTape;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Tape;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Event;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Output;
import org.mechservice.solver.symbol.Program;

/**
 * Derives code for the expressions of a model file that are not part of the equations of motion.
 */
final class ValuesClass {
  /**
   * Number of operations up to which every class is small enough; formulas written by hand have
   * about a hundred.
   */
  private static final int MOST_OPERATIONS = 20_000;

  private static final String TOO_LONG =
      "all together they take more than " + MOST_OPERATIONS + " operations";

  private static final String TURNS =
      "an angle of a cut joint is among what they depend on, whose whole turns the data count";

  /**
   * The result of deriving the expressions.
   *
   * @param plan their class, if there is one
   * @param fromData reason why they are computed from data, if they are
   */
  record Derived(Optional<GeneratedClass> plan, Optional<String> fromData) {
    private static Derived leftToData(String why) {
      return new Derived(Optional.empty(), Optional.of(why));
    }
  }

  private final Mechanism mechanism;
  private final List<Expression> triggers;
  private final List<Expression> assigned;
  private final List<Expression> watched;
  private final List<Expression> outputs;

  private ValuesClass(
      Mechanism mechanism,
      List<Expression> triggers,
      List<Expression> assigned,
      List<Expression> watched,
      List<Expression> outputs) {
    this.mechanism = mechanism;
    this.triggers = triggers;
    this.assigned = assigned;
    this.watched = watched;
    this.outputs = outputs;
  }

  private static ValuesClass of(MechmlModel model, BuildOptions options) {
    Mechanism mechanism = model.watchedMechanism();
    boolean shown = options.columns().contains(ColumnGroup.OUTPUTS);
    return new ValuesClass(
        mechanism,
        mechanism.events().stream().map(Event::trigger).toList(),
        StateEvents.assigned(mechanism),
        WatchedTape.of(mechanism).quantities(),
        shown ? model.outputs().stream().map(Output::value).toList() : List.of());
  }

  /** Derives the class. There is none if there are no expressions or if data evaluate them. */
  static Derived derive(MechmlModel model, Links links, BuildOptions options) {
    ValuesClass values = of(model, options);
    if (values.isEmpty()) {
      return new Derived(Optional.empty(), Optional.empty());
    }
    if (values.countTurns()) {
      return Derived.leftToData(TURNS);
    }
    Program triggers = program(links, values.triggers);
    Program assignments = program(links, values.assigned);
    Program watched = program(links, values.watched);
    Program outputs = program(links, values.outputs);
    int operations =
        triggers.operationCount()
            + assignments.operationCount()
            + watched.operationCount()
            + outputs.operationCount();
    if (operations > MOST_OPERATIONS) {
      return Derived.leftToData(TOO_LONG);
    }
    return new Derived(
        Optional.of(
            ValuesPlan.of(
                model.mechanism().name(), triggers, assignments, watched, outputs, options.form())),
        Optional.empty());
  }

  private static Program program(Links links, List<Expression> expressions) {
    return PowerEquations.formulas(links, expressions);
  }

  private boolean isEmpty() {
    return triggers.isEmpty() && assigned.isEmpty() && watched.isEmpty() && outputs.isEmpty();
  }

  private boolean countTurns() {
    return countTurns(triggers)
        || countTurns(assigned)
        || countTurns(watched)
        || countTurns(outputs);
  }

  private boolean countTurns(List<Expression> expressions) {
    return new Tape(expressions).leaves().stream().anyMatch(this::countsTurns);
  }

  private boolean countsTurns(Expression leaf) {
    return leaf instanceof Expression.CoordinatePosition position
        && position.coordinate() instanceof ClosureCoordinate cut
        && UnwrappedAngles.isAngle(mechanism, cut);
  }
}
