package org.mechservice.solver.spatial;

/**
 * Sine and cosine of one angle together, with the same bits on every machine.
 *
 * <p>The angle is reduced by the nearest multiple of π/2 in three parts (Cody and Waite), which
 * keeps the remainder to twice the working precision for angles up to {@value #REDUCTION_LIMIT}
 * rad; two minimax polynomials on [−π/4, π/4] follow. The error is below 1 ulp. Larger angles go to
 * {@link StrictMath}, which is as accurate and slower.
 */
public final class SinCos {
  /**
   * Largest angle of the fast reduction, rad: a multiple of π/2 then has 13 bits and its product
   * with 33 bits is exact.
   */
  private static final double REDUCTION_LIMIT = 1e4;

  private static final double TWO_OVER_PI = 0x1.45f306dc9c883p-1;

  // π/2 = PI_HALF_1 + PI_HALF_2 + PI_HALF_3 to 119 bits; the first two have 33 bits each.
  private static final double PI_HALF_1 = 0x1.921fb544p0;
  private static final double PI_HALF_2 = 0x1.0b4611a6p-34;
  private static final double PI_HALF_3 = 0x1.3198a2e037073p-69;

  // sin(x) ≈ x + x³ (S1 + S2 x² + …): minimax for |x| ≤ π/4, error 3.4e-18 relative to x.
  private static final double S1 = -0.16666666666666632;
  private static final double S2 = 0.008333333333322398;
  private static final double S3 = -0.0001984126982979409;
  private static final double S4 = 2.755731368695442e-06;
  private static final double S5 = -2.5050757308207942e-08;
  private static final double S6 = 1.5896747244048834e-10;

  // cos(x) ≈ 1 − x²/2 + x⁴ (C1 + C2 x² + …): minimax for |x| ≤ π/4, error 4.7e-20.
  private static final double C1 = 0.0416666666666666;
  private static final double C2 = -0.00138888888888741;
  private static final double C3 = 2.4801587289467676e-05;
  private static final double C4 = -2.755731434795667e-07;
  private static final double C5 = 2.0875722654805672e-09;
  private static final double C6 = -1.1359614629226544e-11;

  private SinCos() {}

  /** Returns the sine of an angle, rad: that of {@link #sinCos}. */
  public static double sine(double angle) {
    return Math.abs(angle) <= REDUCTION_LIMIT ? wave(angle, 0) : StrictMath.sin(angle);
  }

  /** Returns the cosine of an angle, rad: that of {@link #sinCos}. */
  public static double cosine(double angle) {
    return Math.abs(angle) <= REDUCTION_LIMIT ? wave(angle, 1) : StrictMath.cos(angle);
  }

  /**
   * Evaluates sine and cosine.
   *
   * @param angle rad; NaN and infinities give NaN
   * @param out sine at {@code offset}, cosine at {@code offset + 1}; overwritten
   * @param offset where to write
   */
  public static void sinCos(double angle, double[] out, int offset) {
    if (!(Math.abs(angle) <= REDUCTION_LIMIT)) {
      out[offset] = StrictMath.sin(angle);
      out[offset + 1] = StrictMath.cos(angle);
      return;
    }
    double n = Math.rint(angle * TWO_OVER_PI);
    double x = remainder(angle, n);
    double tail = partial(angle, n) - x - third(angle, n);
    double sin = sineOf(x, tail);
    double cos = cosineOf(x, tail);
    int quadrant = (int) n & 3;
    double s = (quadrant & 1) == 0 ? sin : cos;
    double c = (quadrant & 1) == 0 ? cos : sin;
    out[offset] = quadrant >= 2 ? -s : s;
    out[offset + 1] = quadrant == 1 || quadrant == 2 ? -c : c;
  }

  /** Returns the sine of an angle to which some quarters of a turn are added. */
  private static double wave(double angle, int quarters) {
    double n = Math.rint(angle * TWO_OVER_PI);
    double x = remainder(angle, n);
    double tail = partial(angle, n) - x - third(angle, n);
    int quadrant = ((int) n + quarters) & 3;
    double size = (quadrant & 1) == 0 ? sineOf(x, tail) : cosineOf(x, tail);
    return quadrant >= 2 ? -size : size;
  }

  /** angle − n π/2, to twice the working precision with the tail that rounding leaves. */
  private static double remainder(double angle, double n) {
    return partial(angle, n) - third(angle, n);
  }

  private static double partial(double angle, double n) {
    return angle - n * PI_HALF_1 - n * PI_HALF_2;
  }

  private static double third(double angle, double n) {
    double first = angle - n * PI_HALF_1;
    double second = n * PI_HALF_2;
    return n * PI_HALF_3 - ((first - (first - second)) - second);
  }

  private static double sineOf(double x, double tail) {
    double z = x * x;
    double polynomial = S1 + z * (S2 + z * (S3 + z * (S4 + z * (S5 + z * S6))));
    return x + (z * x * polynomial + tail * (1 - 0.5 * z));
  }

  private static double cosineOf(double x, double tail) {
    double z = x * x;
    double half = 0.5 * z;
    double polynomial = C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * C6))));
    double leading = 1 - half;
    return leading + (((1 - leading) - half) + (z * z * polynomial - x * tail));
  }
}
