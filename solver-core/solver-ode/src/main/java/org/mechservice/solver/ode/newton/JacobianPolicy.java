package org.mechservice.solver.ode.newton;

import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.backward.BackwardDifferences;
import org.mechservice.solver.ode.step.ErrorNorm;

/**
 * When the derivatives of the equations are formed anew: they are kept from step to step, however
 * old, until an iteration fails and they are not those of the present point; where the matrix moves
 * with the state, until the iteration would be slow.
 */
public final class JacobianPolicy {
  private final StepEquations equations;
  private final NewtonMatrixFactors factors;
  private final MatrixDrift drift;

  /** Whether new derivatives are asked for, and whether those kept are of the present point. */
  private boolean wanted = true;

  private boolean current;

  /** Whether each of them is asked for, or was when they were formed last; or the matrix alone. */
  private boolean all = true;

  /** Norm of the derivatives, once asked for. */
  private double fastestRate;

  private boolean rateKnown;
  private long formations;

  JacobianPolicy(StepEquations equations, NewtonMatrixFactors factors) {
    this.equations = equations;
    this.factors = factors;
    drift = equations.drift();
  }

  /** Forgets all: the problem begins, or goes on from another state. */
  void beginAnew() {
    demandNew();
    current = false;
    drift.clear();
  }

  /** Asks for new derivatives, whatever is known. */
  public void demandNew() {
    wanted = true;
    all = true;
    factors.outdate();
  }

  /**
   * Evaluates the derivatives where the step starts if new ones are wanted.
   *
   * @param hGamma of the step; not asked for when none was tried yet
   */
  TrialOutcome form(double t, double[] y, double hGamma) {
    if (!wanted) {
      return TrialOutcome.PASSED;
    }
    TrialOutcome attempt =
        all ? equations.formDerivatives(t, y) : equations.formMatrix(t, y, hGamma);
    return formed(attempt, t);
  }

  /**
   * Returns whether derivatives are formed where steps will end, once there are steps: where the
   * matrix moves with the state, it is its change over the step that slows the iteration. Brenan,
   * Campbell and Petzold 1996, ch. 5.
   */
  public boolean lookAhead() {
    return drift.matters();
  }

  /** Returns whether that is to be done for a step that ends at {@code t}. */
  public boolean wantedAhead(double t) {
    return wanted || drift.slowAt(t);
  }

  /**
   * Evaluates the derivatives at the prediction of a step that ends at {@code t}. Where they are
   * not finite, those of a shorter step may be.
   */
  TrialOutcome formAhead(double t, double hGamma, BackwardDifferences differences) {
    TrialOutcome attempt = formed(equations.formAhead(t, hGamma, differences), t);
    wanted = attempt != TrialOutcome.PASSED;
    return attempt;
  }

  private TrialOutcome formed(TrialOutcome attempt, double t) {
    if (attempt == TrialOutcome.STOPPED) {
      return attempt;
    }
    wanted = false;
    current = true;
    formations++;
    drift.formed(t);
    rateKnown = false;
    if (attempt == TrialOutcome.PASSED) {
      factors.outdate();
    }
    return attempt;
  }

  /** Takes note that a step was accepted. */
  void moveOn() {
    current = false;
  }

  /** Asks for new derivatives unless they are of the present point; returns whether it did. */
  boolean renew() {
    if (current && all && drift.formedHere()) {
      return false;
    }
    all = current || !equations.formsMatrix();
    wanted = true;
    return true;
  }

  /** Returns how fast the solution can change at most, ‖∂f/∂y‖ as formed last. */
  public double fastestRate(ErrorNorm norm) {
    if (!rateKnown) {
      fastestRate = equations.normOfDerivatives(norm);
      rateKnown = true;
    }
    return fastestRate;
  }

  /** Returns how often they were formed. */
  public long formations() {
    return formations;
  }

  /** Carries the state between two steps over. */
  void transfer(SavedState state) {
    wanted = state.flag(wanted);
    all = state.flag(all);
    current = state.flag(current);
    formations = state.integer(formations);
    fastestRate = state.number(fastestRate);
    rateKnown = state.flag(rateKnown);
    drift.transfer(state);
    equations.transferDerivatives(state);
  }
}
