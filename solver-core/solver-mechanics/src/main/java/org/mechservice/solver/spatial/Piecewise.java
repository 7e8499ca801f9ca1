package org.mechservice.solver.spatial;

/** What generated code, which has no branches of its own, calls where a formula has cases. */
public final class Piecewise {
  private Piecewise() {}

  /** Returns {@code first} where a ≤ b, else {@code second}; also where one is not a number. */
  public static double choose(double a, double b, double first, double second) {
    return a <= b ? first : second;
  }

  /** Returns a · b, and 0 where one of them is 0, even if the other is infinite or no number. */
  public static double product(double a, double b) {
    return a == 0 || b == 0 ? 0 : a * b;
  }
}
