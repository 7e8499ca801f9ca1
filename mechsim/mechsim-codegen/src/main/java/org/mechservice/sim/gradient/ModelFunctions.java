package org.mechservice.sim.gradient;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.emit.ModelClass;
import org.mechservice.sim.equations.PowerEquations;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.closure.assembly.Assembly;
import org.mechservice.solver.closure.assembly.LoopFinding;
import org.mechservice.solver.closure.equations.UnwrappedAngles;
import org.mechservice.solver.dynamics.event.StateEvents;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Event;
import org.mechservice.solver.mechanism.FurtherChange;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Parameter;
import org.mechservice.solver.mechanism.Sampling;
import org.mechservice.solver.mechanism.StateChange;

/**
 * Everything of a model that a gradient needs: equations, observed columns, events, switches, each
 * with its derivatives; and the start. Workspace of one thread.
 */
public final class ModelFunctions {
  private final RunSettings run;
  private final Mechanism mechanism;
  private final double[] parameters;
  private final VariationalEquations equations;
  private final ObservedColumns known;
  private final DifferentiableFunction columns;
  private final DifferentiableFunction triggers;
  private final DifferentiableFunction assignments;
  private final DifferentiableFunction switches;
  private final int jumps;

  /**
   * Derives the functions of a model.
   *
   * @param run start and end of the run
   * @param columns observed columns, in order
   * @param chosen numbers of the parameters, among those that are inputs of the code, by which to
   *     differentiate
   * @throws IllegalArgumentException if the model has a part without derivative, or no such column;
   *     names it
   */
  public ModelFunctions(MechmlModel model, RunSettings run, List<String> columns, int[] chosen) {
    this.run = run;
    this.mechanism = model.watchedMechanism();
    requireDifferentiable(mechanism);
    parameters = mechanism.parameters().stream().mapToDouble(Parameter::value).toArray();
    int n = mechanism.stateCount();
    equations =
        mechanism.closures().isEmpty()
            ? new OpenVariations(mechanism, chosen, parameters)
            : new ClosedVariations(mechanism, chosen, parameters, run.tStart(), start());
    known = new ObservedColumns(model);
    this.columns =
        new DifferentiableFunction(
            known.program(columns), 2 * n, columns.size(), chosen, parameters);
    Links links = Links.of(mechanism);
    List<Event> events = mechanism.events();
    triggers =
        new DifferentiableFunction(
            PowerEquations.formulas(links, events.stream().map(Event::trigger).toList()),
            n,
            events.size(),
            chosen,
            parameters);
    assignments =
        new DifferentiableFunction(
            PowerEquations.formulas(links, StateEvents.assigned(mechanism)),
            n,
            StateEvents.assigned(mechanism).size(),
            chosen,
            parameters);
    Switches places = new Switches(equations.programs(), chosen);
    switches = new DifferentiableFunction(places.margins(), n, places.count(), chosen, parameters);
    jumps = places.jumps();
  }

  private static void requireDifferentiable(Mechanism mechanism) {
    List<String> without = new ArrayList<>();
    if (ModelClass.hasUserForces(mechanism)) {
      without.add("forces written as classes, whose derivatives nobody knows");
    }
    if (!mechanism.closures().isEmpty() && !UnwrappedAngles.of(mechanism).isEmpty()) {
      without.add(
          "an angle of a cut joint whose whole turns are counted (measure it at a joint of"
              + " the tree)");
    }
    for (Sampling sampling : mechanism.samplings()) {
      without.add("the sampled state \"" + sampling.name() + "\", which is set at given times");
    }
    for (Event event : mechanism.events()) {
      for (StateChange change : event.changes()) {
        if (!mechanism.closures().isEmpty()) {
          without.add(
              "event \"" + event.name() + "\", which sets coordinates of a model with loops");
        } else if (!change.positions().isEmpty()
            && mechanism.joints().get(change.joint()).type().hasEulerParameters()) {
          without.add("event \"" + event.name() + "\", which sets the Euler parameters of a joint");
        }
      }
    }
    if (!mechanism.motionJumps(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY).isEmpty()) {
      without.add("a driven joint whose prescribed motion jumps");
    }
    if (!without.isEmpty()) {
      throw new IllegalArgumentException(
          "there is no gradient for " + String.join(", nor for ", without));
    }
  }

  /** Returns values of all parameters that are inputs, SI; may be changed between evaluations. */
  public double[] parameters() {
    return parameters;
  }

  /** Returns the equations of motion. */
  public VariationalEquations equations() {
    return equations;
  }

