package org.mechservice.solver.integration;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.mechservice.solver.integration.EventFunctions.Reaction;
import org.mechservice.solver.integration.IntegrationFailure.Cause;

/**
 * Looks for events in the steps of an integrator: changes of sign of functions g_i(t, y).
 *
 * <p>Every step is searched at its end and at three points inside, the first one after a restart
 * also at its very beginning; two zeros of a function between two such points are not seen. A zero
 * is located on the interpolated solution to max(100 u |t|, 10⁻¹² h), without evaluating the
 * problem. The first event counts; those that cannot be told apart from it are reported together.
 * If the reaction changes the state or the equations, the step ends there and the integrator
 * {@linkplain Integrator#restart restarts}; until the next step, the solution that led to the event
 * can be interpolated.
 *
 * <p>Events that accumulate, like the bounces of a ball that comes to rest, end the integration
 * with {@link IntegrationFailure.Cause#EVENTS_ACCUMULATE}.
 *
 * <p>Shampine and Thompson, <i>Event location for ordinary differential equations</i>, Comput.
 * Math. Appl. 39 (2000) 43.
 */
public final class EventIntegration implements ResidualIntegrator {
  /** Parts of a step at which functions are evaluated. */
  private static final double[] PARTS = {0.25, 0.5, 0.75, 1};

  /** The same in the step after a restart, in which a function may turn round at once. */
  private static final double[] PARTS_AFTER_RESTART = {
    1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.25, 0.5, 0.75, 1
  };

  /** Part of what is left of the problem by which to look ahead after a restart. */
  private static final double LOOK_AHEAD = Math.sqrt(Math.ulp(1.0));

  /**
   * Longest first step after an event, relative to the distance from the one before: events may
   * follow each other faster than the tolerance has eyes for.
   */
  private static final double FIRST_STEP = 0.05;

  private final Integrator integrator;
  private final EventFunctions functions;
  private final EventSigns signs;
  private final EventSearch search;
  private final EventSearch.Path path = this::evaluate;
  private final AccumulationMonitor accumulation = new AccumulationMonitor();
  private final RecentSteps recentSteps = new RecentSteps();
  private final boolean[] occurred;

  private CompletedSystem completed = CompletedSystem.NOTHING_PASSIVE;
  private Optional<IntegrationFailure> failure = Optional.empty();

  /** Values at the points searched last and next. */
  private double[] gBefore;

  private double[] gHere;

  /** State and derivative at the point looked at, and the state to restart from. */
  private double[] y = {};

  private double[] yDot = {};
  private double[] restarted = {};

  private double tEnd;
  private double direction;

  /** End of the last step, cut off at an event. */
  private double time;

  private boolean running;
  private boolean cutOff;
  private boolean restartDue;
  private boolean justRestarted;
  private boolean stateChanged;
  private long events;

  /**
   * @param integrator takes the steps
   * @param functions looked at along them
   */
  public EventIntegration(Integrator integrator, EventFunctions functions) {
    this.integrator = integrator;
    this.functions = functions;
    int count = functions.count();
    signs = new EventSigns(functions);
    search = new EventSearch(signs, count);
    occurred = new boolean[count];
    gBefore = new double[count];
    gHere = new double[count];
  }

  @Override
  public StepResult start(OdeSystem system, double t0, double[] y0, double tEnd) {
    StepResult result = integrator.start(system, t0, y0, tEnd);
    return begin(result, system, t0, y0.length, tEnd);
  }

  /**
   * {@inheritDoc}
   *
   * @throws IllegalArgumentException also if the integrator that takes the steps is none for
   *     problems in residual form
   */
  @Override
  public StepResult start(
      ResidualSystem system, double t0, double[] y0, double[] yDot0, double tEnd) {
    StepResult result = residual().start(system, t0, y0, yDot0, tEnd);
    return begin(result, system, t0, y0.length, tEnd);
  }

  private ResidualIntegrator residual() {
    if (integrator instanceof ResidualIntegrator implicit) {
      return implicit;
    }
    throw new IllegalArgumentException("the integrator takes no problem in residual form");
  }

  private StepResult begin(
      StepResult result, Object system, double t0, int dimension, double tEnd) {
    prepare(system, dimension, tEnd);
    direction = tEnd < t0 ? -1 : 1;
    accumulation.begin(t0);
    recentSteps.clear();
    events = 0;
    Arrays.fill(occurred, false);
    return settle(result, t0);
  }

