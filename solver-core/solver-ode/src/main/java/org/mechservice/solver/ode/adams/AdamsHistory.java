package org.mechservice.solver.ode.adams;

import java.util.Arrays;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.step.ErrorNorm;
import org.mechservice.solver.ode.step.Manifold;

/**
 * State and modified divided differences of an Adams method, and what a step makes of them.
 *
 * <p>φ_1 = y'_n, and φ_i belongs to the i-th divided difference of y' over the last i points,
 * scaled by the steps between them. A step from (t, y) with the coefficients β, g of {@link
 * AdamsCoefficients}:
 *
 * <pre>
 * predict   φ*_i = β_i φ_i;  p = y + h Σ_{i≤k} g_i φ*_i;  φ^p_i = Σ_{j=i..k} φ*_j
 * evaluate  d = f(t + h, p) − φ^p_1
 * correct   y ← p + h g_{k+1} d                      one order higher: local extrapolation
 * carry     round-off of y, unless y was moved meanwhile
 * evaluate  φ_{k+1} = f(t + h, y) − φ^p_1;  φ_i = φ^p_i + φ_{k+1}, i ≤ k
 * </pre>
 *
 * <p>Nothing accepted is overwritten before {@link #accept}, so a rejected or interrupted step
 * leaves no trace. On request the round-off of the two sums that give p and y is carried along from
 * step to step (Shampine and Gordon 1975, ch. 9; it matters near the limits of the arithmetic).
 */
final class AdamsHistory implements Manifold.History {
  private static final int LENGTH = AdamsCoefficients.HIGHEST_ORDER + 3;

  /** Prediction p at the end of the step being tried, length n. */
  final double[] predicted;

  /** f of the last evaluation, length n; written by the owner before the next stage. */
  final double[] derivative;

  /** d, the discrepancy between f at the prediction and its extrapolation, length n. */
  final double[] discrepancy;

  /** φ_1 … φ_14 of the last accepted step, each of length n; counted from 1. */
  private final double[][] differences;

  /** φ^p_1 … φ^p_{k+2} of the step being tried, each of length n; counted from 1. */
  private final double[][] extrapolated;

  /** State at the last accepted step, length n, and the round-off it carries. */
  private double[] state;

  private double[] stateCarry;

  /** Corrected state of the step being tried, length n, and the round-off it carries. */
  private double[] corrected;

  private double[] correctedCarry;

  /** Round-off of p, length n. */
  private final double[] predictedCarry;

  private final boolean compensated;

  /**
   * @param dimension n
   * @param compensated whether to carry the round-off along
   */
  AdamsHistory(int dimension, boolean compensated) {
    this.compensated = compensated;
    predicted = new double[dimension];
    derivative = new double[dimension];
    discrepancy = new double[dimension];
    differences = new double[LENGTH][dimension];
    extrapolated = new double[LENGTH][dimension];
    state = new double[dimension];
    stateCarry = new double[dimension];
    corrected = new double[dimension];
    correctedCarry = new double[dimension];
    predictedCarry = new double[dimension];
  }

  /** Returns whether the round-off is carried along. */
  boolean compensated() {
    return compensated;
  }

  /** Forgets the history and places the state; the derivative is to be written next. */
  void begin(double[] y) {
    System.arraycopy(y, 0, state, 0, state.length);
    Arrays.fill(stateCarry, 0);
  }

  /** Takes the derivative for that of the state just placed: φ_1 = y'. */
  void beginDerivative() {
    System.arraycopy(derivative, 0, differences[1], 0, derivative.length);
    Arrays.fill(differences[2], 0);
  }

  /** Returns the state of the last accepted step; not to be modified. */
  double[] state() {
    return state;
  }

  /** Returns the corrected state of the step being tried; not to be modified. */
  double[] corrected() {
    return corrected;
  }

  /** Returns φ_i of the last accepted step; not to be modified. */
  double[] difference(int i) {
    return differences[i];
  }

  /** Forms p and φ^p. */
  void predict(double h, int k, double[] beta, double[] g) {
    beginSums(k, beta[k], g[k]);
    int i = k - 1;
    for (; i > 1; i -= 2) {
      addTwoTerms(i, beta, g);
    }
    if (i == 1) {
      addTerm(i, beta[i], g[i]);
    }
    if (compensated) {
      addIncrementCompensated(h);
    } else {
      addIncrement(h);
    }
  }

  /** The first term of both sums: φ^p_k = φ*_k and p = g_k φ*_k. */
  private void beginSums(int k, double beta, double g) {
    double[] difference = differences[k];
    double[] sum = extrapolated[k];
    double[] p = predicted;
    for (int l = 0; l < p.length; l++) {
      double rescaled = beta * difference[l];
      p[l] = g * rescaled;
      sum[l] = rescaled;
    }
  }

  /** One term of both sums: φ^p_i = φ^p_{i+1} + φ*_i and p = p + g_i φ*_i. */
  private void addTerm(int i, double beta, double g) {
    double[] difference = differences[i];
    double[] above = extrapolated[i + 1];
    double[] sum = extrapolated[i];
    double[] p = predicted;
    for (int l = 0; l < p.length; l++) {
      double rescaled = beta * difference[l];
      p[l] += g * rescaled;
      sum[l] = above[l] + rescaled;
    }
  }

