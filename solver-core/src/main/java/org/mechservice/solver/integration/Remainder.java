package org.mechservice.solver.integration;

import java.util.Arrays;

/**
 * What an iteration leaves of the equations of a step, from change to change and from step to step.
 *
 * <p>Nothing else shows that a matrix has become wrong while all changes stay tiny: where a body
 * sticks by a steep law of friction a small change of its velocity solves anything; once it has
 * broken loose the law is flat, and nothing is solved any more. A remainder like those of the steps
 * before needs no second look; to have one at every large remainder would cost a quarter more
 * evaluations on stiff chemistry. A remainder that grows slowly can still escape.
 */
final class Remainder {
  /** Growth from step to step by which a remainder is usual. */
  private static final double USUAL_GROWTH = 2;

  /** Share of a remainder that is remembered from step to step. */
  private static final double MEMORY = 0.5;

  /**
   * What may be left, in units of the tolerance and as if nothing were stiff: after a first change
   * by the rate known, and before a last change, which mends most of it.
   */
  private static final double EXPECTED = 30;

  private static final double LEFT = 100;

  /** Part that may remain after a change for which the matrix is right. */
  private static final double REDUCED = 0.3;

  /** What was left before the last change, the one before, and the first one, length n. */
  private double[] last;

  private double[] before;

  private final double[] first;

  /** Magnitudes usual before a first change; 0 if none are known. */
  private final double[] usual;

  Remainder(int dimension) {
    last = new double[dimension];
    before = new double[dimension];
    first = new double[dimension];
    usual = new double[dimension];
  }

  /** Begins an iteration. */
  void begin() {
    Arrays.fill(last, 0);
  }

  /** Keeps what is left before a change; the array is not kept. */
  void keep(double[] left, boolean beforeFirst) {
    double[] freed = before;
    before = last;
    last = freed;
    System.arraycopy(left, 0, last, 0, left.length);
    if (beforeFirst) {
      System.arraycopy(left, 0, first, 0, left.length);
    }
  }

  /**
   * Returns whether what is left before the first change is usual, or what the change will leave of
   * it is little.
   *
   * @param rate at which it is expected to fall
   */
  boolean usual(StepEquations equations, double hGamma, ErrorNorm norm, double rate) {
    double little = EXPECTED * (1 - rate) / rate;
    return equations.better(hGamma, usual, USUAL_GROWTH, last, norm, little);
  }

  /** Returns whether the change before the last did what it should, as far as rounding let it. */
  boolean reduced(
      StepEquations equations, double hGamma, BackwardDifferences differences, ErrorNorm norm) {
    return equations.better(hGamma, before, REDUCED, last, norm, LEFT)
        || equations.leftByRounding(hGamma, differences);
  }

  /**
   * Returns whether next to nothing is left before a first change of which nothing is known.
   *
   * @param small norm of a change that is small
   */
  boolean negligible(
      StepEquations equations,
      double hGamma,
      BackwardDifferences differences,
      ErrorNorm norm,
      double small) {
    return equations.better(hGamma, before, 0, last, norm, small)
        || equations.leftByRounding(hGamma, differences);
  }

  /** Takes what was left before the first change for usual: the step is solved. */
  void remember() {
    for (int l = 0; l < usual.length; l++) {
      usual[l] = Math.max(MEMORY * usual[l], Math.abs(first[l]));
    }
  }

  /** Forgets what is usual: that was by other factors. */
  void forget() {
    Arrays.fill(usual, 0);
  }

  /** Carries what is usual over. */
  void transfer(StateTransfer state) {
    state.numbers(usual);
  }
}