  private void prepare(Object system, int dimension, double tEnd) {
    completed = system instanceof CompletedSystem some ? some : CompletedSystem.NOTHING_PASSIVE;
    y = new double[dimension];
    yDot = new double[dimension];
    restarted = new double[dimension];
    this.tEnd = tEnd;
    failure = Optional.empty();
  }

  /** Takes note of a state without history. */
  private StepResult settle(StepResult result, double t) {
    failure = Optional.empty();
    time = t;
    cutOff = false;
    restartDue = false;
    justRestarted = true;
    running = result == StepResult.ADVANCED;
    if (result == StepResult.FAILED) {
      return result;
    }
    if (!evaluate(t, gBefore)) {
      return fail(Cause.EVENT_NOT_FINITE);
    }
    signs.begin(gBefore);
    return result;
  }

  @Override
  public StepResult restart(double t, double[] y, double longestFirstStep) {
    requireInLastStep(t);
    return settle(integrator.restart(t, y, longestFirstStep), t);
  }

  @Override
  public StepResult step() {
    if (!running) {
      throw new IllegalStateException("nothing to integrate: the end is reached, or it failed");
    }
    if (restartDue) {
      StepResult result = integrator.restart(time, restarted, FIRST_STEP * accumulation.distance());
      if (result == StepResult.STOPPED) {
        return result;
      }
      restartDue = false;
      justRestarted = true;
      cutOff = false;
      if (result != StepResult.ADVANCED) {
        running = false;
        return result;
      }
      lookAhead();
    }
    StepResult result = integrator.step();
    if (result == StepResult.STOPPED) {
      return result;
    }
    if (result == StepResult.FAILED) {
      running = false;
      return result;
    }
    double[] parts = justRestarted ? PARTS_AFTER_RESTART : PARTS;
    justRestarted = false;
    return searchStep(result, parts);
  }

  /** Sees which way the functions go on from a state that was changed. */
  private void lookAhead() {
    if (!stateChanged) {
      return;
    }
    double stretch = LOOK_AHEAD * (tEnd - time);
    integrator.interpolate(time, y, yDot);
    for (int l = 0; l < y.length; l++) {
      y[l] += stretch * yDot[l];
    }
    if (completed.complete(time + stretch, y)) {
      functions.evaluate(time + stretch, y, gHere);
      signs.lean(occurred, gBefore, gHere);
    }
  }

  /** Searches the step just taken from point to point. */
  private StepResult searchStep(StepResult result, double[] parts) {
    cutOff = false;
    double begin = integrator.previousTime();
    double end = integrator.time();
    end = direction * (end - tEnd) > 0 ? tEnd : end;
    time = end;
    recentSteps.record(
        begin, integrator.stepSize(), integrator.order(), Double.NaN, Attempt.PASSED);
    double from = begin;
    for (double part : parts) {
      double to = part == 1 ? end : begin + part * (end - begin);
      while (from != to) {
        if (!evaluate(to, gHere)) {
          return fail(Cause.EVENT_NOT_FINITE);
        }
        if (!signs.anyEvent(gHere)) {
          signs.observe(gHere);
          keep();
          from = to;
          continue;
        }
        double nearest = Math.min(Math.abs(from), Math.abs(to));
        double width = EventSearch.width(nearest, end - begin);
        if (!search.locate(from, gBefore, to, gHere, width, path)) {
          return fail(Cause.EVENT_NOT_FINITE);
        }
        from = search.time();
        Reaction reaction = react();
        if (reaction != Reaction.CONTINUE) {
          return cut(from, reaction);
        }
      }
    }
    running = result == StepResult.ADVANCED;
    return result;
  }

  /** Makes the values here those before the next point. */
  private void keep() {
    double[] freed = gBefore;
    gBefore = gHere;
    gHere = freed;
  }

  /** Lets the functions' owner react to the event found. */
  private Reaction react() {
    events++;
    double t = search.time();
    double[] behind = search.behind();
    for (int i = 0; i < occurred.length; i++) {
      occurred[i] = signs.event(i, behind[i]);
    }
    evaluate(t, gHere);
    System.arraycopy(y, 0, restarted, 0, y.length);
    Reaction reaction = functions.occurred(t, restarted, occurred);
    signs.passed(occurred, search.before(), behind);
    keep();
    return reaction;
  }

