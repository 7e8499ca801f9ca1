package org.mechservice.library.proof;

/**
 * A one-sided law: max(0, k dⁿ + c d′) where the depth d is positive.
 *
 * @param k stiffness, N/mⁿ
 * @param n exponent
 * @param c damping, N s/m
 */
record Law(double k, double n, double c) {
  /** Number of functions at whose zeros the force is not smooth: the depth, the force. */
  int margins() {
    return c == 0 ? 1 : 2;
  }

  /** Value of one of them. */
  double margin(int i, double depth, double rate) {
    return i == 0 ? depth : raw(depth, rate);
  }

  /** Force on a branch. */
  double force(double depth, double rate, boolean[] above) {
    return above[0] && (margins() == 1 || above[1]) ? raw(depth, rate) : 0;
  }

  private double raw(double depth, double rate) {
    double spring = n == 1 ? k * depth : k * Math.copySign(Math.pow(Math.abs(depth), n), depth);
    return spring + c * rate;
  }

  Law times(double count) {
    return new Law(count * k, n, count * c);
  }
}
