package org.mechservice.solver.api.run;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;

/**
 * Controls and monitors one run from other threads: stop, pause, continue to a time, take a single
 * step, read the progress.
 *
 * <p>The solver calls {@link #proceed} after every accepted step and {@link #stopRequested} at
 * every evaluation; all other methods are for the controlling threads. A subclass for a run that
 * another process controls overrides {@link #holdsAt} and {@link #proceed} to query that process,
 * which need not be queried while this control is {@linkplain #isFree free}.
 */
public class RunControl {
  /** Source of the state of a run between two steps, in the thread of the run. */
  public interface StateSource {
    /**
     * Copies the present state.
     *
     * @param state as in the rows, without time; overwritten
     */
    void copyState(double[] state);
  }

  private static final long SLICE_MILLIS = 20;

  private volatile boolean stopRequested;
  private volatile double time = Double.NaN;
  private volatile double stepSize;
  private volatile int order;
  private volatile long steps;
  private volatile boolean stiff;

  private boolean held;
  // The solver reads this at every step without the lock: stop() must not wait for a solver thread
  // that was suspended while it held the lock.
  private volatile double holdAt = Double.POSITIVE_INFINITY;
  private volatile long stepsAllowed = Long.MAX_VALUE;
  private Optional<StateSource> states = Optional.empty();
  private volatile boolean stateAsked;
  private double[] stateAskedFor = {};
  private double stateTime;

  /** Requests the run to stop; it stops within one evaluation, also while it is paused. */
  public final void stop() {
    stopRequested = true;
    synchronized (this) {
      notifyAll();
    }
  }

  /**
   * Stops the run after its current step, where it can be saved; within one evaluation if no step
   * ends in time.
   *
   * @param millis longest wait for the end of a step, ms
   * @param ended whether the run has ended, so that no step ends any more
   */
  public final void stopAfterStep(long millis, BooleanSupplier ended) throws InterruptedException {
    pause();
    for (long left = millis; left > 0 && !ended.getAsBoolean(); left -= SLICE_MILLIS) {
      if (awaitHeld(SLICE_MILLIS)) {
        break;
      }
    }
    stop();
  }

  /** Returns whether a stop was requested. */
  public final boolean stopRequested() {
    return stopRequested;
  }

  /** Pauses the run after its current step. */
  public synchronized void pause() {
    stepsAllowed = steps;
    notifyAll();
  }

  // A run that may continue is no longer held, even before its thread has woken up: a caller that
  // requests a step and waits for the next hold must not see the hold before the step.
  private void release() {
    held = held && mustHold();
    notifyAll();
  }

  /** Continues the run to its end. */
  public synchronized void resume() {
    stepsAllowed = Long.MAX_VALUE;
    holdAt = Double.POSITIVE_INFINITY;
    release();
  }

  /**
   * Continues the run until a step reaches a time, then pauses it.
   *
   * @param until simulated time, s
   */
  public synchronized void resumeTo(double until) {
    stepsAllowed = Long.MAX_VALUE;
    holdAt = until;
    release();
  }

  /** Continues the run for one accepted step, then pauses it. */
  public synchronized void step() {
    holdAt = Double.POSITIVE_INFINITY;
    stepsAllowed = steps + 1;
    release();
  }

  /** Returns whether the run is waiting for {@link #resume}, {@link #resumeTo} or {@link #step}. */
  public synchronized boolean held() {
    return held;
  }

  /**
   * Waits until the run is held, or until a time-out.
   *
   * @param millis longest wait, ms
   * @return whether the run is held
   */
  public synchronized boolean awaitHeld(long millis) throws InterruptedException {
    long deadline = System.nanoTime() + millis * 1_000_000;
    while (!held) {
      long left = (deadline - System.nanoTime()) / 1_000_000;
      if (left <= 0) {
        return false;
      }
      wait(left);
    }
    return true;
  }

