package org.mechservice.mechml.resolve.force;

/**
 * The dissipation that a coefficient of restitution asks for.
 *
 * <p>A body of mass m hits at the speed v and leaves at e v under m d″ = −k dⁿ (1 + χ d′) alone.
 * From d′ dd′ / (1 + χ d′) = −(k/m) dⁿ dd, integrated over both halves of the impact between the
 * touch and the greatest depth, follows with u = χ v
 *
 * <pre>(1 + e) u = ln((1 + u) / (1 − e u)),</pre>
 *
 * whatever m, k and n (Gonthier, McPhee, Lange and Piedboeuf, Multibody System Dynamics 11 (2004)
 * 209). u = 3 (1 − e²)/4 of Lankarani and Nikravesh (J. Mech. Design 112 (1990) 369) is its limit
 * near e = 1, and u = 8 (1 − e)/(5 e) of Flores, Machado, Silva and Martins (Multibody System
 * Dynamics 25 (2011) 357) an approximation for small e.
 */
final class Restitution {
  /** Below this u the equation is summed as a series, because its terms cancel. */
  private static final double SERIES = 0.1;

  private Restitution() {}

  /**
   * Returns u = χ v.
   *
   * @param e restitution, above 0 and at most 1
   */
  static double dissipationBySpeed(double e) {
    if (e == 1) {
      return 0;
    }
    // the residual rises from (1 − e²)/2 at u = 0 downwards to −∞ at u = 1/e
    double low = 0;
    double high = 1 / e;
    while (true) {
      double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) {
        return low;
      }
      if (residual(e, middle) > 0) {
        low = middle;
      } else {
        high = middle;
      }
    }
  }

  /** Returns ((1 + e) u − ln(1 + u) + ln(1 − e u)) / u², positive below the solution. */
  private static double residual(double e, double u) {
    if (u > SERIES) {
      return ((1 + e) * u - StrictMath.log1p(u) + StrictMath.log1p(-e * u)) / (u * u);
    }
    double sum = 0;
    double power = 1;
    double ofE = e * e;
    for (int m = 2; m <= 20; m++) {
      sum += power * ((m % 2 == 0 ? 1 : -1) - ofE) / m;
      power *= u;
      ofE *= e;
    }
    return sum;
  }
}
