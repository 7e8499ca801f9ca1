package org.mechservice.solver.expression;

import org.mechservice.solver.spatial.SinCos;

/**
 * First and second partial derivatives of one operation f(a, b), and scratch for their computation.
 */
final class LocalDerivatives {
  double byA;
  double byB;
  double byAA;
  double byAB;
  double byBB;

  private final double[] sinCos = new double[2];

  /** Returns the sine, rad. */
  double sin(double angle) {
    SinCos.sinCos(angle, sinCos, 0);
    return sinCos[0];
  }

  /** Returns the cosine, rad. */
  double cos(double angle) {
    SinCos.sinCos(angle, sinCos, 0);
    return sinCos[1];
  }

  /** Sets the derivatives of an operation that is linear in both arguments. */
  void linear(double a, double b) {
    all(a, b, 0, 0, 0);
  }

  /** Sets the derivatives of a function of one argument. */
  void single(double first, double second) {
    all(first, 0, second, 0, 0);
  }

  /** Sets all five derivatives. */
  void all(double a, double b, double aa, double ab, double bb) {
    byA = a;
    byB = b;
    byAA = aa;
    byAB = ab;
    byBB = bb;
  }
}