  /**
   * For the solver: sets the source of the state.
   *
   * @param source called only in the thread of the run, between two steps; empty for none
   */
  public final synchronized void setStates(Optional<StateSource> source) {
    states = source;
    notifyAll();
  }

  /**
   * Reads the state at the last step, also while the run is held. Only one thread may call this at
   * a time.
   *
   * @param state overwritten if available
   * @param millis longest wait for the end of a step, ms
   * @return the time of the state, s; empty if the run has no source of states, or no step has
   *     ended in time
   */
  public final synchronized OptionalDouble state(double[] state, long millis)
      throws InterruptedException {
    long deadline = System.nanoTime() + millis * 1_000_000;
    stateAskedFor = state;
    stateAsked = true;
    notifyAll();
    while (states.isPresent() && stateAsked) {
      long left = (deadline - System.nanoTime()) / 1_000_000;
      if (left <= 0) {
        break;
      }
      wait(left);
    }
    boolean given = !stateAsked;
    stateAsked = false;
    return given ? OptionalDouble.of(stateTime) : OptionalDouble.empty();
  }

  private synchronized void answerState() {
    if (stateAsked && states.isPresent()) {
      states.get().copyState(stateAskedFor);
      stateTime = time;
      stateAsked = false;
      notifyAll();
    }
  }

  /** Returns the simulated time reached, s; NaN before the start. */
  public double time() {
    return time;
  }

  /** Returns the size of the last accepted step, s. */
  public double stepSize() {
    return stepSize;
  }

  /** Returns the order of the last accepted step. */
  public int order() {
    return order;
  }

  /** Returns whether the run so far is called stiff. */
  public final boolean stiff() {
    return stiff;
  }

  /**
   * For the solver: records whether the run so far is called stiff, as its report would.
   *
   * @param stiff by {@link Stiffness}
   */
  public final void setStiff(boolean stiff) {
    this.stiff = stiff;
  }

  /** Returns the number of accepted steps. */
  public long steps() {
    return steps;
  }

  /**
   * For the solver: records the progress and blocks while a pause is requested.
   *
   * @param time time reached, s
   * @param stepSize last accepted step, s; 0 at the start
   * @param order its order; 0 at the start
   * @param steps accepted steps so far
   * @return whether the run must continue; false after {@link #stop} or an interrupt
   */
  public boolean proceed(double time, double stepSize, int order, long steps) {
    reached(time, stepSize, order, steps);
    if (stateAsked) {
      answerState();
    }
    if (mustHold()) {
      hold();
    }
    return !stopRequested;
  }

  /**
   * Records the progress of a run that another process computes, which does not wait.
   *
   * @param time as for {@link #proceed}
   * @param stepSize as for {@link #proceed}
   * @param order as for {@link #proceed}
   * @param steps as for {@link #proceed}
   */
  public final void reached(double time, double stepSize, int order, long steps) {
    this.stepSize = stepSize;
    this.order = order;
    this.steps = steps;
    this.time = time;
  }

  /** Returns whether nothing but a new request can pause or stop the run. */
  public final boolean isFree() {
    return !stopRequested && stepsAllowed == Long.MAX_VALUE && holdAt == Double.POSITIVE_INFINITY;
  }

  /**
   * For the solver: returns whether {@link #proceed}, which is called next with the same arguments,
   * would pause the run.
   *
   * @param time time reached, s
   * @param stepSize last accepted step, s
   * @param order its order
   * @param steps accepted steps so far
   */
  public boolean holdsAt(double time, double stepSize, int order, long steps) {
    return mustHold(time, steps);
  }

  private boolean mustHold() {
    return mustHold(time, steps);
  }

  private boolean mustHold(double time, long steps) {
    return !stopRequested && (steps >= stepsAllowed || time >= holdAt);
  }

  private synchronized void hold() {
    held = true;
    notifyAll();
    try {
      while (mustHold()) {
        answerState();
        wait();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      stopRequested = true;
    } finally {
      held = false;
    }
  }
}
