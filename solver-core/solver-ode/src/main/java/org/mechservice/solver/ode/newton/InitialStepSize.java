package org.mechservice.solver.ode.newton;

import org.mechservice.solver.ode.step.ErrorNorm;

/**
 * Size of the first step of a stiff method, for which the local error of order 1, ½ h² y'', just
 * passes. To estimate y'' the equations look ahead over a part of the step for which h y' is √rtol
 * times y. Shampine and Reichelt 1997, the section on ode15s.
 */
public final class InitialStepSize {
  /** The step is this much shorter than the estimates allow. */
  private static final double SAFETY = 1.25;

  /** Part of a usual first step after a restart, and of the time in which a slope would vanish. */
  private static final double RESTART_PART = 0.1;

  /** No slope makes a step after a restart shorter than this part of a usual first step. */
  private static final double LEAST_PART = 1e-4;

  /** y'' at the start, length n. */
  private final double[] curvature;

  /**
   * @param dimension n
   */
  public InitialStepSize(int dimension) {
    curvature = new double[dimension];
  }

  /**
   * Returns the size of the step, positive; 0 if told to stop.
   *
   * @param slope y' at the start; not modified
   * @param longest longest step allowed, signed
   * @param smallest smallest step that the arithmetic can hold
   * @param relativeTolerance of the norm
   */
  public double size(
      StepEquations equations,
      double t0,
      double[] y0,
      double[] slope,
      ErrorNorm norm,
      double longest,
      double smallest,
      double relativeTolerance) {
    double size = Math.max(smallest, bySlope(slope, norm, longest, relativeTolerance));
    if (!equations.curvature(t0, y0, slope, Math.copySign(size, longest), curvature)) {
      return 0;
    }
    double bend = SAFETY * Math.sqrt(0.5 * norm.of(curvature));
    return Double.isFinite(bend) ? Math.max(smallest, bounded(longest, bend)) : size;
  }

  /**
   * Returns the step to go on with after a restart, when {@link #size} has given what is usual. It
   * is so short that no component turns round in a step of order 1, whose interpolant does not
   * bend: what has just bounced off an event is seen to rise before it falls again.
   *
   * @param usual positive
   * @param slope y' at the start; not modified
   */
  public double afterRestart(double usual, double[] slope, ErrorNorm norm) {
    double shortest = RESTART_PART * usual;
    for (int l = 0; l < slope.length; l++) {
      if (slope[l] != 0 && norm.weight(l) > 0) {
        double turning = RESTART_PART * Math.abs(slope[l] / curvature[l]);
        shortest = turning < shortest ? turning : shortest;
      }
    }
    return Math.max(LEAST_PART * usual, shortest);
  }

  /** Returns the step for which h y' is √rtol times y, at most the longest. */
  static double bySlope(double[] slope, ErrorNorm norm, double longest, double relativeTolerance) {
    return bounded(longest, SAFETY * norm.of(slope) * Math.sqrt(relativeTolerance));
  }

  /** Returns 1 / shortness, at most the longest step. */
  private static double bounded(double longest, double shortness) {
    double size = Math.abs(longest);
    return size * shortness > 1 ? 1 / shortness : size;
  }
}
