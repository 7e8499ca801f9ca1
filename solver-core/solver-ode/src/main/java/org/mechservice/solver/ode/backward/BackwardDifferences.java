package org.mechservice.solver.ode.backward;

import java.util.Arrays;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.step.Manifold;

/**
 * State and backward differences of a stiff method, and what a step makes of them.
 *
 * <p>∇^m y_n = ∇^{m−1} y_n − ∇^{m−1} y_{n−1} over steps of size h describe the polynomial of degree
 * k through the last k + 1 points. A step with the correction d that the equations demand:
 *
 * <pre>
 * predict  y* = y_n + Σ_{m≤k} ∇^m y_n;  ψ = Σ_{m≤k} γ_m ∇^m y_n / ((1 − κ_k) γ_k)
 * correct  y_{n+1} = y* + d
 * accept   ∇^{k+2} = d − ∇^{k+1};  ∇^{k+1} = d;  ∇^m ← ∇^m + ∇^{m+1}, m = k … 1
 * </pre>
 *
 * <p>For another step size r h the same polynomial is written with other differences, D* = D (R(r)
 * U). Nothing accepted is overwritten before {@link #accept}, so a rejected or interrupted step
 * leaves no trace. Shampine and Reichelt 1997, §2.
 */
public final class BackwardDifferences implements Manifold.History {
  private static final int LENGTH = BackwardFormulas.HIGHEST_ORDER + 3;

  /** y*, length n. */
  public final double[] predicted;

  /** ψ, length n. */
  public final double[] psi;

  /** d, the backward difference of order k + 1 of y_{n+1}, length n. */
  public final double[] correction;

  private final RescalingMatrix rescaling = new RescalingMatrix();

  /** y_n and y_{n+1}, length n. */
  private double[] state;

  private double[] corrected;

  /** ∇^1 … ∇^{k+2} at the last accepted step, each of length n; counted from 1. */
  private double[][] accepted;

  /** Those of the step being tried: the same array until they are rescaled. */
  private double[][] tried;

  /** Stands for differences that are not in a formula: −0 changes no sum, not even one of −0. */
  private final double[] nothing;

  /** Where differences are rescaled to. */
  private double[][] spare;

  /**
   * @param dimension n
   */
  public BackwardDifferences(int dimension) {
    predicted = new double[dimension];
    psi = new double[dimension];
    correction = new double[dimension];
    state = new double[dimension];
    corrected = new double[dimension];
    accepted = new double[LENGTH][dimension];
    tried = accepted;
    spare = new double[LENGTH][dimension];
    nothing = new double[dimension];
    Arrays.fill(nothing, -0.0);
  }

  /** Forgets the history and places the state; {@link #slope} is to be written next. */
  public void begin(double[] y) {
    if (tried != accepted) {
      spare = tried;
      tried = accepted;
    }
    System.arraycopy(y, 0, state, 0, state.length);
    for (int m = 1; m < LENGTH; m++) {
      Arrays.fill(accepted[m], 0);
    }
  }

  /** Returns ∇y of the state just placed, which for h = 1 is its derivative; to be written. */
  public double[] slope() {
    return accepted[1];
  }

  /** Returns the state of the last accepted step; not to be modified. */
  public double[] state() {
    return state;
  }

  /** Returns the corrected state of the step being tried; not to be modified. */
  public double[] corrected() {
    return corrected;
  }

  /** Returns ∇^m at the last accepted step; not to be modified. */
  double[] accepted(int m) {
    return accepted[m];
  }

  /** Returns ∇^m as the step being tried has it; not to be modified. */
  double[] tried(int m) {
    return tried[m];
  }

  /**
   * Writes the differences of orders up to k for another step size.
   *
   * @param ratio new size over old
   */
  public void rescale(double ratio, int k) {
    double[][] target = tried == accepted ? spare : tried;
    rescaling.prepare(ratio, k);
    for (int m = 1; m <= k; m++) {
      rescaleInto(target[m], m, k);
    }
    if (tried == accepted) {
      System.arraycopy(accepted[k + 1], 0, target[k + 1], 0, state.length);
      tried = target;
    }
  }

  /**
   * A difference depends on those of its own and higher orders only: the target may be D itself.
   */
  private void rescaleInto(double[] target, int m, int k) {
    double[] d0 = tried[m];
    double[] d1 = ofFormula(m + 1, k);
    double[] d2 = ofFormula(m + 2, k);
    double[] d3 = ofFormula(m + 3, k);
    double[] d4 = ofFormula(m + 4, k);
    double own = rescaling.element(m, m);
    double other1 = rescaling.element(m + 1, m);
    double other2 = rescaling.element(m + 2, m);
    double other3 = rescaling.element(m + 3, m);
    double other4 = rescaling.element(m + 4, m);
    for (int l = 0; l < target.length; l++) {
      target[l] = own * d0[l] + other1 * d1[l] + other2 * d2[l] + other3 * d3[l] + other4 * d4[l];
    }
  }

