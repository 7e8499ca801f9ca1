package org.mechservice.solver.ode.newton;

import org.mechservice.solver.ode.IntegrationFailure.Cause;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.backward.BackwardDifferences;
import org.mechservice.solver.ode.step.ErrorNorm;
import org.mechservice.solver.ode.step.Manifold;
import org.mechservice.solver.ode.step.RightHandSide;

/**
 * Solves the equations of a step: derivatives, factors, iteration, and what the solution has to
 * pass besides. It finds out what to renew when that fails, and what to call a failure that nothing
 * mends. Whatever was stopped is taken up where it stood.
 */
public final class StepSolver {
  /** Rounding errors, in units of the tolerance, that can keep a step from passing its tests. */
  private static final double FELT_ROUND_OFF = 0.1;

  /**
   * Part of the interval that a step may have which is not short. In short ones all equations look
   * as if they were exact to few digits that determine less than they should.
   */
  private static final double USUAL_PART = 1e-3;

  /**
   * Highest difference by which algebraic components are predicted. They are in no test, so the
   * iteration leaves an error in them, which the fifth differences would enlarge 32 times.
   */
  private static final int HIGHEST_OF_ALGEBRAIC = 4;

  /** Steps at whose end the equations are evaluated, after a try that was not finite. */
  private static final int STEPS_CHECKED = 10;

  private final StepEquations equations;
  private final Manifold manifold;
  private final MatrixDrift drift;
  private final JacobianPolicy derivatives;
  private final NewtonMatrixFactors factors;
  private final NewtonIteration newton;
  private final IterationRules rules;

  /** Steps whose end is still to be evaluated, whether that was stopped, and what it gave. */
  private int stepsToCheck;

  private boolean checking;
  private final double[] checked;

  private int notFiniteComponent = -1;

  public StepSolver(StepEquations equations, Mode mode) {
    this.equations = equations;
    manifold = equations.manifold();
    drift = equations.drift();
    derivatives = equations.derivatives();
    factors = equations.factors();
    rules = equations.rules(mode);
    factors.follow(rules);
    derivatives.follow(rules);
    newton = new NewtonIteration(manifold.dimension(), rules);
    checked = new double[manifold.dimension()];
  }

  /** Makes ready to find the start and then to step from there. */
  public void beginAnew() {
    derivatives.beginAnew();
    newton.abandon();
    checking = false;
    equations.abandon();
  }

  /**
   * Brings the derivatives to the start of the step if new ones are wanted.
   *
   * @param hGamma of the step; not asked for when none was tried yet
   */
  public TrialOutcome linearise(double t, double[] y, double hGamma) {
    return lineariseWith(derivatives.form(t, y, hGamma));
  }

  /** Brings the derivatives to the prediction of a step that ends at {@code t}. */
  public TrialOutcome lineariseAhead(double t, double hGamma, BackwardDifferences differences) {
    return lineariseWith(derivatives.formAhead(t, hGamma, differences));
  }

  private TrialOutcome lineariseWith(TrialOutcome attempt) {
    if (attempt == TrialOutcome.NOT_FINITE) {
      notFiniteComponent = equations.notFiniteInDerivatives();
    }
    return attempt;
  }

  /** Factors the matrix unless there are factors that will do. */
  public TrialOutcome factor(double hGamma) {
    return factors.factor(hGamma, newton);
  }

  /** Returns whether an iteration is under way that was stopped. */
  public boolean begun() {
    return newton.begun() || checking;
  }

  /** Begins to iterate at the prediction of a step of order k that ends at {@code t}. */
  public void begin(double t, BackwardDifferences differences, int k, ErrorNorm norm) {
    newton.expectGrowth(drift.moveTo(t));
    newton.begin(differences, norm);
    if (manifold.anyAlgebraic() && rules.heedsRoundOff()) {
      for (int l = 0; l < manifold.dimension(); l++) {
        if (manifold.algebraic(l)) {
          differences.predictLower(l, HIGHEST_OF_ALGEBRAIC, k);
        }
      }
    }
  }

