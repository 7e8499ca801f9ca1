package org.mechservice.solver.closure;

import java.util.Locale;

/**
 * Numbers of the penalty closure (NUMERICS §3; García de Jalón and Bayo 1994, ch. 5).
 *
 * @param stiffness penalty per equation over the largest inertia on the diagonal of M; large enough
 *     for two or three repetitions to meet the equations to round-off
 * @param frequency Ω, 1/s: how fast a residual within a step dies out; those of accepted states are
 *     projected away
 * @param damping μ, of a residual as of an oscillator: 1 is critical
 */
public record PenaltySettings(double stiffness, double frequency, double damping) {
  /** What is used unless something else is said. */
  public static final PenaltySettings DEFAULT = new PenaltySettings(1e7, 10, 1);

  /** Returns the numbers as a sentence for the report. */
  String text() {
    return String.format(
        Locale.ROOT,
        "The loops are closed by penalty: alpha is %.0e times the largest inertia, Omega %.4g 1/s,"
            + " mu %.4g.",
        stiffness,
        frequency,
        damping);
  }
}
