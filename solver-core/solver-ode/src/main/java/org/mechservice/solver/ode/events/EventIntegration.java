package org.mechservice.solver.ode.events;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.mechservice.solver.ode.IntegrationFailure;
import org.mechservice.solver.ode.IntegrationFailure.Cause;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.Integrator.MethodChange;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.ResidualIntegrator;
import org.mechservice.solver.ode.ResidualSystem;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.StepPolynomial;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.SystemParts;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.events.EventFunctions.Reaction;
import org.mechservice.solver.ode.step.Breakpoints;
import org.mechservice.solver.ode.step.RecentSteps;

/**
 * Looks for events in the steps of an integrator: changes of sign of functions g_i(t, y).
 *
 * <p>Every step is searched at its end and at three points inside, the first one after a restart
 * also at its very beginning, and beyond the zeros of a function that turns back between them, as
 * far as its values at these points show that it may reach zero. Two zeros of a function closer
 * together than that are not seen. A zero is located on the interpolated solution to max(100 u |t|,
 * 10⁻¹² h), without evaluating the problem.
 *
 * <p>A change of sign through infinity, a function that touches zero and turns back, one that is
 * zero at the start and leaves it at once, and one that is beyond zero at the start have no event;
 * {@link EventFunctions#noEvent} is told of them. A function that rests at exactly zero from the
 * start on has its event where it leaves zero. The first event counts; those that cannot be told
 * apart from it are reported together. If the reaction changes the state or the equations, the step
 * ends there and the integrator {@linkplain Integrator#restart restarts}; until the next step, the
 * solution that led to the event can be interpolated.
 *
 * <p>Events that accumulate, like the bounces of a ball that comes to rest, end the integration
 * with {@link IntegrationFailure.Cause#EVENTS_ACCUMULATE}.
 *
 * <p>Memory beside that of the integrator: 3 n numbers of 8 bytes and some for each function. Costs
 * are those of the functions, at four places of a step and some ten for each event.
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

  /**
   * Longest first step after an event, relative to the distance from the one before: events may
   * follow each other faster than the tolerance has eyes for.
   */
  private static final double FIRST_STEP = 0.05;

  /** Rows of steps at one jump that may be left of the problem. */
  private static final double MOST_ROWS = 1000;

  private final Integrator integrator;
  private final EventFunctions functions;
  private final EventValues values;
  private final AccumulationMonitor accumulation = new AccumulationMonitor();
  private final RecentSteps recentSteps = new RecentSteps();

  /** Where the integrator begins anew by itself. */
  private final Breakpoints places = new Breakpoints();

  private Optional<IntegrationFailure> failure = Optional.empty();

  /** State to restart from, or of the last start. */
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

  /** Whether the first step after the restart has been taken again. */
  private boolean bounded;

  /** Longest first step of the restart that is due. */
  private double longestFirstStep;

  /** Whether a function with the last event had not left zero since the one before. */
  private boolean stayedAtZero;

  private long events;

  /**
   * @param integrator takes the steps
   * @param functions looked at along them
   */
  public EventIntegration(Integrator integrator, EventFunctions functions) {
    this.integrator = integrator;
    this.functions = functions;
    values = new EventValues(integrator, functions);
  }

  @Override
  public StepResult start(OdeSystem system, double t0, double[] y0, double tEnd) {
    StepResult result = integrator.start(system, t0, y0, tEnd);
    return begin(result, system, t0, y0, tEnd);
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
    return begin(result, system, t0, y0, tEnd);
  }

  private ResidualIntegrator residual() {
    if (integrator instanceof ResidualIntegrator implicit) {
      return implicit;
    }
    throw new IllegalArgumentException("the integrator takes no problem in residual form");
  }

  private StepResult begin(
      StepResult result, SystemParts system, double t0, double[] y0, double tEnd) {
    prepare(system, y0.length, tEnd);
    places.begin(system, t0, tEnd);
    System.arraycopy(y0, 0, restarted, 0, y0.length);
    values.stepsBegin(t0, y0);
    direction = tEnd < t0 ? -1 : 1;
    accumulation.begin(t0);
    recentSteps.clear();
    events = 0;
    values.forget();
    StepResult settled = settle(result, t0);
    values.judgeStart();
    return settled;
  }

  private void prepare(SystemParts system, int dimension, double tEnd) {
    values.prepare(system, dimension, tEnd);
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
    return values.begin(t) ? result : fail(Cause.EVENT_NOT_FINITE);
  }

  @Override
  public StepResult restart(double t, double[] y, double longestFirstStep) {
    requireInLastStep(t);
    System.arraycopy(y, 0, restarted, 0, restarted.length);
    values.stepsBegin(t, y);
    return settle(integrator.restart(t, y, longestFirstStep), t);
  }

  @Override
  public StepResult step() {
    if (!running) {
      throw new IllegalStateException("nothing to integrate: the end is reached, or it failed");
    }
    if (restartDue) {
      functions.restarting(time);
      places.passUpTo(time);
      StepResult result = integrator.restart(time, restarted, longestFirstStep);
      if (result == StepResult.STOPPED) {
        return result;
      }
      restartDue = false;
      justRestarted = true;
      values.stepsBegin(time, restarted);
      cutOff = false;
      if (result != StepResult.ADVANCED) {
        running = false;
        return result;
      }
      if (stateChanged) {
        values.lookAhead(time, tEnd);
      }
    } else if (functions.searchesSteps() && places.reachedAt(integrator.time())) {
      beginPiece();
    }
    values.leaveStep();
    StepResult result = integrator.step();
    if (result == StepResult.STOPPED) {
      return result;
    }
    if (result == StepResult.FAILED) {
      running = goesOnAcross();
      return running ? StepResult.ADVANCED : result;
    }
    if (!justRestarted) {
      return searchStep(result, PARTS);
    }
    time = integrator.previousTime();
    values.joinStep(time, integrator.time());
    if (endsTooLate()) {
      return StepResult.ADVANCED;
    }
    justRestarted = false;
    if (!values.join(time)) {
      return fail(Cause.EVENT_NOT_FINITE);
    }
    result = searchStep(result, PARTS_AFTER_RESTART);
    values.reportZerosLeft();
    return result;
  }

  /** Takes note that the next step begins without history, behind a breakpoint. */
  private void beginPiece() {
    double t = integrator.time();
    places.passUpTo(t);
    functions.restarting(t);
    values.stopAt(t, restarted);
    values.stepsBegin(t, restarted);
    justRestarted = true;
  }

  /**
   * After steps have become too short: goes on from the state behind a change of the equations that
   * lies within rounding, if there is one.
   */
  private boolean goesOnAcross() {
    double t = integrator.time();
    if (!functions.searchesSteps()
        || justRestarted
        || integrator.failure().cause() != Cause.STEP_TOO_SMALL
        || !values.moveAcross(t, restarted)) {
      return false;
    }
    time = t;
    cutOff = true;
    restartDue = true;
    stateChanged = false;
    longestFirstStep = Double.POSITIVE_INFINITY;
    return true;
  }

  /**
   * Looks whether the equations change inside the first step after a restart. That step knows them
   * at its two ends alone, the second beyond the change: it is taken again, no longer than up to
   * there.
   */
  private boolean endsTooLate() {
    if (bounded || !functions.searchesSteps()) {
      bounded = false;
      return false;
    }
    double end = direction * (integrator.time() - tEnd) > 0 ? tEnd : integrator.time();
    double seen = values.seenUntil(time, end);
    if (!(direction * (end - seen) > 0)) {
      return false;
    }
    longestFirstStep = Math.abs(seen - time);
    bounded = true;
    restartDue = true;
    stateChanged = false;
    cutOff = true;
    return true;
  }

  /** Searches the step just taken from point to point. */
  private StepResult searchStep(StepResult result, double[] parts) {
    cutOff = false;
    double begin = integrator.previousTime();
    double end = integrator.time();
    end = direction * (end - tEnd) > 0 ? tEnd : end;
    time = end;
    recentSteps.record(
        begin, integrator.stepSize(), integrator.order(), Double.NaN, TrialOutcome.PASSED);
    boolean changes = false;
    if (functions.searchesSteps()) {
      double seen = values.seenUntil(begin, end);
      changes = direction * (tEnd - seen) > 0;
      end = Double.isNaN(seen) ? end : seen;
      time = end;
      if (Math.abs(tEnd - end) > MOST_ROWS * Math.abs(end - functions.slidingSince())) {
        return slides(end);
      }
    }
    double from = begin;
    int points = values.survey(begin, end, parts);
    for (int point = 0; point < points; point++) {
      double to = values.point(point);
      while (from != to) {
        if (!values.lookAt(to)) {
          return fail(Cause.EVENT_NOT_FINITE);
        }
        if (!values.anyEvent()) {
          values.moveOn();
          from = to;
          continue;
        }
        double nearest = Math.min(Math.abs(from), Math.abs(to));
        double width = EventSearch.width(nearest, end - begin);
        if (!values.locate(from, to, width)) {
          return fail(Cause.EVENT_NOT_FINITE);
        }
        from = values.time();
        Reaction reaction = react();
        if (reaction != Reaction.CONTINUE) {
          return cut(from, reaction);
        }
      }
    }
    values.endStep(end, tEnd);
    if (changes) {
      return goOnFrom(end);
    }
    running = result == StepResult.ADVANCED;
    return result;
  }

  /** Ends the integration: the solution slides along a jump and would take millions of steps. */
  private StepResult slides(double t) {
    running = false;
    // as long as the row of steps: the way along the derivative leads across the jump
    double size = Math.max(Math.abs(t - functions.slidingSince()), 2000 * Math.ulp(t));
    failure =
        Optional.of(
            new IntegrationFailure(
                Cause.STEP_TOO_SMALL, t, size, integrator.order(), -1, 0, recentSteps.list()));
    return StepResult.FAILED;
  }

  /** Ends the step where something would go unseen; the integration begins anew from there. */
  private StepResult goOnFrom(double t) {
    if (!values.stopAt(t, restarted)) {
      return fail(Cause.EVENT_NOT_FINITE);
    }
    cutOff = true;
    restartDue = true;
    stateChanged = false;
    longestFirstStep = functions.longestFirstStep();
    return StepResult.ADVANCED;
  }

  /** Calls the reaction of the functions' owner to the event found. */
  private Reaction react() {
    Reaction reaction = Reaction.CONTINUE;
    if (values.determine(restarted)) {
      events++;
      reaction = functions.occurred(values.time(), restarted, values.occurred());
    }
    stayedAtZero = values.anyStayedAtZero();
    values.pass();
    return reaction;
  }

  /** Ends the step at an event. */
  private StepResult cut(double t, Reaction reaction) {
    time = t;
    cutOff = true;
    boolean atEnd = direction * (t - tEnd) >= 0;
    if (reaction == Reaction.STOP || atEnd) {
      // Behind the end the problem need not have values.
      running = false;
      return StepResult.REACHED_END;
    }
    if (accumulation.accumulates(t, stayedAtZero)) {
      return fail(Cause.EVENTS_ACCUMULATE);
    }
    restartDue = true;
    longestFirstStep = FIRST_STEP * accumulation.distance();
    stateChanged = !values.standsAt(restarted);
    if (!values.goOnFrom(t, restarted, stateChanged)) {
      return fail(Cause.EVENT_NOT_FINITE);
    }
    return StepResult.ADVANCED;
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
    return values.occurred()[function];
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
  public int keptLength() {
    return integrator.keptLength();
  }

  @Override
  public StepPolynomial keepStep(double[] kept, int from) {
    return integrator.keepStep(kept, from);
  }

  @Override
  public byte[] save() {
    byte[] inner = integrator.save();
    return SavedState.save(
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

  private StepResult resume(
      byte[] saved, SystemParts system, int dimension, Consumer<byte[]> steps) {
    SavedState.restore(
        saved,
        state -> {
          byte[] inner = state.bytes(new byte[0]);
          prepare(system, dimension, state.number(0));
          steps.accept(inner);
          transfer(state);
          places.begin(system, Math.copySign(Double.POSITIVE_INFINITY, -direction), tEnd);
          places.passUpTo(direction > 0 ? Math.nextDown(time) : Math.nextUp(time));
        });
    return running ? StepResult.ADVANCED : StepResult.REACHED_END;
  }

  private void transfer(SavedState state) {
    accumulation.transfer(state);
    recentSteps.transfer(state);
    state.numbers(restarted);
    time = state.number(time);
    direction = state.number(direction);
    running = state.flag(running);
    cutOff = state.flag(cutOff);
    restartDue = state.flag(restartDue);
    justRestarted = state.flag(justRestarted);
    stateChanged = state.flag(stateChanged);
    longestFirstStep = state.number(longestFirstStep);
    bounded = state.flag(bounded);
    events = state.integer(events);
    values.transfer(state);
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
