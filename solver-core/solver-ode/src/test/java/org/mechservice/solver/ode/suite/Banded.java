package org.mechservice.solver.ode.suite;

import org.mechservice.solver.ode.BandedSystem;

/** A problem that declares its band. */
public record Banded(SuiteProblem problem, int lowerBandwidth, int upperBandwidth)
    implements SuiteProblem, BandedSystem {
  @Override
  public int dimension() {
    return problem.dimension();
  }

  @Override
  public VerifiedValues reference() {
    return problem.reference();
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    problem.derivative(t, y, yDot);
  }
}
