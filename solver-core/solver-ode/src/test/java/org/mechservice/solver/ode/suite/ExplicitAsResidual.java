package org.mechservice.solver.ode.suite;

/**
 * An explicit problem written as the residual y' − f(t, y).
 *
 * @param problem the explicit one
 */
public record ExplicitAsResidual(SuiteProblem problem) implements ResidualProblem {
  @Override
  public VerifiedValues reference() {
    return problem.reference();
  }

  @Override
  public String name() {
    return problem.name();
  }

  @Override
  public double[] initialDerivative() {
    double[] yDot = new double[dimension()];
    problem.derivative(0, reference().initialState(), yDot);
    return yDot;
  }

  @Override
  public void residual(double t, double[] y, double[] yDot, double[] residual) {
    problem.derivative(t, y, residual);
    for (int i = 0; i < residual.length; i++) {
      residual[i] = yDot[i] - residual[i];
    }
  }
}
