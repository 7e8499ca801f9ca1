package org.mechservice.solver.ode.newton;

import java.util.Optional;
import org.mechservice.solver.ode.IntegrationFailure.Cause;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.backward.BackwardDifferences;
import org.mechservice.solver.ode.step.Breakpoints;
import org.mechservice.solver.ode.step.ErrorNorm;
import org.mechservice.solver.ode.step.Manifold;
import org.mechservice.solver.ode.step.RightHandSide;

/**
 * The equations that an implicit step has to solve: what the form of a problem, explicit or
 * residual, makes of its start, of its derivatives, and of the matrix and the right-hand side of
 * the iteration. {@link StepSolver} solves them; derivatives and factors are kept here from step to
 * step.
 */
public abstract class StepEquations {
  /**
   * What rounding may leave of equations, relative to the size of their terms: these are computed
   * in many operations, and on closed loops from states found by an iteration of their own.
   */
  static final double ROUNDOFF_OF_TERMS = 1e4 * Math.ulp(1.0);

  private static final double GOLDEN_RATIO = 0.6180339887498949;

  private final Manifold manifold;
  private final MatrixDrift drift;
  private final NewtonMatrixFactors factors;
  private final JacobianPolicy derivatives;

  StepEquations(Manifold manifold, MatrixDrift drift) {
    this.manifold = manifold;
    this.drift = drift;
    factors = new NewtonMatrixFactors(this);
    derivatives = new JacobianPolicy(this, factors);
  }

  /** Stands in until a problem is given. */
  public static StepEquations none() {
    return new ExplicitEquations(RightHandSide.none(), new double[0], false);
  }

  public final Manifold manifold() {
    return manifold;
  }

  /** Returns how the matrix moves with the state. */
  final MatrixDrift drift() {
    return drift;
  }

  /** Returns the factors of the matrix as they are kept. */
  public final NewtonMatrixFactors factors() {
    return factors;
  }

  /** Returns the derivatives as they are kept. */
  public final JacobianPolicy derivatives() {
    return derivatives;
  }

  /** Returns the places at which the equations jump. */
  public abstract Breakpoints breakpoints();

  /** Returns f, if the problem has the explicit form y' = f(t, y). */
  public abstract Optional<RightHandSide> rightHandSide();

  /** Has the columns of derivatives by differences looked at. */
  public abstract void testColumns(ColumnTest.Maker tests);

  /** Returns whether the stop signal is given. */
  public abstract boolean stopped();

  /** Forgets whatever was stopped: the problem begins, or goes on from another state. */
  abstract void abandon();

  /**
   * Finds what is not given of state and derivative where a problem begins or goes on anew.
   *
   * @param y state; completed
   * @param slope its derivative; overwritten
   */
  public abstract TrialOutcome findStart(double t, double[] y, double[] slope);

  /** Takes note that the next start follows a change of the state from outside. */
  public void stateChanged() {}

  /** Returns what to call a failure of {@link #findStart}. */
  public abstract Cause causeAtStart(TrialOutcome attempt);

  /** Returns the component to name in it; −1 if there is none. */
  public abstract int componentAtStart(TrialOutcome attempt);

  /** Evaluates the derivatives at the start of the step. */
  abstract TrialOutcome formDerivatives(double t, double[] y);

  /**
   * Returns the iterations that cost as much as new derivatives; infinite if these are kept until
   * an iteration fails.
   */
  double costOfDerivatives() {
    return Double.POSITIVE_INFINITY;
  }

  /** Evaluates the derivatives at the prediction of a step that ends at {@code t}. */
  abstract TrialOutcome formAhead(double t, double hGamma, BackwardDifferences differences);

  /** Returns whether {@link #formMatrix} is cheaper than that. */
  abstract boolean formsMatrix();

  /** Brings the matrix of the iteration, but not each of its parts, up to date. */
  abstract TrialOutcome formMatrix(double t, double[] y, double hGamma);

  /** Factors the matrix of the iteration; returns whether it is regular. */
  abstract boolean formFactors(double hGamma);

  /** Returns the column, and so the component, at which the last factorisation failed. */
  abstract int singularComponent();

