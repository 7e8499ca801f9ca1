package org.mechservice.solver.ode.solve;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.ode.IntegrationFailure;
import org.mechservice.solver.ode.IntegrationFailure.Cause;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.events.EventIntegration;
import org.mechservice.solver.ode.jumps.UndeclaredJumps;
import org.mechservice.solver.ode.step.WatchedIntegrator;

/** One integration from its start, or from a checkpoint, to its end. */
final class IntegrationRun {
  /** Part of the interval by which to look ahead of the start. */
  private static final double AHEAD = 0x1p-20;

  /** Steps of up to so many units in the last place of time cannot be made shorter. */
  private static final double SMALLEST = 64;

  /** Part of its size by which a component moves in such a step if it has a pole there. */
  private static final double MOVE = 0x1p-12;

  /** More than that part is moved by what is about zero. */
  private static final double MOST = 0x1p10;

  private final PosedProblem problem;
  private final OdeOptions options;
  private final ComposedEvents events;
  private final Integrator integrator;
  private final SolvedStep step;

  private final double[] y;
  private final double[] yDot;

  /** Arrays, as an iterator of a list would be made anew in each step. */
  private final StepHandler[] stepHandlers;

  private RequestedTimes[] outputs = {};
  private Optional<KeptSteps> kept = Optional.empty();

  /** Where the problem begins, and 1 or −1: in which direction it is integrated. */
  private double origin;

  private double direction = 1;

  /** Where this solution begins, is to end, and up to where its steps were told. */
  private double start;

  private double tEnd;
  private double reached;
  private double[] startState = {};

  /** State up to where steps were told; a step that was cancelled may have gone beyond. */
  private final double[] standing;

  private StepResult result = StepResult.ADVANCED;
  private long steps;

  /** Whether consistent values of the start were found. */
  private boolean started = true;

  /** Whether a step was cut short by the cancel signal, and whether the signal is left alone. */
  private boolean interrupted;

  private boolean completing;

  /**
   * @throws IllegalArgumentException if the options do not fit the problem
   */
  IntegrationRun(PosedProblem problem, OdeOptions options) {
    this.problem = problem;
    this.options = options;
    events = new ComposedEvents(options.events(), options.relativeTolerance());
    WatchedIntegrator method =
        problem.integrator(
            options.settings(() -> !completing && options.cancelled().getAsBoolean()));
    Integrator steps = options.searchesUndeclaredJumps() ? UndeclaredJumps.around(method) : method;
    integrator = options.events().isEmpty() ? steps : new EventIntegration(steps, events);
    stepHandlers = options.stepHandlers().toArray(StepHandler[]::new);
    step = new SolvedStep(integrator, problem.dimension());
    y = new double[problem.dimension()];
    yDot = new double[problem.dimension()];
    standing = new double[problem.dimension()];
  }

  /** Integrates from a start. */
  OdeSolution solve(double t0, double[] y0, double t1) {
    double[] begin = y0.clone();
    if (y0.length == problem.dimension()) {
      lookForEventsAtStart(t0, begin, t1);
    }
    result = problem.start(integrator, t0, begin, t1);
    started = result != StepResult.FAILED && result != StepResult.STOPPED;
    if (started) {
      integrator.interpolate(t0, begin, yDot);
    }
    origin = t0;
    direction = t1 < t0 ? -1 : 1;
    tEnd = t1;
    place(t0, begin);
    if (started) {
      passOutputs(false);
    }
    if (started && events.terminal()) {
      result = StepResult.REACHED_END;
    }
    return goOn();
  }

  private void lookForEventsAtStart(double t0, double[] y0, double t1) {
    if (t1 != t0 && events.anyZeroAtStart(t0, y0)) {
      double ahead = t0 + AHEAD * (t1 - t0);
      events.lookAtStart(t0, y0, ahead, problem.solutionAhead(t0, y0, ahead));
    }
  }

  /** Begins the solution at a place. */
  private void place(double from, double[] state) {
    start = from;
    startState = state;
    reached = from;
    outputs =
        options.outputs().stream()
            .map(request -> RequestedTimes.of(request, origin, tEnd))
            .toArray(RequestedTimes[]::new);
    kept = options.keepsSteps() ? Optional.of(new KeptSteps(from, direction)) : Optional.empty();
  }

  /** Integrates from a checkpoint. */
  OdeSolution resume(OdeCheckpoint checkpoint) {
    SavedState.restore(checkpoint.bytes(), this::transfer);
    if (integrator.time() != reached) {
      passStep();
    }
    return goOn();
  }

