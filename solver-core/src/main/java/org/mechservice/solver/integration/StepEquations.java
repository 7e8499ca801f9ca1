package org.mechservice.solver.integration;

import org.mechservice.solver.integration.IntegrationFailure.Cause;
import org.mechservice.solver.integration.IntegratorSettings.Mode;

/**
 * The equations that an implicit step has to solve, and the means to do it: derivatives, factored
 * matrix and Newton iteration. Whatever was stopped is taken up where it stood.
 *
 * <p>The derivatives are kept from step to step, however old, until an iteration fails and they are
 * not those of the present point; where the matrix moves with the state, until the iteration would
 * be slow. The form of the equations, explicit or residual, decides what they are.
 */
abstract class StepEquations {
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

  private final Manifold manifold;
  private final MatrixDrift drift;
  private final NewtonIteration newton;

  /** Whether new derivatives are asked for, and whether those kept are of the present point. */
  private boolean wanted = true;

  /** Whether each of them is asked for, or was when they were formed last; or the matrix alone. */
  private boolean all = true;

  private boolean current;

  private IterationRules rules = IterationRules.PUBLISHED;

  /** Whether there are factors with the present derivatives, and whether h or k has changed. */
  private boolean factored;

  private boolean stepChanged;

  private double factoredHGamma;

  /** Norm of the derivatives, once asked for. */
  private double fastestRate;

  private boolean rateKnown;

  /** Steps whose end is still to be evaluated, whether that was stopped, and what it gave. */
  private int stepsToCheck;

  private boolean checking;
  private final double[] checked;

  private int notFiniteComponent = -1;
  private long linearisations;
  private long factorisations;
  private long solutions;

  StepEquations(Manifold manifold, MatrixDrift drift) {
    this.manifold = manifold;
    this.drift = drift;
    newton = new NewtonIteration(manifold.dimension());
    checked = new double[manifold.dimension()];
  }

  /** Returns the places at which the equations jump. */
  abstract Breakpoints breakpoints();

  /** Returns whether the stop signal is given. */
  abstract boolean stopped();

  /** Forgets whatever was stopped: the problem begins, or goes on from another state. */
  abstract void abandon();

  /**
   * Finds what is not given of state and derivative where a problem begins or goes on anew.
   *
   * @param y state; completed
   * @param slope its derivative; overwritten
   */
  abstract Attempt findStart(double t, double[] y, double[] slope);

  /** Returns what to call a failure of {@link #findStart}. */
  abstract Cause causeAtStart(Attempt attempt);

  /** Returns the component to name in it; −1 if there is none. */
  abstract int componentAtStart(Attempt attempt);

  /** Evaluates the derivatives at the start of the step. */
  abstract Attempt formDerivatives(double t, double[] y);

  /** Evaluates the derivatives at the prediction of a step that ends at {@code t}. */
  abstract Attempt formAhead(double t, double hGamma, BackwardDifferences differences);

  /** Returns whether {@link #formMatrix} is cheaper than that. */
  abstract boolean formsMatrix();

  /** Brings the matrix of the iteration, but not each of its parts, up to date. */
  abstract Attempt formMatrix(double t, double[] y, double hGamma);

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
  abstract double cautious(double passing, double interval);

  /** Returns how often the right-hand side or residual was evaluated. */
  abstract long evaluations();

  /** Returns whether the solution may jump although the right-hand side is bounded. */
  abstract boolean solutionMayJump();

  /** Carries over what is known of the derivatives, and the problem's own state. */
  abstract void transferDerivatives(StateTransfer state);

  /** Takes note of the solution of an accepted step. */
  abstract void solved(double hGamma, BackwardDifferences differences);

  final Manifold manifold() {
    return manifold;
  }

  /** Makes ready to find the start and then to step from there. */
  final void beginAnew() {
    wanted = true;
    all = true;
    current = false;
    outdate();
    newton.abandon();
    checking = false;
    drift.clear();
    abandon();
  }

  /**
   * Evaluates the derivatives where the step starts if new ones are wanted.
   *
   * @param hGamma of the step; not asked for when none was tried yet
   */
  final Attempt linearise(double t, double[] y, double hGamma) {
    if (!wanted) {
      return Attempt.PASSED;
    }
    return formed(all ? formDerivatives(t, y) : formMatrix(t, y, hGamma), t);
  }

