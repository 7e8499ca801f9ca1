package org.mechservice.solver.ode.newton;

import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.TrialOutcome;

/**
 * The factors of the iteration matrix: kept as long as step, order and derivatives stay what they
 * are, or nearly so where the rules of the iteration allow that.
 */
public final class NewtonMatrixFactors {
  private final StepEquations equations;

  private IterationRules rules = IterationRules.PUBLISHED;

  /** Whether there are factors with the present derivatives, and whether h or k has changed. */
  private boolean formed;

  private boolean stepChanged;

  /** That of the matrix factored last. */
  private double formedHGamma;

  private long factorisations;
  private long solutions;

  NewtonMatrixFactors(StepEquations equations) {
    this.equations = equations;
  }

  /** Goes by these rules from now on. */
  void follow(IterationRules rules) {
    this.rules = rules;
  }

  /** Takes note that the derivatives are others now. */
  void outdate() {
    formed = false;
  }

  /** Takes note that h or k has changed. */
  public void changeStep() {
    stepChanged = true;
  }

  /** Outdates factors that are not those of the present step; returns whether there were any. */
  boolean outdateUnlessOf(double hGamma) {
    boolean others = formed && hGamma != formedHGamma;
    formed = formed && !others;
    return others;
  }

  /** Factors the matrix for an iteration unless there are factors that will do. */
  TrialOutcome factor(double hGamma, NewtonIteration newton) {
    if (formed && (!stepChanged || close(hGamma, newton))) {
      stepChanged = false;
      return TrialOutcome.PASSED;
    }
    stepChanged = false;
    if (formed && rules.keepsRate()) {
      // With the same derivatives, the iteration errs by hγ times what they are off.
      newton.expectGrowth(Math.max(1, hGamma / formedHGamma));
    } else {
      newton.forgetRate();
    }
    formed = factorAnew(hGamma);
    return formed ? TrialOutcome.PASSED : TrialOutcome.SINGULAR_MATRIX;
  }

  /** Returns whether the matrix has hardly changed; then the iteration is the slower for it. */
  private boolean close(double hGamma, NewtonIteration newton) {
    double change = Math.abs(hGamma / formedHGamma - 1);
    if (!(change <= rules.closeRatio())) {
      return false;
    }
    newton.expectRate(change / (1 + hGamma / formedHGamma));
    return true;
  }

  /** Factors the matrix, for another use than the next iteration; returns whether it is regular. */
  boolean factorAnew(double hGamma) {
    formed = false;
    formedHGamma = hGamma;
    factorisations++;
    return equations.formFactors(hGamma);
  }

  /** Solves one system of linear equations in place. */
  void solve(double hGamma, double[] residual) {
    equations.substitute(hGamma, residual);
    solutions++;
    if (hGamma != formedHGamma) {
      double part = 2 / (1 + hGamma / formedHGamma);
      for (int l = 0; l < residual.length; l++) {
        residual[l] *= part;
      }
    }
  }

  /** Returns how often the matrix was factored. */
  public long factorisations() {
    return factorisations;
  }

  /** Returns how many systems were solved with it. */
  public long solutions() {
    return solutions;
  }

  /** Carries the state between two steps over, but for the factors themselves. */
  void transfer(SavedState state) {
    formed = state.flag(formed);
    stepChanged = state.flag(stepChanged);
    formedHGamma = state.number(formedHGamma);
    factorisations = state.integer(factorisations);
    solutions = state.integer(solutions);
  }

  /** Forms the factors that there were when the state was saved. */
  void restore() {
    if (formed) {
      equations.formFactors(formedHGamma);
    }
  }
}