  /** Carries the run between two steps over. */
  private void transfer(SavedState state) {
    state.require("kind of checkpoint", "solve");
    byte[] inner = state.bytes(state.restoring() ? new byte[0] : integrator.save());
    origin = state.number(origin);
    direction = state.number(direction);
    tEnd = state.number(tEnd);
    double from = state.number(reached);
    int length = state.integer(y.length);
    if (length != y.length) {
      throw new IllegalArgumentException(
          "the problem has " + y.length + " unknowns, but that of the checkpoint has " + length);
    }
    if (!state.restoring() && integrator.time() == reached) {
      readEnd(standing);
    }
    state.numbers(standing);
    if (state.restoring()) {
      StepResult resumed = problem.resume(integrator, inner);
      result = events.terminal() ? StepResult.REACHED_END : resumed;
      place(from, standing.clone());
    }
    state.require("number of output requests", outputs.length);
    Arrays.stream(outputs).forEach(times -> times.transfer(state));
    events.transferFound(state, reached, direction);
  }

  /** Takes steps until there is a reason to end. */
  private OdeSolution goOn() {
    while (result == StepResult.ADVANCED && !step.stopAsked()) {
      result = integrator.step();
      if (result != StepResult.STOPPED && integrator.time() != reached) {
        passStep();
      }
    }
    interrupted = result == StepResult.STOPPED;
    OdeSolution solution = solution();
    if (result == StepResult.FAILED && !options.returnsFailures()) {
      throw new IntegrationException(
          solution,
          solution.failure().orElseThrow(),
          options.method(),
          options.maxSteps(),
          events.notFinite());
    }
    return solution;
  }

  /** Passes the last step to all its receivers. */
  private void passStep() {
    double end = integrator.time();
    step.place(reached, end);
    if (kept.isPresent()) {
      kept.get().add(integrator, end);
    }
    reached = end;
    steps++;
    passOutputs(true);
    for (StepHandler handler : stepHandlers) {
      handler.accept(step);
    }
    if (options.checkpointDistance() > 0 && steps % options.checkpointDistance() == 0) {
      options.checkpointHandler().ifPresent(handler -> handler.accept(checkpoint()));
    }
  }

  private void passOutputs(boolean inside) {
    for (RequestedTimes times : outputs) {
      while (times.hasNext() && direction * (times.next() - reached) <= 0) {
        if (inside && times.next() != reached) {
          integrator.interpolate(times.next(), y, yDot);
        } else {
          readEnd(y);
        }
        times.pass(y);
      }
    }
  }

  /** Reads the state where the run stands, behind an event that happened there. */
  private void readEnd(double[] state) {
    if (events.happenedAt(reached) && reached != start) {
      System.arraycopy(events.after(), 0, state, 0, state.length);
    } else if (steps == 0 && reached == start) {
      System.arraycopy(startState, 0, state, 0, state.length);
    } else {
      integrator.interpolate(reached, state, yDot);
    }
  }

  private OdeSolution solution() {
    readEnd(standing);
    boolean failed = result == StepResult.FAILED;
    Optional<IntegrationFailure> failure =
        failed ? Optional.of(named(integrator.failure())) : Optional.empty();
    return new OdeSolution(
        new OdeSolution.Interval(start, startState, reached, standing.clone(), tEnd),
        reason(),
        failure,
        kept,
        events.found(),
        events.remarks(),
        integrator.statistics(),
        integrator.methodChanges(),
        this::checkpoint);
  }

  /**
   * Returns a failure, as that of a solution without bound if the state, which steps of no size
   * carry on, still moves by a part of itself in the smallest of them.
   */
  private IntegrationFailure named(IntegrationFailure failure) {
    boolean stuck =
        failure.cause() == Cause.NO_CONVERGENCE
            || (failure.cause() == Cause.STEP_TOO_SMALL && !failure.slidesAlongJump());
    boolean smallest = Math.abs(failure.stepSize()) <= SMALLEST * Math.ulp(integrator.time());
    int component = stuck && smallest && reached != start ? growing(failure.stepSize()) : -1;
    return component < 0
        ? failure
        : new IntegrationFailure(
            Cause.UNBOUNDED,
            failure.time(),
            failure.stepSize(),
            failure.order(),
            component,
            failure.allowedError(),
            failure.lastSteps());
  }

  /** Returns the component that moves by a part of itself in a step, −1 if there is none. */
  private int growing(double stepSize) {
    integrator.interpolate(integrator.time(), y, yDot);
    for (int l = 0; l < y.length; l++) {
      double move = Math.abs(stepSize * yDot[l]) / Math.abs(y[l]);
      if (move > MOVE && move < MOST) {
        return l;
      }
    }
    return -1;
  }

  private EndReason reason() {
    return switch (result) {
      case REACHED_END -> events.terminal() ? EndReason.EVENT : EndReason.REACHED_END;
      case FAILED -> EndReason.FAILED;
      case STOPPED -> EndReason.CANCELLED;
      case ADVANCED -> EndReason.STOPPED;
    };
  }

  private OdeCheckpoint checkpoint() {
    if (started && interrupted) {
      completing = true;
      result = integrator.step();
      interrupted = false;
    }
    if (!started || result == StepResult.FAILED) {
      throw new IllegalStateException(
          "the integration failed or was cancelled at t = "
              + reached
              + " before a step from which it could go on");
    }
    return OdeCheckpoint.of(SavedState.save(this::transfer));
  }
}