  /**
   * Returns whether derivatives are formed where steps will end, once there are steps: where the
   * matrix moves with the state, it is its change over the step that slows the iteration. Brenan,
   * Campbell and Petzold 1996, ch. 5.
   */
  final boolean looksAhead() {
    return drift.matters();
  }

  /** Returns whether that is to be done for a step that ends at {@code t}. */
  final boolean wantsAhead(double t) {
    return wanted || drift.slowAt(t);
  }

  /**
   * Evaluates the derivatives at the prediction of a step that ends at {@code t}. Where they are
   * not finite, those of a shorter step may be.
   */
  final Attempt lineariseAhead(double t, double hGamma, BackwardDifferences differences) {
    Attempt attempt = formed(formAhead(t, hGamma, differences), t);
    wanted = attempt != Attempt.PASSED;
    return attempt;
  }

  private Attempt formed(Attempt attempt, double t) {
    if (attempt == Attempt.STOPPED) {
      return attempt;
    }
    wanted = false;
    current = true;
    linearisations++;
    drift.formed(t);
    rateKnown = false;
    if (attempt == Attempt.PASSED) {
      outdate();
    } else {
      notFiniteComponent = notFiniteInDerivatives();
    }
    return attempt;
  }

  /** Returns ‖∂f/∂y‖ as formed last; 0 if nothing is known of it. */
  abstract double normOfDerivatives(ErrorNorm norm);

  /** Returns how fast the solution can change at most, ‖∂f/∂y‖ as formed last. */
  final double fastestRate(ErrorNorm norm) {
    if (!rateKnown) {
      fastestRate = normOfDerivatives(norm);
      rateKnown = true;
    }
    return fastestRate;
  }

  /**
   * Returns the largest magnitude of an eigenvalue of ∂f/∂y as formed last, estimated; infinite if
   * nothing is known of it.
   */
  abstract double fastestMotion();

  /** Returns whether the fastest motion is a decay or a growth, not an oscillation. */
  abstract boolean fastestIsExponential();

  /** Returns the rules by which steps are solved in a mode. */
  abstract IterationRules rules(Mode mode);

  /** Goes by the rules of a mode from now on. */
  final void follow(Mode mode) {
    rules = rules(mode);
    newton.follow(rules);
  }

  private void outdate() {
    factored = false;
  }

  /** Takes note that h or k has changed. */
  final void changeStep() {
    stepChanged = true;
  }

  /** Factors the matrix unless there are factors that will do. */
  final Attempt factor(double hGamma) {
    if (factored && (!stepChanged || close(hGamma))) {
      stepChanged = false;
      return Attempt.PASSED;
    }
    stepChanged = false;
    newton.forgetRate();
    factored = factorAnew(hGamma);
    return factored ? Attempt.PASSED : Attempt.SINGULAR_MATRIX;
  }

  /** Returns whether the matrix has hardly changed; then the iteration is the slower for it. */
  private boolean close(double hGamma) {
    double change = Math.abs(hGamma / factoredHGamma - 1);
    if (!(change <= rules.closeRatio())) {
      return false;
    }
    newton.expectRate(change / (1 + hGamma / factoredHGamma));
    return true;
  }

  /** Factors the matrix, for another use than the next iteration; returns whether it is regular. */
  final boolean factorAnew(double hGamma) {
    factored = false;
    factoredHGamma = hGamma;
    factorisations++;
    return formFactors(hGamma);
  }

  /** Solves one system of linear equations in place. */
  final void solveLinear(double hGamma, double[] residual) {
    substitute(hGamma, residual);
    solutions++;
    if (hGamma != factoredHGamma) {
      double part = 2 / (1 + hGamma / factoredHGamma);
      for (int l = 0; l < residual.length; l++) {
        residual[l] *= part;
      }
    }
  }

  /** Returns whether an iteration is under way that was stopped. */
  final boolean begun() {
    return newton.begun() || checking;
  }