  /** The terms i and i − 1 in one pass: for few components it takes longer to begin than to do. */
  private void addTwoTerms(int i, double[] beta, double[] g) {
    double[] first = differences[i];
    double[] second = differences[i - 1];
    double[] above = extrapolated[i + 1];
    double[] firstSum = extrapolated[i];
    double[] secondSum = extrapolated[i - 1];
    double[] p = predicted;
    double beta1 = beta[i];
    double beta2 = beta[i - 1];
    double g1 = g[i];
    double g2 = g[i - 1];
    for (int l = 0; l < p.length; l++) {
      double rescaled1 = beta1 * first[l];
      double rescaled2 = beta2 * second[l];
      p[l] = p[l] + g1 * rescaled1 + g2 * rescaled2;
      firstSum[l] = above[l] + rescaled1;
      secondSum[l] = firstSum[l] + rescaled2;
    }
  }

  private void addIncrement(double h) {
    for (int l = 0; l < predicted.length; l++) {
      predicted[l] = state[l] + h * predicted[l];
    }
  }

  private void addIncrementCompensated(double h) {
    for (int l = 0; l < predicted.length; l++) {
      double increment = h * predicted[l] - stateCarry[l];
      predicted[l] = state[l] + increment;
      predictedCarry[l] = (predicted[l] - state[l]) - increment;
    }
  }

  /** Forms d from f at the prediction. */
  void compareDerivative() {
    double[] foreseen = extrapolated[1];
    for (int l = 0; l < discrepancy.length; l++) {
      discrepancy[l] = derivative[l] - foreseen[l];
    }
  }

  /** Returns the derivative at the end of the step as it was extrapolated; not to be modified. */
  double[] foreseen() {
    return extrapolated[1];
  }

  /** Returns ‖φ^p_i + d‖, the discrepancy as a formula of order i − 1 would have had it. */
  double discrepancyNorm(ErrorNorm norm, int i) {
    return norm.ofSum(extrapolated[i], discrepancy);
  }

  /** Forms the corrected state; {@code weight} is h g_{k+1}. */
  void correct(double weight) {
    // Without compensation the carry stays 0.
    for (int l = 0; l < corrected.length; l++) {
      corrected[l] = predicted[l] + (weight * discrepancy[l] - predictedCarry[l]);
    }
  }

  /** Keeps the round-off of the corrected state, of those components that were not moved since. */
  void carry(double weight) {
    if (!compensated) {
      return;
    }
    for (int l = 0; l < corrected.length; l++) {
      double increment = weight * discrepancy[l] - predictedCarry[l];
      boolean moved = corrected[l] != predicted[l] + increment;
      correctedCarry[l] = moved ? 0 : (corrected[l] - predicted[l]) - increment;
    }
  }

  /** Accepts the corrected state and forms φ_1 … φ_{k+2} from f there. */
  void accept(int k) {
    double[] change = differences[k + 1];
    takeChange(change, differences[k + 2]);
    int i = k;
    for (; i > 1; i -= 2) {
      addToTwo(i, change);
    }
    if (i == 1) {
      addToFirst(change);
    }
    double[] freed = state;
    state = corrected;
    corrected = freed;
    if (compensated) {
      double[] freedCarry = stateCarry;
      stateCarry = correctedCarry;
      correctedCarry = freedCarry;
    }
  }

  /** {@inheritDoc} All differences of the accepted state have the factor too. */
  @Override
  public void scale(int start, int size, double factor) {
    for (int l = start; l < start + size; l++) {
      state[l] *= factor;
      stateCarry[l] *= factor;
      derivative[l] *= factor;
      for (int i = 1; i < LENGTH; i++) {
        differences[i][l] *= factor;
      }
    }
  }

  /** Forms φ_{k+1} and φ_{k+2} of the one before it. */
  private void takeChange(double[] change, double[] changeOfChange) {
    double[] foreseen = extrapolated[1];
    for (int l = 0; l < change.length; l++) {
      double latest = derivative[l] - foreseen[l];
      changeOfChange[l] = latest - change[l];
      change[l] = latest;
    }
  }

  /** Forms φ_i and φ_{i−1} in one pass. */
  private void addToTwo(int i, double[] change) {
    double[] first = extrapolated[i];
    double[] second = extrapolated[i - 1];
    double[] firstSum = differences[i];
    double[] secondSum = differences[i - 1];
    for (int l = 0; l < change.length; l++) {
      firstSum[l] = first[l] + change[l];
      secondSum[l] = second[l] + change[l];
    }
  }

  /** Forms φ_1. */
  private void addToFirst(double[] change) {
    double[] first = extrapolated[1];
    double[] sum = differences[1];
    for (int l = 0; l < change.length; l++) {
      sum[l] = first[l] + change[l];
    }
  }

  /** Carries the state between two steps over. */
  void transfer(SavedState state) {
    state.numbers(this.state);
    state.numbers(stateCarry);
    state.numbers(derivative);
    state.numbers(discrepancy);
    state.numbers(differences);
    state.numbers(extrapolated);
  }
}
