package org.mechservice.solver.integration;

/**
 * Size of the first step of a stiff method, for which the local error of order 1, ½ h² y'', just
 * passes. y'' = ∂f/∂t + J f; ∂f/∂t is differenced over a stretch that is short against the step for
 * which h y' is √rtol times y. Shampine and Reichelt 1997, the section on ode15s.
 */
final class FirstStep {
  /** The step is this much shorter than the estimates allow. */
  private static final double SAFETY = 1.25;

  private static final double SQRT_ROUNDOFF = Math.sqrt(Math.ulp(1.0));

  /** f at the start and, after a short while, y'', length n. */
  private final double[] slope;

  private final double[] curvature;

  /**
   * @param slope f at the start; kept, not modified
   */
  FirstStep(double[] slope) {
    this.slope = slope;
    curvature = new double[slope.length];
  }

  /**
   * Returns the size of the step, positive; 0 if told to stop.
   *
   * @param longest longest step allowed, signed
   * @param smallest smallest step that the arithmetic can hold
   * @param relativeTolerance of the norm
   */
  double size(
      StepEquations equations,
      double t0,
      double[] y0,
      ErrorNorm norm,
      double longest,
      double smallest,
      double relativeTolerance) {
    double shortness = SAFETY * norm.of(slope) * Math.sqrt(relativeTolerance);
    double size = Math.max(smallest, bounded(longest, shortness));
    double end = t0 + Math.copySign(size, longest);
    double stretch = SQRT_ROUNDOFF * Math.max(Math.abs(t0), Math.abs(end));
    double after = t0 + Math.copySign(Math.min(stretch, size), longest);
    if (!equations.rightHandSide().evaluate(after, y0, curvature)) {
      return 0;
    }
    formCurvature(after - t0, equations.jacobian());
    double bend = SAFETY * Math.sqrt(0.5 * norm.of(curvature));
    return Double.isFinite(bend) ? Math.max(smallest, bounded(longest, bend)) : size;
  }

  private void formCurvature(double stretch, KeptJacobian jacobian) {
    for (int l = 0; l < slope.length; l++) {
      curvature[l] = (curvature[l] - slope[l]) / stretch;
    }
    jacobian.addProduct(slope, curvature);
  }

  /** Returns 1 / shortness, at most the longest step. */
  private static double bounded(double longest, double shortness) {
    double size = Math.abs(longest);
    return size * shortness > 1 ? 1 / shortness : size;
  }
}