  /** Ends the step at an event. */
  private StepResult cut(double t, Reaction reaction) {
    time = t;
    cutOff = true;
    if (reaction == Reaction.STOP) {
      running = false;
      return StepResult.REACHED_END;
    }
    if (accumulation.accumulates(t)) {
      return fail(Cause.EVENTS_ACCUMULATE);
    }
    restartDue = true;
    functions.evaluate(t, restarted, gBefore);
    if (RightHandSide.firstNotFinite(gBefore) >= 0) {
      return fail(Cause.EVENT_NOT_FINITE);
    }
    stateChanged = !Arrays.equals(restarted, y);
    if (stateChanged) {
      signs.place(gBefore);
    }
    return StepResult.ADVANCED;
  }

  private boolean evaluate(double t, double[] g) {
    integrator.interpolate(t, y, yDot);
    if (!completed.complete(t, y)) {
      return false;
    }
    functions.evaluate(t, y, g);
    return RightHandSide.firstNotFinite(g) < 0;
  }

  private StepResult fail(Cause cause) {
    running = false;
    failure =
        Optional.of(
            new IntegrationFailure(
                cause, time, integrator.stepSize(), integrator.order(), -1, 0, recentSteps.list()));
    return StepResult.FAILED;
  }

  /** Returns how many events there were; those at one place count once. */
  public long events() {
    return events;
  }

  /** Returns whether a function had a change of sign in the last event. */
  public boolean occurred(int function) {
    return occurred[function];
  }

  @Override
  public double time() {
    return time;
  }

  @Override
  public double previousTime() {
    return integrator.previousTime();
  }

  @Override
  public double stepSize() {
    return cutOff ? time - integrator.previousTime() : integrator.stepSize();
  }

  @Override
  public int order() {
    return integrator.order();
  }

  @Override
  public void interpolate(double t, double[] y, double[] yDot) {
    requireInLastStep(t);
    integrator.interpolate(t, y, yDot);
  }

  private void requireInLastStep(double t) {
    if (cutOff && direction * (t - time) > 0) {
      throw new IllegalArgumentException(
          "t = " + t + " lies behind the event at " + time + " that ended the last step");
    }
  }

  @Override
  public byte[] save() {
    byte[] inner = integrator.save();
    return StateTransfer.save(
        state -> {
          state.bytes(inner);
          state.number(tEnd);
          transfer(state);
        });
  }

  @Override
  public StepResult resume(OdeSystem system, byte[] saved) {
    return resume(saved, system, system.dimension(), inner -> integrator.resume(system, inner));
  }

  @Override
  public StepResult resume(ResidualSystem system, byte[] saved) {
    return resume(saved, system, system.dimension(), inner -> residual().resume(system, inner));
  }

  private StepResult resume(byte[] saved, Object system, int dimension, Consumer<byte[]> steps) {
    StateTransfer.restore(
        saved,
        state -> {
          byte[] inner = state.bytes(new byte[0]);
          prepare(system, dimension, state.number(0));
          steps.accept(inner);
          transfer(state);
        });
    return running ? StepResult.ADVANCED : StepResult.REACHED_END;
  }

  private void transfer(StateTransfer state) {
    state.require("number of event functions", occurred.length);
    signs.transfer(state);
    accumulation.transfer(state);
    recentSteps.transfer(state);
    state.numbers(gBefore);
    state.numbers(restarted);
    time = state.number(time);
    direction = state.number(direction);
    running = state.flag(running);
    cutOff = state.flag(cutOff);
    restartDue = state.flag(restartDue);
    justRestarted = state.flag(justRestarted);
    stateChanged = state.flag(stateChanged);
    for (int i = 0; i < occurred.length; i++) {
      occurred[i] = state.flag(occurred[i]);
    }
    events = state.integer(events);
    if (functions instanceof SavedSystem saved) {
      saved.transfer(state);
    }
  }

  @Override
  public IntegrationStatistics statistics() {
    return integrator.statistics();
  }

  @Override
  public List<MethodChange> methodChanges() {
    return integrator.methodChanges();
  }

  @Override
  public long methodChangeCount() {
    return integrator.methodChangeCount();
  }

  @Override
  public IntegrationFailure failure() {
    return failure.orElseGet(integrator::failure);
  }
}
