package org.mechservice.solver.spatial;

/** Case distinctions for generated code, which contains no branches. */
public final class Piecewise {
  private Piecewise() {}

  /** Returns {@code first} if a ≤ b, otherwise {@code second}, also if a or b is NaN. */
  public static double choose(double a, double b, double first, double second) {
    return a <= b ? first : second;
  }

  /** Returns x if a ≥ 0, otherwise 0. */
  public static double where(double a, double x) {
    return a >= 0 ? x : 0;
  }

  /** Returns 0 if a ≥ 0, otherwise x. */
  public static double elsewhere(double a, double x) {
    return a >= 0 ? 0 : x;
  }

  /** Returns a · b, and 0 if one of them is 0, even if the other is infinite or NaN. */
  public static double product(double a, double b) {
    return a == 0 || b == 0 ? 0 : a * b;
  }

  /** Returns {@link #choose}, as a number that a search has found: its derivatives count as 0. */
  public static double pick(double a, double b, double first, double second) {
    return a <= b ? first : second;
  }

  /** Returns x, as a number that a search has found: its derivative counts as 0. */
  public static double held(double x) {
    return x;
  }
}
