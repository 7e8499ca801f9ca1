package org.mechservice.solver.spatial;

/** What generated code, which has no branches of its own, calls where a formula has cases. */
public final class Piecewise {
  private Piecewise() {}

  /** Returns {@code first} where a ≤ b, else {@code second}; also where one is not a number. */
  public static double choose(double a, double b, double first, double second) {
    return a <= b ? first : second;
  }
}
