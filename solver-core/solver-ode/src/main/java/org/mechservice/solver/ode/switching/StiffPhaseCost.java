package org.mechservice.solver.ode.switching;

import java.util.Arrays;
import org.mechservice.solver.ode.SavedState;

/**
 * Judges whether an implicit method still pays: what its last 20 steps cost against what an Adams
 * method would have spent over the same way.
 *
 * <p>How long the steps of an Adams method would be is known where it was left: so long, at the
 * limit of its stability, were its last ones. Where the fastest motion has another rate, that limit
 * has moved by as much. As long as the implicit steps grow, as they do for a while from their
 * start, they are not judged.
 */
final class StiffPhaseCost {
  private static final int WINDOW = 20;

  /** Least h ρ of an Adams step at the limit of its stability, ρ the rate of the fastest motion. */
  private static final double ADAMS_LIMIT = 0.35;

  /** Cost of the Adams method, relative to the other's, from which on a change pays. */
  private static final double WORTH_A_CHANGE = 0.75;

  /** Ends of the last steps, work up to there, and what an Adams method would have spent; rings. */
  private final double[] time = new double[WINDOW + 1];

  private final double[] spent = new double[WINDOW + 1];
  private final double[] saved = new double[WINDOW + 1];
  private int slot;
  private int recorded;

  /** Length of the last steps of the Adams method, and h ρ there; 0 before ρ is known. */
  private double adamsStep;

  private double limit;

  /** Where the phase began, where a step ended last, and the sums up to there. */
  private double start;

  private double reached;

  private double ofAdams;
  private double ofThis;

  /**
   * Begins a phase.
   *
   * @param t where
   * @param adamsStep how long the steps of the Adams method were that led here
   */
  void begin(double t, double adamsStep) {
    this.adamsStep = adamsStep;
    start = t;
    reached = t;
    limit = 0;
    ofAdams = 0;
    ofThis = 0;
    watch();
  }

  /** Looks at the steps from here on. */
  void watch() {
    Arrays.fill(time, 0);
    Arrays.fill(spent, 0);
    Arrays.fill(saved, 0);
    slot = 0;
    recorded = 0;
  }

  /**
   * Takes note of a step.
   *
   * @param end of it
   * @param work of the implicit method in this phase
   * @param rate of the fastest motion, ρ
   * @param costOfAdamsStep what a step of the Adams method costs
   */
  void record(double end, double work, double rate, double costOfAdamsStep) {
    if (limit == 0) {
      limit = Math.max(ADAMS_LIMIT, adamsStep * rate);
    }
    ofAdams += costOfAdamsStep * Math.abs(end - reached) * rate / limit;
    ofThis = work;
    reached = end;
    time[slot] = end;
    spent[slot] = work;
    saved[slot] = ofAdams;
    slot = (slot + 1) % time.length;
    recorded = Math.min(recorded + 1, time.length);
  }

  /** Returns whether an Adams method would have cost clearly less over the last steps. */
  boolean costsMoreThanAdams() {
    if (recorded < time.length) {
      return false;
    }
    int latest = (slot + time.length - 1) % time.length;
    if (size(latest - 1) > size(slot)) {
      return false;
    }
    return saved[latest] - saved[slot] <= WORTH_A_CHANGE * (spent[latest] - spent[slot]);
  }

  /** Returns whether the phase as a whole cost clearly less than an Adams method would have. */
  boolean paid() {
    return ofThis <= WORTH_A_CHANGE * ofAdams;
  }

  /** Returns how long the phase was. */
  double covered() {
    return Math.abs(reached - start);
  }

  /** Returns how long the step after a slot was. */
  private double size(int after) {
    int from = (after + time.length) % time.length;
    return Math.abs(time[(from + 1) % time.length] - time[from]);
  }

  /** Carries the state between two steps over. */
  void transfer(SavedState state) {
    state.numbers(time);
    state.numbers(spent);
    state.numbers(saved);
    slot = state.integer(slot);
    recorded = state.integer(recorded);
    adamsStep = state.number(adamsStep);
    limit = state.number(limit);
    start = state.number(start);
    reached = state.number(reached);
    ofAdams = state.number(ofAdams);
    ofThis = state.number(ofThis);
  }
}
