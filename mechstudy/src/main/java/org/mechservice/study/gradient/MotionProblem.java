package org.mechservice.study.gradient;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.api.capability.ModelEvents;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.mechanism.Event;
import org.mechservice.solver.ode.ProjectedSystem;
import org.mechservice.solver.ode.solve.FoundEvent;
import org.mechservice.solver.ode.solve.Ode;
import org.mechservice.solver.ode.solve.OdeEvent;
import org.mechservice.solver.ode.solve.OdeFunction;
import org.mechservice.solver.ode.solve.OdeMethod;
import org.mechservice.solver.ode.solve.OdeOptions;
import org.mechservice.solver.ode.solve.OdeProblem;
import org.mechservice.study.gradient.GradientModel.Part;

/** The motion as a problem of the integrators: settings of the run, events and switches. */
final class MotionProblem {
  final GradientModel model;
  final RunSettings run;

  /** All places where something jumps, in the order of the events of the problem. */
  final List<Transition> transitions = new ArrayList<>();

  private final List<OdeEvent> events = new ArrayList<>();
  private final int stopsFrom;

  /** Where the equations changed their form last. */
  private double switched = Double.NaN;

  /** The change of all integrated values at a transition. */
  interface Change {
    void apply(Transition transition, double t, double[] z);
  }

  MotionProblem(GradientModel model, RunSettings run, Change change) {
    this.model = model;
    this.run = run;
    List<Event> given = model.functions.events();
    List<OdeEvent> stops = new ArrayList<>();
    List<Transition> ends = new ArrayList<>();
    for (int e = 0; e < given.size(); e++) {
      Event event = given.get(e);
      if (event.action() == ModelEvents.Action.RECORD) {
        continue;
      }
      Transition transition =
          new Transition(model, Part.TRIGGERS, e, "event \"" + event.name() + "\"");
      OdeEvent ode = directed(OdeEvent.when(transition::value), event.direction());
      if (event.action() == ModelEvents.Action.STOP) {
        ends.add(transition);
        stops.add(ode.named(event.name()).terminal());
      } else {
        transitions.add(transition);
        events.add(ode.named(event.name()).then((t, z) -> change.apply(transition, t, z)));
      }
    }
    for (int i = 0; i < model.functions.switches().count(); i++) {
      Transition transition =
          new Transition(model, Part.SWITCHES, i, "a sign, step or contact of the forces");
      transitions.add(transition);
      events.add(
          OdeEvent.when(transition::value)
              .then(
                  (t, z) -> {
                    // both sides of the first one hold what all at the same time change
                    if (t != switched) {
                      switched = t;
                      change.apply(transition, t, z);
                    }
                  }));
    }
    stopsFrom = transitions.size();
    transitions.addAll(ends);
    events.addAll(stops);
  }

  private static OdeEvent directed(OdeEvent event, ModelEvents.Direction direction) {
    return switch (direction) {
      case RISING -> event.rising();
      case FALLING -> event.falling();
      case BOTH -> event;
    };
  }

  /** Returns the events behind which the motion goes on, of switches at the same time the first. */
  List<FoundEvent> changes(List<FoundEvent> found) {
    List<FoundEvent> changes = new ArrayList<>();
    double last = Double.NaN;
    for (FoundEvent event : found) {
      boolean isSwitch = transitions.get(event.index()).isSwitch();
      if (!isStop(event.index()) && !(isSwitch && event.time() == last)) {
        changes.add(event);
        last = isSwitch ? event.time() : last;
      }
    }
    return changes;
  }

  /** Returns whether an event ends the run. */
  boolean isStop(int event) {
    return event >= stopsFrom;
  }

  /** Returns the method that the settings name, in the integrators' terms. */
  OdeMethod method() {
    String name = run.integrator();
    return name.startsWith("ode15s") ? OdeMethod.ODE15S : OdeMethod.ODE113;
  }

  /**
   * Returns the options of an integration.
   *
   * @param tolerances absolute tolerance of each component
   */
  OdeOptions options(double[] tolerances) {
    OdeOptions options =
        OdeOptions.standard()
            .method(method())
            .rtol(run.relativeTolerance())
            .atol(tolerances)
            .keepSteps(false)
            .maxSteps(100_000_000);
    if (run.maxStep() > 0) {
      options = options.maxStep(run.maxStep());
    }
    return options;
  }

  /** Returns the number of components by which steps see switches: 1, or 0 if there are none. */
  int markers() {
    return model.functions.switches().count() > 0 ? 1 : 0;
  }

  /**
   * Returns the derivative of a marker. It jumps at each switch, so the error test bounds how far a
   * step reaches across one: at a corner the state alone would let it pass by far, and what is
   * interpolated in such a step, the place of the corner first of all, is less accurate than its
   * end.
   */
  double markerRate(double t, double[] z) {
    double[] margins = model.values(Part.SWITCHES, t, z);
    double sum = 0;
    for (int i = 0; i < margins.length; i++) {
      // different weights: switches that change together in opposite ways show, too
      sum += margins[i] > 0 ? 1 + (double) i / margins.length : 0;
    }
    return sum;
  }

  /** Returns the tolerance of a marker: the length of the run to the relative tolerance, s. */
  double markerTolerance() {
    return run.relativeTolerance() * (run.tEnd() - run.tStart());
  }

  /** Returns the options with the events of the motion. */
  OdeOptions watched(OdeOptions options) {
    OdeOptions all = options;
    for (OdeEvent event : events) {
      all = all.event(event);
    }
    return all;
  }

  /** Returns the problem of the motion and whatever follows the state in the vector. */
  OdeProblem problem(int length, OdeFunction function) {
    OdeProblem problem = Ode.system(length, function).withBreakpoints(model.functions.jumpTimes());
    return model.functions.assembles()
        ? problem.with(ProjectedSystem.class, model.equations::project)
        : problem;
  }

  /** Returns the absolute tolerances of the state, as a run has them. */
  double[] tolerances() {
    List<String> units = model.functions.stateUnits();
    double[] own = model.functions.stateTolerances();
    double[] tolerances = new double[model.n];
    Arrays.setAll(tolerances, i -> own[i] > 0 ? own[i] : run.absoluteTolerance(units.get(i)));
    return tolerances;
  }
}