  /**
   * Forms y* and ψ; the iteration starts from d = 0. All is done in one pass: in small systems the
   * passes cost more than the sums. These begin with 0, and so are never −0.
   */
  public void predict(int k, BackwardFormulas formulas) {
    double[] d1 = tried[1];
    double[] d2 = ofFormula(2, k);
    double[] d3 = ofFormula(3, k);
    double[] d4 = ofFormula(4, k);
    double[] d5 = ofFormula(5, k);
    double share1 = formulas.share(1, k);
    double share2 = formulas.share(2, k);
    double share3 = formulas.share(3, k);
    double share4 = formulas.share(4, k);
    double share5 = formulas.share(5, k);
    for (int l = 0; l < predicted.length; l++) {
      double start = 0 + d1[l] + d2[l] + d3[l] + d4[l] + d5[l] + state[l];
      double shares =
          0 + share1 * d1[l] + share2 * d2[l] + share3 * d3[l] + share4 * d4[l] + share5 * d5[l];
      predicted[l] = start;
      corrected[l] = start;
      correction[l] = 0;
      psi[l] = shares;
    }
  }

  /** Returns ∇^m of the step being tried if a formula of order k has it. */
  private double[] ofFormula(int m, int k) {
    return m <= k ? tried[m] : nothing;
  }

  /**
   * Lets the iteration start from a prediction of lower order in one component, whose differences
   * of higher order are mostly noise.
   *
   * @param highest of the differences to go by
   * @param k order of the step
   */
  public void predictLower(int component, int highest, int k) {
    for (int m = highest + 1; m <= k; m++) {
      correction[component] -= tried[m][component];
    }
    corrected[component] = predicted[component] + correction[component];
  }

  /** Adds to d and y_{n+1}. */
  public void correct(double[] change) {
    for (int l = 0; l < change.length; l++) {
      correction[l] += change[l];
      corrected[l] = predicted[l] + correction[l];
    }
  }

  /** Takes over a corrected state that was changed from outside: d becomes y_{n+1} − y*. */
  public void takeOverCorrected() {
    for (int l = 0; l < correction.length; l++) {
      if (corrected[l] != predicted[l] + correction[l]) {
        correction[l] = corrected[l] - predicted[l];
      }
    }
  }

  /** {@inheritDoc} All differences of the accepted state have the factor too. */
  @Override
  public void scale(int start, int size, double factor) {
    for (int l = start; l < start + size; l++) {
      state[l] *= factor;
      for (int m = 1; m < LENGTH; m++) {
        accepted[m][l] *= factor;
      }
    }
  }

  /** Accepts the corrected state and forms its differences up to order k + 2. */
  public void accept(int k) {
    if (k < 3) {
      takeUpCorrection(tried[k + 2], tried[k + 1], tried[k]);
    } else {
      takeUpCorrection(tried[k + 2], tried[k + 1], tried[k], tried[k - 1], tried[k - 2]);
    }
    if (k == 5) {
      raiseTwo(tried[1], tried[2], tried[3]);
    } else if (k == 2 || k == 4) {
      raise(tried[1], tried[2]);
    }
    if (tried != accepted) {
      spare = accepted;
      accepted = tried;
    }
    double[] freed = state;
    state = corrected;
    corrected = freed;
  }

  /** Forms the differences of orders k + 2, k + 1 and k in one pass. */
  private void takeUpCorrection(double[] afterNext, double[] next, double[] difference) {
    for (int l = 0; l < correction.length; l++) {
      double newest = correction[l];
      afterNext[l] = newest - next[l];
      next[l] = newest;
      difference[l] += newest;
    }
  }

  /** Forms those of orders k + 2 to k − 2. */
  private void takeUpCorrection(
      double[] afterNext, double[] next, double[] difference, double[] below, double[] lowest) {
    for (int l = 0; l < correction.length; l++) {
      double newest = correction[l];
      afterNext[l] = newest - next[l];
      next[l] = newest;
      double raised = difference[l] + newest;
      difference[l] = raised;
      raised += below[l];
      below[l] = raised;
      lowest[l] += raised;
    }
  }

  private static void raise(double[] difference, double[] above) {
    for (int l = 0; l < difference.length; l++) {
      difference[l] += above[l];
    }
  }

  private static void raiseTwo(double[] below, double[] difference, double[] above) {
    for (int l = 0; l < difference.length; l++) {
      double raised = difference[l] + above[l];
      difference[l] = raised;
      below[l] += raised;
    }
  }

  /** Carries the state between two steps over. */
  public void transfer(SavedState state) {
    state.numbers(this.state);
    state.numbers(accepted);
    state.numbers(correction);
    state.numbers(predicted);
    state.numbers(psi);
    if (state.restoring()) {
      tried = accepted;
    }
  }
}
