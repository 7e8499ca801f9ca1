package org.mechservice.solver.ode.newton;

import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.backward.BackwardDifferences;
import org.mechservice.solver.ode.step.ErrorNorm;

/**
 * When the derivatives of the equations are formed anew: they are kept from step to step, however
 * old, until an iteration fails and they are not those of the present point; where the matrix moves
 * with the state, until the iteration would be slow.
 *
 * <p>Beyond the published programs they are also renewed once the iterations that old ones have
 * cost add up to their price, which is at most twice the price of knowing beforehand; and they are
 * formed at the prediction of the step, as its solution is nearer to that than to its start.
 */
public final class JacobianPolicy {
  /** Rate from which on derivatives are blamed for changes after the first. */
  private static final double SLOW = 0.1;

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

  private boolean looksAhead;

  /** End of the step for which they were formed; NaN if they are of the start of one. */
  private double formedFor = Double.NaN;

  /** End of the step tried last. */
  private double triedEnd = Double.NaN;

  /** Changes that they have cost since they were formed. */
  private double spent;

  JacobianPolicy(StepEquations equations, NewtonMatrixFactors factors) {
    this.equations = equations;
    this.factors = factors;
    drift = equations.drift();
  }

  /** Goes by these rules from now on. */
  void follow(IterationRules rules) {
    looksAhead = rules.looksAhead();
  }

  /** Forgets all: the problem begins, or goes on from another state. */
  void beginAnew() {
    demandNew();
    current = false;
    formedFor = Double.NaN;
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
   * Returns whether derivatives are formed where steps will end, once there are steps: it is their
   * change over the step that slows the iteration, the more so where the matrix moves with the
   * state. Brenan, Campbell and Petzold 1996, ch. 5.
   */
  public boolean lookAhead() {
    return looksAhead || drift.matters();
  }

  /** Returns whether that is to be done for a step that ends at {@code t}. */
  public boolean wantedAhead(double t) {
    triedEnd = t;
    return wanted || drift.slowAt(t);
  }

  /**
   * Evaluates the derivatives at the prediction of a step that ends at {@code t}. Where they are
   * not finite, those of a shorter step may be.
   */
  TrialOutcome formAhead(double t, double hGamma, BackwardDifferences differences) {
    TrialOutcome attempt = formed(equations.formAhead(t, hGamma, differences), t);
    wanted = attempt != TrialOutcome.PASSED;
    formedFor = t;
    return attempt;
  }

  private TrialOutcome formed(TrialOutcome attempt, double t) {
    if (attempt == TrialOutcome.STOPPED) {
      return attempt;
    }
    wanted = false;
    current = true;
    formations++;
    spent = 0;
    drift.formed(t);
    rateKnown = false;
    if (attempt == TrialOutcome.PASSED) {
      factors.outdate();
    }
    return attempt;
  }

  /** Takes note of an iteration, how many changes it took and how they fell. */
  void iterated(int changes, double rate) {
    spent += rate > SLOW ? changes - 1 : 0;
  }

  /** Takes note that a step was accepted. */
  void moveOn() {
    current = false;
    if (looksAhead && spent >= equations.costOfDerivatives()) {
      demandNew();
    }
  }

  /** Asks for new derivatives unless they are of the present point; returns whether it did. */
  boolean renew() {
    if (current && all && formedHere()) {
      return false;
    }
    all = current || !equations.formsMatrix();
    wanted = true;
    return true;
  }

  /**
   * Returns whether they were formed for the step tried last. The drift alone does not know of a
   * shorter step that was not begun, since the matrix formed for the longer one is singular.
   */
  private boolean formedHere() {
    return drift.formedHere() && (Double.isNaN(formedFor) || formedFor == triedEnd);
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
    formedFor = state.number(formedFor);
    triedEnd = state.number(triedEnd);
    spent = state.number(spent);
    drift.transfer(state);
    equations.transferDerivatives(state);
  }
}
