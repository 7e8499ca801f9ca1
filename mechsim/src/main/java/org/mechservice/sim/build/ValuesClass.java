package org.mechservice.sim.build;

import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.build.dynamics.Links;
import org.mechservice.sim.build.dynamics.PowerEquations;
import org.mechservice.sim.build.emit.ValuesPlan;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.solver.api.ColumnGroup;
import org.mechservice.solver.closure.CountedAngles;
import org.mechservice.solver.dynamics.StateEvents;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Tape;
import org.mechservice.solver.mechanism.Event;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Output;

/** The expressions of a model's author that are no part of its equations, derived as code. */
final class ValuesClass {
  private final Mechanism mechanism;
  private final List<Expression> triggers;
  private final List<Expression> assigned;
  private final List<Expression> outputs;

  private ValuesClass(
      Mechanism mechanism,
      List<Expression> triggers,
      List<Expression> assigned,
      List<Expression> outputs) {
    this.mechanism = mechanism;
    this.triggers = triggers;
    this.assigned = assigned;
    this.outputs = outputs;
  }

  private static ValuesClass of(MechmlModel model, BuildOptions options) {
    Mechanism mechanism = model.watchedMechanism();
    boolean shown = options.columns().contains(ColumnGroup.OUTPUTS);
    return new ValuesClass(
        mechanism,
        mechanism.events().stream().map(Event::trigger).toList(),
        StateEvents.assigned(mechanism),
        shown ? model.outputs().stream().map(Output::value).toList() : List.of());
  }

  /** Derives the class; there is none where nothing is to be evaluated, or not by code. */
  static Optional<ValuesPlan> derive(MechmlModel model, Links links, BuildOptions options) {
    ValuesClass values = of(model, options);
    if (values.isEmpty() || values.countTurns()) {
      return Optional.empty();
    }
    return Optional.of(
        new ValuesPlan(
            model.mechanism().name(),
            !model.mechanism().parameters().isEmpty(),
            program(links, values.triggers),
            program(links, values.assigned),
            program(links, values.outputs),
            options.form()));
  }

  /** Returns whether expressions are left to the data: angles of cut joints are counted there. */
  static boolean areFromData(MechmlModel model, BuildOptions options) {
    return of(model, options).countTurns();
  }

  private static Program program(Links links, List<Expression> expressions) {
    return PowerEquations.formulas(links, expressions);
  }

  private boolean isEmpty() {
    return triggers.isEmpty() && assigned.isEmpty() && outputs.isEmpty();
  }

  private boolean countTurns() {
    return countTurns(triggers) || countTurns(assigned) || countTurns(outputs);
  }

  private boolean countTurns(List<Expression> expressions) {
    return new Tape(expressions).leaves().stream().anyMatch(this::countsTurns);
  }

  private boolean countsTurns(Expression leaf) {
    return leaf instanceof Expression.CoordinatePosition position
        && position.coordinate() instanceof ClosureCoordinate cut
        && CountedAngles.isAngle(mechanism, cut);
  }
}
