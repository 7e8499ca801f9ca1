package org.mechservice.solver.closure;

import java.util.Locale;
import org.mechservice.solver.catalogue.ClosureMethod;

/**
 * Parameters of the penalty closure (docs/theory/loops.md#penalty; García de Jalón and Bayo 1994,
 * ch. 5). Their text form follows the closure's name: {@code penalty:alpha=1e7,omega=10,mu=1}; an
 * omitted parameter has its default.
 *
 * @param stiffness α, penalty per equation divided by the largest diagonal element of M; smaller
 *     for rows longer than one. The default is large enough for two or three iterations to satisfy
 *     the equations to round-off
 * @param frequency Ω, 1/s: rate at which a residual decays within a step; projection removes
 *     residuals at accepted states
 * @param damping μ, damping ratio of the residual: 1 is critical damping
 */
public record PenaltySettings(double stiffness, double frequency, double damping) {
  /** Default parameters. */
  public static final PenaltySettings DEFAULT = new PenaltySettings(1e7, 10, 1);

  /** Name of the closure. */
  public static final String CLOSURE = ClosureMethod.PENALTY.label();

  private static final double LEAST_STIFFNESS = 1e3;
  private static final double LARGEST_STIFFNESS = 1e12;
  private static final double LARGEST_FREQUENCY = 1e6;
  private static final double LARGEST_DAMPING = 100;

  /**
   * @throws IllegalArgumentException if a number is out of range. With α below 1e3 the iteration
   *     hardly satisfies the equations; with α above 1e12 the mass matrix is lost to rounding in M
   *     + αJᵀJ
   */
  public PenaltySettings {
    require("alpha", stiffness, LEAST_STIFFNESS, LARGEST_STIFFNESS);
    require("omega", frequency, 0, LARGEST_FREQUENCY);
    require("mu", damping, 0, LARGEST_DAMPING);
  }

  private static void require(String name, double value, double least, double largest) {
    if (!(value >= least && value <= largest)) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "%s is %s; it must lie between %.4g and %.4g",
              name,
              value,
              least,
              largest));
    }
  }

  /** Returns whether a closure is the penalty closure, with or without parameters. */
  public static boolean isPenalty(String closure) {
    return closure.equals(CLOSURE) || closure.startsWith(CLOSURE + ":");
  }

  /**
   * Reads the numbers that follow the closure's name.
   *
   * @param closure {@code penalty}, or {@code penalty:} and numbers by name, separated by commas
   * @throws IllegalArgumentException if that is not so, or a number is out of range
   */
  public static PenaltySettings of(String closure) {
    double alpha = DEFAULT.stiffness;
    double omega = DEFAULT.frequency;
    double mu = DEFAULT.damping;
    if (!isPenalty(closure)) {
      throw new IllegalArgumentException("\"" + closure + "\" is not the penalty closure");
    }
    if (closure.equals(CLOSURE)) {
      return DEFAULT;
    }
    for (String part : closure.substring(CLOSURE.length() + 1).split(",", -1)) {
      int equals = part.indexOf('=');
      String name = equals < 0 ? part.strip() : part.substring(0, equals).strip();
      double value = number(part, equals);
      switch (name) {
        case "alpha" -> alpha = value;
        case "omega" -> omega = value;
        case "mu" -> mu = value;
        default -> throw notUnderstood(part);
      }
    }
    return new PenaltySettings(alpha, omega, mu);
  }

  private static double number(String part, int equals) {
    try {
      return Double.parseDouble(part.substring(equals + 1).strip());
    } catch (NumberFormatException e) {
      throw notUnderstood(part);
    }
  }

  private static IllegalArgumentException notUnderstood(String part) {
    return new IllegalArgumentException(
        "\"" + part + "\" is no number of the penalty closure; write alpha=1e7, omega=10 or mu=1");
  }

  /** Returns the numbers as a sentence for the report. */
  public String text() {
    return String.format(
        Locale.ROOT,
        "The loops are closed by penalty: alpha is %.4g times the largest inertia, Omega %.4g 1/s,"
            + " mu %.4g.",
        stiffness,
        frequency,
        damping);
  }
}