  /** Returns the observed columns as functions of [y; y']. */
  public DifferentiableFunction columns() {
    return columns;
  }

  /**
   * Returns the SI unit of a column.
   *
   * @throws IllegalArgumentException if there is no such column
   */
  public String unit(String column) {
    return known.unit(column);
  }

  /** Returns which component of the state a column is; empty if it is none. */
  public Optional<Integer> state(String column) {
    return known.state(column);
  }

  /** Returns the names of the components of the state. */
  public List<String> stateNames() {
    return known.stateNames();
  }

  /** Returns the SI units of the components of the state. */
  public List<String> stateUnits() {
    return known.stateUnits();
  }

  /** Returns the tolerances that the file gives components of the state; 0 where it gives none. */
  public double[] stateTolerances() {
    double[] tolerances = new double[mechanism.stateCount()];
    for (int i = 0; i < mechanism.furtherStates().size(); i++) {
      tolerances[mechanism.furtherOffset() + i] =
          mechanism.furtherStates().get(i).absoluteTolerance();
    }
    return tolerances;
  }

  /** Returns the functions whose zeros are the events of the file. */
  public DifferentiableFunction triggers() {
    return triggers;
  }

  /** Returns the events of the file. */
  public List<Event> events() {
    return mechanism.events();
  }

  /** Returns the values that events assign, of all events in their order. */
  public DifferentiableFunction assignments() {
    return assignments;
  }

  /** Returns the components of the state that an event sets, for all its assignments in order. */
  public List<int[]> assignedComponents() {
    List<int[]> components = new ArrayList<>();
    for (Event event : mechanism.events()) {
      List<Integer> own = new ArrayList<>();
      for (StateChange change : event.changes()) {
        int q = mechanism.positionOffset(change.joint());
        int v = mechanism.positionCount() + mechanism.velocityOffset(change.joint());
        for (int i = 0; i < change.positions().size(); i++) {
          own.add(q + i);
        }
        for (int i = 0; i < change.velocities().size(); i++) {
          own.add(v + i);
        }
      }
      for (FurtherChange change : event.furtherChanges()) {
        own.add(mechanism.furtherOffset() + change.state());
      }
      components.add(own.stream().mapToInt(Integer::intValue).toArray());
    }
    return components;
  }

  /** Returns the functions at whose zeros the equations take another form; jumps first. */
  public DifferentiableFunction switches() {
    return switches;
  }

  /** Returns whether the equations are continuous where a switch is zero. */
  public boolean isCorner(int number) {
    return number >= jumps;
  }

  /** Returns the times between start and end at which the equations jump by themselves. */
  public double[] jumpTimes() {
    return present().timeJumps(run.tStart(), run.tEnd()).stream()
        .mapToDouble(Double::doubleValue)
        .toArray();
  }

  /** Returns the mechanism with the present values of the parameters. */
  private Mechanism present() {
    return with(parameters);
  }

  private Mechanism with(double[] values) {
    double[] inFile = new double[values.length];
    for (int i = 0; i < inFile.length; i++) {
      Parameter parameter = mechanism.parameters().get(i);
      inFile[i] = values[i] * parameter.denominator() / parameter.numerator();
    }
    return values.length == 0 ? mechanism : mechanism.with(inFile);
  }

  /** Returns the start of a run, its loops closed. */
  public double[] start() {
    return start(present(), -1, 0);
  }

  /** Returns the start with one component of the file's start moved. */
  public double[] startMoved(int component, double by) {
    return start(present(), component, by);
  }

  /** Returns the start with another value of a parameter that is an input, SI. */
  public double[] startWith(int parameter, double value) {
    double[] others = Arrays.copyOf(parameters, parameters.length);
    others[parameter] = value;
    return start(with(others), -1, 0);
  }

  /** Returns whether the start depends on parameters: of loops it does, by their assembly. */
  public boolean assembles() {
    return !mechanism.closures().isEmpty();
  }

  private double[] start(Mechanism mechanism, int component, double by) {
    double[] y = new double[mechanism.stateCount()];
    mechanism.initialState(y);
    if (component >= 0) {
      y[component] += by;
    }
    if (!mechanism.closures().isEmpty()) {
      List<LoopFinding> failed =
          new Assembly(new TreeGeometry(mechanism))
              .assemble(run.tStart(), y).stream()
                  .filter(finding -> !finding.kind().isWarning())
                  .toList();
      if (!failed.isEmpty()) {
        throw new IllegalArgumentException(
            failed.stream().map(finding -> finding.note().text()).collect(Collectors.joining(" ")));
      }
    }
    return y;
  }
}