  /**
   * Iterates for the correction of a step that ends at {@code t}, then moves the state onto the
   * manifold of the system.
   */
  public TrialOutcome solve(
      double t, double hGamma, BackwardDifferences differences, ErrorNorm norm) {
    if (!checking) {
      TrialOutcome attempt = iterate(t, hGamma, differences, norm);
      if (attempt != TrialOutcome.PASSED || stepsToCheck == 0) {
        return attempt;
      }
    }
    checking = !equations.evaluate(t, hGamma, differences, checked);
    if (checking) {
      return TrialOutcome.STOPPED;
    }
    notFiniteComponent = equations.notFiniteInEvaluation();
    return finite();
  }

  private TrialOutcome iterate(
      double t, double hGamma, BackwardDifferences differences, ErrorNorm norm) {
    TrialOutcome attempt = newton.iterate(equations, t, hGamma, differences, norm);
    if (newton.rateSeen() > 0 && attempt != TrialOutcome.STOPPED) {
      drift.learn(newton.rateSeen());
      derivatives.iterated(newton.changes(), newton.rateSeen());
    }
    if (attempt == TrialOutcome.NOT_FINITE) {
      notFiniteComponent = newton.notFiniteComponent(equations);
      beginToCheck();
    }
    if (attempt != TrialOutcome.PASSED) {
      return attempt;
    }
    if (manifold.changesStates()) {
      if (!manifold.project(t, differences.corrected())) {
        return TrialOutcome.NOT_COMPLETED;
      }
      differences.takeOverCorrected();
    }
    notFiniteComponent = RightHandSide.firstNotFinite(differences.corrected());
    return finite();
  }

  /** Returns the norm of the correction found, which is often a single change. */
  public double sizeOfCorrection(BackwardDifferences differences, ErrorNorm norm) {
    boolean oneChange =
        newton.changes() == 1 && !manifold.anyAlgebraic() && !manifold.changesStates();
    return oneChange ? newton.size() : norm.of(differences.correction);
  }

  private TrialOutcome finite() {
    return notFiniteComponent < 0 ? TrialOutcome.PASSED : TrialOutcome.NOT_FINITE;
  }

  /**
   * The problem may be defined only on one side of a place near by: the last iterate is a guess.
   */
  private void beginToCheck() {
    stepsToCheck = rules.heedsRoundOff() ? STEPS_CHECKED : 0;
  }

  /** Takes note that a step was accepted. */
  public void moveOn(double hGamma, BackwardDifferences differences) {
    derivatives.moveOn();
    stepsToCheck = Math.max(0, stepsToCheck - 1);
    equations.solved(hGamma, differences);
  }

  /**
   * Asks for new factors unless they are those of the present step, else for new derivatives unless
   * they are of the present point; returns whether it did.
   */
  public boolean renew(double hGamma) {
    return factors.outdateUnlessOf(hGamma) || derivatives.renew();
  }

  /**
   * Returns what to call a failure that no step size mends.
   *
   * @param interval of the problem, signed
   */
  public Cause cause(TrialOutcome attempt, double interval, ErrorNorm norm) {
    boolean solvable =
        attempt == TrialOutcome.TOO_INACCURATE || attempt == TrialOutcome.NOT_CONVERGING;
    if (!solvable) {
      return attempt.cause();
    }
    boolean singular = equations.reciprocalCondition() < Math.ulp(1.0);
    if (equations.roundOff(USUAL_PART * interval, norm) > FELT_ROUND_OFF) {
      return Cause.TOLERANCE_TOO_TIGHT;
    }
    return singular && attempt == TrialOutcome.NOT_CONVERGING
        ? Cause.SINGULAR_MATRIX
        : attempt.cause();
  }

  /** Returns the component that made the equations fail. */
  public int limitingComponent(TrialOutcome attempt, ErrorNorm norm) {
    return switch (attempt) {
      case NOT_FINITE -> notFiniteComponent;
      case SINGULAR_MATRIX -> equations.singularComponent();
      case NOT_COMPLETED -> -1;
      default -> norm.largest(newton.change());
    };
  }

  /** Carries the state between two steps over; the factors are formed anew. */
  public void transfer(SavedState state) {
    stepsToCheck = state.integer(stepsToCheck);
    newton.transfer(state);
    derivatives.transfer(state);
    factors.transfer(state);
    if (state.restoring()) {
      factors.restore();
    }
  }
}
