package org.mechservice.solver.ode;

import org.mechservice.solver.ode.IntegrationFailure.Cause;
import org.mechservice.solver.ode.IntegratorSettings.Mode;

/**
 * Solves the equations of a step: derivatives, factors, iteration, and what the solution has to
 * pass besides. It finds out what to renew when that fails, and what to call a failure that nothing
 * mends. Whatever was stopped is taken up where it stood.
 */
final class StepSolver {
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
  private final StepDerivatives derivatives;
  private final StepFactors factors;
  private final NewtonIteration newton;
  private final IterationRules rules;

  /** Steps whose end is still to be evaluated, whether that was stopped, and what it gave. */
  private int stepsToCheck;

  private boolean checking;
  private final double[] checked;

  private int notFiniteComponent = -1;

  StepSolver(StepEquations equations, Mode mode) {
    this.equations = equations;
    manifold = equations.manifold();
    drift = equations.drift();
    derivatives = equations.derivatives();
    factors = equations.factors();
    rules = equations.rules(mode);
    factors.follow(rules);
    newton = new NewtonIteration(manifold.dimension(), rules);
    checked = new double[manifold.dimension()];
  }

  /** Makes ready to find the start and then to step from there. */
  void beginAnew() {
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
  Attempt linearise(double t, double[] y, double hGamma) {
    return lineariseWith(derivatives.form(t, y, hGamma));
  }

  /** Brings the derivatives to the prediction of a step that ends at {@code t}. */
  Attempt lineariseAhead(double t, double hGamma, BackwardDifferences differences) {
    return lineariseWith(derivatives.formAhead(t, hGamma, differences));
  }

  private Attempt lineariseWith(Attempt attempt) {
    if (attempt == Attempt.NOT_FINITE) {
      notFiniteComponent = equations.notFiniteInDerivatives();
    }
    return attempt;
  }

  /** Factors the matrix unless there are factors that will do. */
  Attempt factor(double hGamma) {
    return factors.factor(hGamma, newton);
  }

  /** Returns whether an iteration is under way that was stopped. */
  boolean begun() {
    return newton.begun() || checking;
  }

  /** Begins to iterate at the prediction of a step of order k that ends at {@code t}. */
  void begin(double t, BackwardDifferences differences, int k, ErrorNorm norm) {
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
  Attempt solve(double t, double hGamma, BackwardDifferences differences, ErrorNorm norm) {
    if (!checking) {
      Attempt attempt = iterate(t, hGamma, differences, norm);
      if (attempt != Attempt.PASSED || stepsToCheck == 0) {
        return attempt;
      }
    }
    checking = !equations.evaluate(t, hGamma, differences, checked);
    if (checking) {
      return Attempt.STOPPED;
    }
    notFiniteComponent = equations.notFiniteInEvaluation();
    return finite();
  }

  private Attempt iterate(
      double t, double hGamma, BackwardDifferences differences, ErrorNorm norm) {
    Attempt attempt = newton.iterate(equations, t, hGamma, differences, norm);
    if (newton.rateSeen() > 0 && attempt != Attempt.STOPPED) {
      drift.learn(newton.rateSeen());
    }
    if (attempt == Attempt.NOT_FINITE) {
      notFiniteComponent = newton.notFiniteComponent(equations);
      beginToCheck();
    }
    if (attempt != Attempt.PASSED) {
      return attempt;
    }
    if (manifold.changesStates()) {
      if (!manifold.project(t, differences.corrected())) {
        return Attempt.NOT_COMPLETED;
      }
      differences.takeOverCorrected();
    }
    notFiniteComponent = RightHandSide.firstNotFinite(differences.corrected());
    return finite();
  }

  private Attempt finite() {
    return notFiniteComponent < 0 ? Attempt.PASSED : Attempt.NOT_FINITE;
  }

  /**
   * The problem may be defined only on one side of a place near by: the last iterate is a guess.
   */
  private void beginToCheck() {
    stepsToCheck = rules.heedsRoundOff() ? STEPS_CHECKED : 0;
  }

  /** Takes note that a step was accepted. */
  void moveOn(double hGamma, BackwardDifferences differences) {
    derivatives.moveOn();
    stepsToCheck = Math.max(0, stepsToCheck - 1);
    equations.solved(hGamma, differences);
  }

  /**
   * Asks for new factors unless they are those of the present step, else for new derivatives unless
   * they are of the present point; returns whether it did.
   */
  boolean renew(double hGamma) {
    return factors.outdateUnlessOf(hGamma) || derivatives.renew();
  }

  /**
   * Returns what to call a failure that no step size mends.
   *
   * @param interval of the problem, signed
   */
  Cause cause(Attempt attempt, double interval, ErrorNorm norm) {
    boolean solvable = attempt == Attempt.TOO_INACCURATE || attempt == Attempt.NOT_CONVERGING;
    if (!solvable) {
      return attempt.cause();
    }
    boolean singular = equations.reciprocalCondition() < Math.ulp(1.0);
    if (equations.roundOff(USUAL_PART * interval, norm) > FELT_ROUND_OFF) {
      return Cause.TOLERANCE_TOO_TIGHT;
    }
    return singular && attempt == Attempt.NOT_CONVERGING ? Cause.SINGULAR_MATRIX : attempt.cause();
  }

  /** Returns the component that made the equations fail. */
  int limitingComponent(Attempt attempt, ErrorNorm norm) {
    return switch (attempt) {
      case NOT_FINITE -> notFiniteComponent;
      case SINGULAR_MATRIX -> equations.singularComponent();
      case NOT_COMPLETED -> -1;
      default -> norm.largest(newton.change());
    };
  }

  /** Carries the state between two steps over; the factors are formed anew. */
  void transfer(StateTransfer state) {
    stepsToCheck = state.integer(stepsToCheck);
    newton.transfer(state);
    derivatives.transfer(state);
    factors.transfer(state);
    if (state.restoring()) {
      factors.restore();
    }
  }
}
