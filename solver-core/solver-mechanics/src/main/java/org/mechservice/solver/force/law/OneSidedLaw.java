package org.mechservice.solver.force.law;

/**
 * The force of two things that push each other while they overlap by x and exert no force while
 * they are apart. With p = pos(x), E = k pⁿ and D = c x′ pos′(x) + χ x′ E the force is
 *
 * <pre>F = max(0, E + D),</pre>
 *
 * so it never pulls, whatever the damping and however fast the bodies part. c is a linear damper; χ
 * is the dissipation of Hunt and Crossley (J. Appl. Mech. 42 (1975) 440), whose force is continuous
 * at first touch.
 *
 * <p>With ε &gt; 0 the corner at E + D = 0 is rounded as well: with r = 2 (E + D)/E, F = ½ E φ(r),
 * φ(r) = (1 + r)⁶ (63 − 122 r + 102 r² − 42 r³ + 7 r⁴)/512 for |r| &lt; 1, the polynomial with φ″ =
 * c (1 − r²)⁴, which continues r above and 0 below with five continuous derivatives. So F = E + D
 * unless the damper takes away more than half of the push.
 *
 * <p>Units: x in m (or rad), F in N (or N·m), k in N/mⁿ, c in N·s/m, χ in s/m.
 */
final class OneSidedLaw {
  private final double[] bound = new double[2];

  private double k;
  private double n;
  private double c;
  private double chi;
  private double eps;

  private double force;
  private double elastic;
  private double byDepth;
  private double byRate;

  /** Sets the coefficients, all of them zero or positive, n at least 1. */
  void set(
      double stiffness, double exponent, double damping, double dissipation, double smoothing) {
    k = stiffness;
    n = exponent;
    c = damping;
    chi = dissipation;
    eps = smoothing;
  }

  /** Evaluates the force at the overlap x with the rate x′, and its derivatives. */
  void evaluate(double x, double rate) {
    double p = SmoothPositive.value(x, eps);
    double slope = SmoothPositive.slope(x, eps);
    elastic = k * SmoothPositive.power(p, n);
    double elasticByDepth = k == 0 ? 0 : k * n * SmoothPositive.power(p, n - 1) * slope;
    double damper = c * rate * slope + chi * rate * elastic;
    double damperByDepth = c * rate * SmoothPositive.bend(x, eps) + chi * rate * elasticByDepth;
    force = bounded(elastic, damper);
    byDepth = bound[0] * (elasticByDepth + damperByDepth) + bound[1] * elasticByDepth;
    byRate = bound[0] * (c * slope + chi * elastic);
  }

  /**
   * Returns the bounded sum E + D, and writes its slope by the sum, and its slope by E with the sum
   * held.
   */
  private double bounded(double e, double d) {
    double sum = e + d;
    double half = 0.5 * e;
    if (eps == 0 || Math.abs(sum) >= half) {
      bound[0] = sum > 0 ? 1 : 0;
      bound[1] = 0;
      return sum > 0 ? sum : 0;
    }
    double r = sum / half;
    double cube = (1 + r) * (1 + r) * (1 + r);
    double value = cube * cube * (63 + r * (-122 + r * (102 + r * (-42 + 7 * r)))) / 512;
    double fifth = cube * (1 + r) * (1 + r);
    bound[0] = fifth * (128 + r * (-325 + r * (345 + r * (-175 + 35 * r)))) / 256;
    bound[1] = 0.5 * (value - r * bound[0]);
    return half * value;
  }

  /** Returns the force, never negative. */
  double force() {
    return force;
  }

  /** Returns the part of the force that has a potential energy. */
  double elastic() {
    return elastic;
  }

  double byDepth() {
    return byDepth;
  }

  double byRate() {
    return byRate;
  }

  /** Returns the potential energy at the overlap x, J. */
  double potentialEnergy(double x) {
    return k == 0 ? 0 : k * SmoothPositive.integral(x, eps, n);
  }
}
