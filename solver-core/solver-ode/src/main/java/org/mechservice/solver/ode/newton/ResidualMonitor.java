package org.mechservice.solver.ode.newton;

import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.backward.BackwardDifferences;
import org.mechservice.solver.ode.step.ErrorNorm;

/**
 * What an iteration leaves of the equations of a step, from change to change and from step to step.
 *
 * <p>Nothing else shows that a matrix has become wrong while all changes stay tiny: where a body
 * sticks by a steep law of friction a small change of its velocity solves anything; once it has
 * broken loose the law is flat, and nothing is solved any more. To have a second look at every
 * large remainder would cost a quarter more evaluations on stiff chemistry. So one no larger than
 * the smallest since the rate of convergence was measured needs none: the matrix that mended that
 * one mends this one, if it mends most of anything. Of a larger one the rate is taken to have grown
 * in proportion, as it does for what the equations curve; it may only leave little. Steps held
 * equal raise a remainder slowly, so comparing it with the step before would let it grow unnoticed.
 *
 * <p>What counts is the share of each equation that a change was seen to leave. The rate at which
 * changes fall, which is that of their largest component, does not tell it of a joint that sticks:
 * its share in them is tiny whether its equation is being solved or not.
 */
final class ResidualMonitor {
  /** Growth over the smallest one by which a remainder is no larger. */
  private static final double SAME = 2;

  /**
   * What may be left, in units of the tolerance and as if nothing were stiff: after a first change,
   * as far as the rate tells, and before a last change, which mends most of it.
   */
  private static final double EXPECTED = 30;

  private static final double LEFT = 100;

  /** Part that may remain after a change for which the matrix is right. */
  private static final double REDUCED = 0.3;

  /** What was left before the first change, length n. */
  private final double[] first;

  /** The same before the last change and the one before it, which may be the first, length n. */
  private double[] last;

  private double[] before;

  /** What was left before two later changes, by turns, and before there was any, length n. */
  private final double[] later;

  private final double[] afterThat;
  private final double[] nothing;

  /** Smallest magnitudes before a first change since the rate was measured, length n. */
  private final double[] usual;

  /** Share that a change left of each equation when the rate was measured, length n. */
  private final double[] leftOver;

  /** What a first change is expected to leave, length n. */
  private final double[] expected;

  ResidualMonitor(int dimension) {
    first = new double[dimension];
    later = new double[dimension];
    afterThat = new double[dimension];
    nothing = new double[dimension];
    last = first;
    before = nothing;
    usual = new double[dimension];
    leftOver = new double[dimension];
    expected = new double[dimension];
  }

  /** Keeps what is left before a change; the array is not kept. */
  void keep(double[] left, boolean beforeFirst) {
    if (!beforeFirst) {
      before = last;
      last = before == later ? afterThat : later;
    } else if (last != first) {
      before = nothing;
      last = first;
    }
    // In small systems a call of arraycopy costs twice the loop.
    for (int l = 0; l < left.length; l++) {
      last[l] = left[l];
    }
  }

  /**
   * Returns whether what is left before the first change is usual, or what the change will leave of
   * it is little.
   *
   * @param rate at which changes are expected to fall
   */
  boolean usual(StepEquations equations, double hGamma, ErrorNorm norm, double rate) {
    if (equations.slight(last, norm, EXPECTED)) {
      return true;
    }
    for (int l = 0; l < usual.length; l++) {
      double size = Math.abs(last[l]);
      double left = Math.max(rate, leftOver[l]);
      boolean same = left <= REDUCED && size <= SAME * usual[l];
      expected[l] = same || size == 0 ? 0 : last[l] * share(left, size / usual[l]);
    }
    return equations.better(hGamma, usual, 0, expected, norm, EXPECTED);
  }

  /** Returns the share of what is left that a first change leaves, given its growth. */
  private static double share(double rate, double growth) {
    double grown = rate * Math.max(1, growth);
    return grown < 0.5 ? grown / (1 - grown) : 1;
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

  /** Takes note that the rate was measured for what was left before the first change. */
  void measured() {
    for (int l = 0; l < usual.length; l++) {
      usual[l] = Math.abs(first[l]);
      leftOver[l] = before[l] == 0 ? 0 : Math.abs(last[l] / before[l]);
    }
  }

  /** Takes note that the first change was believed. */
  void believed() {
    for (int l = 0; l < usual.length; l++) {
      usual[l] = Math.min(usual[l], Math.abs(first[l]));
    }
  }

  /** Carries what is usual over. */
  void transfer(SavedState state) {
    state.numbers(usual);
    state.numbers(leftOver);
  }
}