  /** Begins to iterate at the prediction of a step of order k that ends at {@code t}. */
  final void begin(double t, BackwardDifferences differences, int k, ErrorNorm norm) {
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
  final Attempt solve(double t, double hGamma, BackwardDifferences differences, ErrorNorm norm) {
    if (!checking) {
      Attempt attempt = iterate(t, hGamma, differences, norm);
      if (attempt != Attempt.PASSED || stepsToCheck == 0) {
        return attempt;
      }
    }
    checking = !evaluate(t, hGamma, differences, checked);
    if (checking) {
      return Attempt.STOPPED;
    }
    notFiniteComponent = notFiniteInEvaluation();
    return finite();
  }

  private Attempt iterate(
      double t, double hGamma, BackwardDifferences differences, ErrorNorm norm) {
    Attempt attempt = newton.iterate(this, t, hGamma, differences, norm);
    if (newton.rateSeen() > 0 && attempt != Attempt.STOPPED) {
      drift.learn(newton.rateSeen());
    }
    if (attempt == Attempt.NOT_FINITE) {
      notFiniteComponent = newton.notFiniteComponent(this);
      beginToCheck();
    }
    if (attempt != Attempt.PASSED) {
      return attempt;
    }
    if (!manifold.project(t, differences.corrected())) {
      return Attempt.NOT_COMPLETED;
    }
    differences.takeOverCorrected();
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
  final void moveOn(double hGamma, BackwardDifferences differences) {
    current = false;
    stepsToCheck = Math.max(0, stepsToCheck - 1);
    solved(hGamma, differences);
  }

  /** Asks for new derivatives, whatever is known. */
  final void demandNew() {
    wanted = true;
    all = true;
    outdate();
  }

  /**
   * Asks for new factors unless they are those of the present step, else for new derivatives unless
   * they are of the present point; returns whether it did.
   */
  final boolean renew(double hGamma) {
    if (factored && hGamma != factoredHGamma) {
      outdate();
      return true;
    }
    if (current && all && drift.formedHere()) {
      return false;
    }
    all = current || !formsMatrix();
    wanted = true;
    return true;
  }

  /**
   * Returns what to call a failure that no step size mends.
   *
   * @param interval of the problem, signed
   */
  final Cause cause(Attempt attempt, double interval, ErrorNorm norm) {
    boolean solvable = attempt == Attempt.TOO_INACCURATE || attempt == Attempt.NOT_CONVERGING;
    if (!solvable) {
      return attempt.cause();
    }
    boolean singular = reciprocalCondition() < Math.ulp(1.0);
    if (roundOff(USUAL_PART * interval, norm) > FELT_ROUND_OFF) {
      return Cause.TOLERANCE_TOO_TIGHT;
    }
    return singular && attempt == Attempt.NOT_CONVERGING ? Cause.SINGULAR_MATRIX : attempt.cause();
  }

  /** Returns the component that made the equations fail. */
  final int limitingComponent(Attempt attempt, ErrorNorm norm) {
    return switch (attempt) {
      case NOT_FINITE -> notFiniteComponent;
      case SINGULAR_MATRIX -> singularComponent();
      case NOT_COMPLETED -> -1;
      default -> norm.largest(newton.change());
    };
  }

  final IntegrationStatistics statistics(Progress progress, double toleranceFactor) {
    return new IntegrationStatistics(
        progress.steps(),
        progress.rejectedSteps(),
        evaluations(),
        linearisations,
        factorisations,
        solutions,
        false,
        toleranceFactor,
        progress.limits());
  }

  /** Stands in until a problem is given. */
  static StepEquations none() {
    return new ExplicitEquations(RightHandSide.none(), new double[0]);
  }

  /** Carries the state between two steps over; the factors are formed anew. */
  final void transfer(StateTransfer state) {
    wanted = state.flag(wanted);
    all = state.flag(all);
    current = state.flag(current);
    factored = state.flag(factored);
    stepChanged = state.flag(stepChanged);
    factoredHGamma = state.number(factoredHGamma);
    linearisations = state.integer(linearisations);
    factorisations = state.integer(factorisations);
    solutions = state.integer(solutions);
    fastestRate = state.number(fastestRate);
    rateKnown = state.flag(rateKnown);
    stepsToCheck = state.integer(stepsToCheck);
    newton.transfer(state);
    drift.transfer(state);
    transferDerivatives(state);
    if (state.restoring() && factored) {
      formFactors(factoredHGamma);
    }
  }
}
