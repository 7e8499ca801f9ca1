package org.mechservice.solver.ode.switching;

import java.util.Arrays;
import org.mechservice.solver.ode.SavedState;

/**
 * Judges whether an implicit method still pays: what its steps cost against what an Adams method
 * would have spent over the same way.
 *
 * <p>How long the steps of an Adams method would be is known where it was left: so long, at the
 * limit of its stability, were its last ones. Where the fastest motion has another rate, that limit
 * has moved by as much. What steps cost beyond that adds up, and what others save is taken off,
 * down to nothing, as in the test of Page, <i>Continuous inspection schemes</i>, Biometrika 41
 * (1954) 100: a few bad steps among good ones are no reason to leave, as few good ones among bad
 * are none to stay. Steps that grow over 20, as they do for a while from a start, are not held
 * against it.
 */
final class StiffPhaseCost {
  private static final int WINDOW = 20;

  /** Least h ρ of an Adams step at the limit of its stability, ρ the rate of the fastest motion. */
  private static final double ADAMS_LIMIT = 0.35;

  /** Cost of the Adams method, relative to the other's, at which steps are neither. */
  private static final double WORTH_A_CHANGE = 0.75;

  /** Sizes of the last steps; a ring. */
  private final double[] sizes = new double[WINDOW];

  private int slot;
  private int recorded;
  private double loss;

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
    Arrays.fill(sizes, 0);
    loss = 0;
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
    double size = Math.abs(end - reached);
    double adams = costOfAdamsStep * size * rate / limit;
    double more = WORTH_A_CHANGE * (work - ofThis) - adams;
    boolean judged = recorded == WINDOW && size <= sizes[slot];
    if (judged || more < 0) {
      loss = Math.max(0, loss + more);
    }
    ofAdams += adams;
    ofThis = work;
    reached = end;
    sizes[slot] = size;
    slot = (slot + 1) % WINDOW;
    recorded = Math.min(recorded + 1, WINDOW);
  }

  /**
   * Returns by how much the latest steps cost more than they may: the largest sum over any number
   * of them.
   */
  double loss() {
    return loss;
  }

  /** Returns whether the phase as a whole cost clearly less than an Adams method would have. */
  boolean paid() {
    return ofThis <= WORTH_A_CHANGE * ofAdams;
  }

  /** Returns how long the phase was. */
  double covered() {
    return Math.abs(reached - start);
  }

  /** Carries the state between two steps over. */
  void transfer(SavedState state) {
    state.numbers(sizes);
    loss = state.number(loss);
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
