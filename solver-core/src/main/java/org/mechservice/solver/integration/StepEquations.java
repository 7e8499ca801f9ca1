package org.mechservice.solver.integration;

import org.mechservice.solver.integration.IntegrationFailure.Cause;
import org.mechservice.solver.linear.LinearSolver;

/**
 * The equations that an implicit step has to solve, and the means to do it: Jacobian, matrix and
 * Newton iteration. Whatever was stopped is taken up where it stood.
 */
final class StepEquations {
  private final RightHandSide rightHandSide;
  private final KeptJacobian jacobian;
  private final IterationMatrix matrix;
  private final NewtonIteration newton;
  private int notFiniteComponent;

  /**
   * @param smallSizes size below which a component is negligible; not modified
   * @param derivative0 f at the start; not modified
   */
  StepEquations(
      RightHandSide rightHandSide, LinearSolver solver, double[] smallSizes, double[] derivative0) {
    this.rightHandSide = rightHandSide;
    jacobian = new KeptJacobian(solver.layout(), smallSizes, derivative0);
    matrix = new IterationMatrix(solver);
    newton = new NewtonIteration(derivative0.length);
  }

  RightHandSide rightHandSide() {
    return rightHandSide;
  }

  KeptJacobian jacobian() {
    return jacobian;
  }

  /** Evaluates the Jacobian where the step starts if a new one is wanted. */
  Attempt linearise(double t, double[] y) {
    if (!jacobian.wanted()) {
      return Attempt.PASSED;
    }
    Attempt attempt = jacobian.evaluate(rightHandSide, t, y);
    if (attempt == Attempt.PASSED) {
      matrix.outdate();
    } else {
      notFiniteComponent = jacobian.notFiniteComponent();
    }
    return attempt;
  }

  /** Forgets the factors: h or k has changed. */
  void outdate() {
    matrix.outdate();
  }

  /** Factors the matrix unless that is done. */
  Attempt factor(double hGamma) {
    if (matrix.factored()) {
      return Attempt.PASSED;
    }
    newton.forgetRate();
    return matrix.factor(hGamma, jacobian.values());
  }

  /** Returns whether an iteration is under way that was stopped. */
  boolean begun() {
    return newton.begun();
  }

  /** Begins to iterate at the prediction. */
  void begin(BackwardDifferences differences, ErrorNorm norm) {
    newton.begin(differences, norm);
  }

  /** Iterates for the correction of a step that ends at {@code t}. */
  Attempt solve(double t, double hGamma, BackwardDifferences differences, ErrorNorm norm) {
    Attempt attempt = newton.iterate(rightHandSide, t, hGamma, matrix, differences, norm);
    if (attempt == Attempt.NOT_FINITE) {
      notFiniteComponent = newton.notFiniteComponent();
    }
    return attempt == Attempt.PASSED ? requireFinite(differences.corrected()) : attempt;
  }

  private Attempt requireFinite(double[] y) {
    notFiniteComponent = RightHandSide.firstNotFinite(y);
    return notFiniteComponent < 0 ? Attempt.PASSED : Attempt.NOT_FINITE;
  }

  /** Takes note that a step was accepted. */
  void moveOn() {
    jacobian.moveOn();
  }

  /** Asks for a new Jacobian unless it is that of the present point; returns whether it did. */
  boolean renewJacobian() {
    if (jacobian.current()) {
      return false;
    }
    jacobian.want();
    return true;
  }

  /** Returns what to call a failure of the equations that no step size mends. */
  Cause cause(Attempt attempt) {
    if (attempt == Attempt.NOT_FINITE) {
      return Cause.NOT_FINITE;
    }
    boolean singular = attempt == Attempt.SINGULAR_MATRIX || matrix.singularToWorkingPrecision();
    return singular ? Cause.SINGULAR_MATRIX : Cause.NO_CONVERGENCE;
  }

  /** Returns the component that made the equations fail. */
  int limitingComponent(Attempt attempt, ErrorNorm norm) {
    return switch (attempt) {
      case NOT_FINITE -> notFiniteComponent;
      case SINGULAR_MATRIX -> matrix.singularColumn();
      default -> norm.largest(newton.change());
    };
  }

  IntegrationStatistics statistics(Progress progress) {
    return new IntegrationStatistics(
        progress.steps(),
        progress.rejectedSteps(),
        rightHandSide.evaluations(),
        jacobian.evaluations(),
        matrix.factorisations(),
        matrix.solutions(),
        false);
  }
}
