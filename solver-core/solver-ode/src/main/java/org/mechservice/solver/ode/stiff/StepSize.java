package org.mechservice.solver.ode.stiff;

import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.backward.BackwardDifferences;
import org.mechservice.solver.ode.newton.InitialStepSize;
import org.mechservice.solver.ode.newton.StepEquations;
import org.mechservice.solver.ode.step.ErrorNorm;
import org.mechservice.solver.ode.step.ExactEndBounds;

/**
 * Size of a stiff step: that of the first is chosen from what the solution does at the start, later
 * ones are proposed by the order control; all are bounded, and written into the differences.
 */
final class StepSize {
  private final ExactEndBounds bounds = new ExactEndBounds();
  private InitialStepSize firstStep = new InitialStepSize(0);

  /** End of the problem. */
  private double tEnd;

  /** Signed; 0 as long as the first is not chosen. */
  private double size;

  /** First step asked for; 0 for the method's choice. */
  private double asked;

  private double longestFirst;

  /** Whether the problem went on from another state, or across a declared jump. */
  private boolean restarted;

  /** Size and order that the differences are written for. */
  private double writtenSize;

  private int writtenOrder;

  /** Begins a problem. */
  void begin(int dimension, double t0, double tEnd, double maxStep) {
    this.tEnd = tEnd;
    firstStep = new InitialStepSize(dimension);
    bounds.begin(t0, tEnd, maxStep);
  }

  /**
   * Begins without history.
   *
   * @param asked size of the first step; 0 for the method's choice
   * @param restarted whether the problem goes on from another state
   */
  void beginAt(double asked, boolean restarted) {
    this.asked = asked;
    this.restarted = restarted;
    longestFirst = Double.POSITIVE_INFINITY;
    size = 0;
    writtenSize = 1;
    writtenOrder = 1;
  }

  /** Sets the longest size that the first step may have if the method chooses it. */
  void boundFirst(double longest) {
    longestFirst = longest;
  }

  /** Sets a place that no step passes. */
  void stopAt(double place) {
    bounds.stopAt(place);
  }

  /** Returns the size of the step being tried, signed. */
  double size() {
    return size;
  }

  /** Returns whether a size is chosen: no first step is due. */
  boolean chosen() {
    return size != 0;
  }

  /** Returns where that step ends. */
  double endOf(double t) {
    return bounds.endOf(t, size);
  }

  /** Returns whether the problem's end is at {@code t}. */
  boolean endsAt(double t) {
    return bounds.reachedAt(t);
  }

  /** Returns the largest that a step from {@code t} may be, signed. */
  private double longest(double t) {
    return bounds.bounded(t, Math.copySign(Double.MAX_VALUE, tEnd - t));
  }

  /**
   * Bounds the step that begins at {@code t}, the first one being chosen before; returns false if
   * told to stop instead.
   */
  boolean prepare(
      double t,
      StepEquations equations,
      BackwardDifferences differences,
      ErrorNorm norm,
      double relativeTolerance,
      ErrorAllowance allowance) {
    if (size == 0 && !chooseFirst(t, equations, differences, norm, relativeTolerance, allowance)) {
      return false;
    }
    size = bounded(t, size);
    return true;
  }

  /**
   * Returns the step to try instead of a proposed one. The smallest size grows with t; a step that
   * was at it and was accepted keeps its size, lest it change at every step and never be outgrown.
   */
  private double bounded(double t, double proposed) {
    double allowed = bounds.bounded(t, proposed);
    boolean raised = Math.abs(allowed) == bounds.smallest(t);
    return raised && proposed == writtenSize ? proposed : allowed;
  }

  private boolean chooseFirst(
      double t0,
      StepEquations equations,
      BackwardDifferences differences,
      ErrorNorm norm,
      double relativeTolerance,
      ErrorAllowance allowance) {
    double longest = longest(t0);
    double chosen = asked;
    if (chosen == 0) {
      double[] slope = differences.slope();
      double smallest = bounds.smallest(t0);
      double passing =
          firstStep.size(
              equations,
              t0,
              differences.state(),
              slope,
              norm,
              longest,
              smallest,
              relativeTolerance);
      if (passing == 0) {
        return false;
      }
      // The error of order 1 grows with the square of the step.
      double allowed = passing * Math.sqrt(allowance.part(passing, equations));
      double usual = equations.cautious(allowed, Math.abs(tEnd - t0));
      double first = restarted ? firstStep.afterRestart(usual, slope, norm) : usual;
      chosen = Math.max(smallest, Math.min(longestFirst, first));
    }
    size = Math.copySign(chosen, longest);
    return true;
  }

  /** Rewrites the differences if size or order has changed; returns whether it did. */
  boolean write(BackwardDifferences differences, int order) {
    if (size == writtenSize && order == writtenOrder) {
      return false;
    }
    differences.rescale(size / writtenSize, order);
    writtenSize = size;
    writtenOrder = order;
    return true;
  }

  /** Proposes a size for the next step. */
  void propose(double factor) {
    size *= factor;
  }

  /** Bounds the size proposed. */
  void bound(double longest) {
    size = Math.copySign(Math.min(Math.abs(size), longest), size);
  }

  /** Returns whether a step from {@code t} is not the smallest already. */
  boolean canBeReduced(double t) {
    return Math.abs(size) > bounds.smallest(t);
  }

  /** Reduces a step from {@code t} that failed. */
  void reduce(double factor, double t) {
    size = Math.copySign(Math.max(factor * Math.abs(size), bounds.smallest(t)), size);
  }

  /** Carries the state between two steps over. */
  void transfer(SavedState state) {
    size = state.number(size);
    asked = state.number(asked);
    restarted = state.flag(restarted);
    longestFirst = state.number(longestFirst);
    writtenSize = state.number(writtenSize);
    writtenOrder = state.integer(writtenOrder);
  }
}