  /** Returns an estimate of the reciprocal condition of the matrix; 1 if nothing is known of it. */
  abstract double reciprocalCondition();

  /**
   * Evaluates what is left of the equations at the corrected state, as the right-hand side of the
   * iteration; 0 for passive components.
   *
   * @return false if told to stop instead
   */
  abstract boolean evaluate(
      double t, double hGamma, BackwardDifferences differences, double[] residual);

  /** Solves for the change of the correction, in place; it is 0 in passive components. */
  abstract void substitute(double hGamma, double[] residual);

  /** Returns the component that made the derivatives not finite; −1 if none can be named. */
  abstract int notFiniteInDerivatives();

  /** Returns the component that made the last evaluation not finite; −1 if none did. */
  abstract int notFiniteInEvaluation();

  /**
   * Returns whether each of the equations is solved better than before, or so well that a small
   * change of the state would solve it if f did not depend on that.
   *
   * @param before what was left of the equations before, as {@link #evaluate} gives it
   * @param part of that which may be left at most
   * @param left what is left of them
   * @param small norm of a change that is small
   */
  abstract boolean better(
      double hGamma, double[] before, double part, double[] left, ErrorNorm norm, double small);

  /**
   * Returns whether it is known without further work that what is left of the equations, or parts
   * of it, is as little as {@link #better} asks for.
   */
  boolean slight(double[] left, ErrorNorm norm, double small) {
    return false;
  }

  /**
   * Returns a component moved by some rounding errors: of either sign and no two by like parts, so
   * that differences of components move, too.
   */
  static double movedByRounding(double[] y, int l) {
    return y[l] + ROUNDOFF_OF_TERMS * (1 - 2 * ((l + 1) * GOLDEN_RATIO % 1)) * y[l];
  }

  /** Returns whether what {@link #better} found left over last is made of rounding errors. */
  abstract boolean leftByRounding(double hGamma, BackwardDifferences differences);

  /**
   * Returns how far, in units of the tolerance, the rounding errors of the equations move the
   * solution of a step; 0 if nothing is known of them. Factors the matrix of that step.
   */
  abstract double roundOff(double hGamma, ErrorNorm norm);

  /**
   * Estimates y'' at the start of the problem.
   *
   * @param slope y' there; not modified
   * @param h a step that changes y little, signed
   * @param curvature overwritten
   * @return false if told to stop instead
   */
  abstract boolean curvature(double t0, double[] y0, double[] slope, double h, double[] curvature);

  /**
   * Returns the size of the first step.
   *
   * @param passing for which the estimated error just passes
   * @param interval how far it is to the end, positive
   */
  public abstract double cautious(double passing, double interval);

  /** Returns how often the right-hand side or residual was evaluated. */
  public abstract long evaluations();

  /** Carries over what is known of the derivatives, and the problem's own state. */
  abstract void transferDerivatives(SavedState state);

  /** Takes note of the solution of an accepted step. */
  abstract void solved(double hGamma, BackwardDifferences differences);

  /** Returns ‖∂f/∂y‖ as formed last; 0 if nothing is known of it. */
  abstract double normOfDerivatives(ErrorNorm norm);

  /**
   * Returns the largest magnitude of an eigenvalue of ∂f/∂y as formed last, estimated; infinite if
   * nothing is known of it.
   */
  public abstract double fastestMotion();

  /** Returns whether the fastest motion is a decay or a growth, not an oscillation. */
  public abstract boolean fastestIsExponential();

  /**
   * Returns whether steps are better proposed shorter than by the published program. In residual
   * form that costs mechanisms with multipliers more steps than it spares rejections.
   */
  public abstract boolean allowsCaution();

  /** Returns |λ| of the fastest motion λ if that is a damped oscillation; 0 if it is none. */
  public abstract double rateOfFastest();

  /** Returns the damping ratio of the fastest motion; 0 if it is no damped oscillation. */
  public abstract double dampingOfFastest();

  /** Returns the rules by which steps are solved in a mode. */
  abstract IterationRules rules(Mode mode);
}
