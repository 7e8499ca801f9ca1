package org.mechservice.solver.ode.stiff;

import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.newton.StepEquations;

/**
 * How much of the tolerances a step of a stiff method may err by.
 *
 * <p>Where a problem is stiff, most of the error of a step dies out in the next ones. A step in
 * which even the fastest motion of the problem advances little, h ρ(∂f/∂y) &lt; 1, damps nothing:
 * the errors of all such steps add up, and at the low orders of these methods they are hundreds,
 * with errors of one sign. Each may then have a hundredth of the tolerances, which costs about
 * twice the steps at order 5 (100^(1/6)) and brings back the two digits that an orbit or an
 * oscillation loses. Where the fastest motion is a decay, it takes its errors with it, and where it
 * is a growth, it makes the first ones the largest: nothing is held back. Where it is an
 * oscillation of damping ratio ζ, an error of a step is felt for some 1/ζ radians: its share grows
 * with ζ, up to that of steps beyond the fastest motion.
 *
 * <p>Steps beyond the fastest motion have a third. Not all of a stiff problem is stiff: its slow
 * motion sums errors up, too. The evaluations for that are fewer than those that the standard mode
 * saves elsewhere. Of problems in residual form the fastest motion is not known, and they have all.
 *
 * <p>The published programs do not do so.
 */
final class ErrorAllowance {
  private static final double RESOLVED_PART = 0.01;

  /** Part for steps beyond the fastest motion. */
  private static final double STIFF_PART = 1.0 / 3;

  /**
   * Damping ratio that is enough for all of {@link #STIFF_PART}; below, the part falls with the
   * third power, as an oscillation of ratio 0.02 still sums its errors up. Chosen on two slider
   * cranks with damped bushings, where it spares a sixth of the evaluations at equal errors.
   */
  private static final double WELL_DAMPED = 0.1;

  private final boolean full;
  private double resolvedPart = 1;
  private double stiffPart = 1;

  private ErrorAllowance(boolean full) {
    this.full = full;
  }

  /** What steps may err by in a mode. */
  static ErrorAllowance of(Mode mode) {
    return new ErrorAllowance(mode == Mode.FAITHFUL);
  }

  /** For a method that is at work only where its steps are beyond the fastest motion. */
  static ErrorAllowance full() {
    return new ErrorAllowance(true);
  }

  /**
   * Begins a problem.
   *
   * @param relativeTolerance by which all errors are judged
   * @param factor that over the one asked for
   */
  void begin(double relativeTolerance, double factor) {
    double limit = IntegratorSettings.SMALLEST_RELATIVE_TOLERANCE / relativeTolerance;
    resolvedPart = Math.min(1, Math.max(RESOLVED_PART / factor, limit));
    stiffPart = Math.min(1, Math.max(STIFF_PART / factor, limit));
  }

  /** Returns the part of the tolerances that a step of size h may err by. */
  double part(double h, StepEquations equations) {
    double fastest = equations.fastestMotion();
    if (full || Double.isInfinite(fastest)) {
      return 1;
    }
    if (Math.abs(h) * fastest >= 1) {
      return stiffPart;
    }
    if (equations.fastestIsExponential()) {
      return 1;
    }
    double damped = Math.min(1, equations.dampingOfFastest() / WELL_DAMPED);
    return Math.max(resolvedPart, damped * damped * damped * stiffPart);
  }
}
