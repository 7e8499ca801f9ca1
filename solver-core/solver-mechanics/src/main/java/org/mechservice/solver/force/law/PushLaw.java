package org.mechservice.solver.force.law;

import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;

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
 * <p>Units: x in m (or rad), F in N (or N·m).
 *
 * @param k stiffness, N/mⁿ, not negative
 * @param n exponent, at least 1
 * @param c linear damping, N·s/m, not negative
 * @param chi dissipation χ, s/m, not negative
 * @param eps ε of pos, m, not negative
 */
public record PushLaw(Scalar k, Scalar n, Scalar c, Scalar chi, Scalar eps) {
  /** Keeps the share of a push defined where it is zero, N. */
  private static final double TINY = 1e-300;

  /** Returns the part with potential energy at the overlap x. */
  public Scalar elastic(Scalar x) {
    return k.isZero() ? k : new SmoothPart(x, eps).power(n).times(k);
  }

  /** Returns the force at the overlap x with the rate x′, never negative. */
  public Scalar force(Scalar x, Scalar rate) {
    if (!isDamped()) {
      return elastic(x);
    } else if (eps.isZero()) {
      return hard(x, rate);
    }
    Scalar smooth = smooth(x, rate);
    return eps.isConstant() ? smooth : choose(eps, zero(), hard(x, rate), smooth);
  }

  private boolean isDamped() {
    return !(c.isZero() && chi.isZero());
  }

  private Scalar zero() {
    return eps.expressions().zero();
  }

  private static Scalar choose(Scalar a, Scalar b, Scalar first, Scalar second) {
    return a.expressions().function(MathFunction.CHOOSE, a, b, first, second);
  }

  private static Scalar larger(Scalar a, Scalar b) {
    return a.expressions().function(MathFunction.MAX, a, b);
  }

  /** Returns D with a slope of pos. */
  private Scalar damper(Scalar rate, Scalar slope, Scalar elastic) {
    Scalar linear = c.isZero() ? c : rate.times(c).times(slope);
    return chi.isZero() ? linear : linear.plus(rate.times(chi).times(elastic));
  }

  /**
   * Returns the force for ε = 0, with pos′ chosen outside of the bound: what is bounded, E + D,
   * does not jump at a touch, and its zero is where the push ends.
   */
  private Scalar hard(Scalar x, Scalar rate) {
    Scalar elastic = new PushLaw(k, n, c, chi, zero()).elastic(x);
    Scalar damper = damper(rate, zero().expressions().one(), elastic);
    Scalar pressed = larger(zero(), elastic.plus(damper));
    Scalar half = larger(zero(), rate.times(c).times(0.5));
    Scalar touching = choose(zero(), x, half, zero());
    return choose(x, zero(), touching, pressed);
  }

  /** Returns the force for ε &gt; 0. */
  private Scalar smooth(Scalar x, Scalar rate) {
    Scalar elastic = elastic(x);
    Scalar damper = damper(rate, new SmoothPart(x, eps).slope(), elastic);
    Scalar sum = elastic.plus(damper);
    return elastic.isZero() ? larger(zero(), sum) : rounded(elastic, sum);
  }

  private static Scalar rounded(Scalar elastic, Scalar sum) {
    Expressions e = sum.expressions();
    // beyond ±1 of the share r the rounded part is constant: its slope there is 0
    Scalar half = elastic.times(0.5);
    Scalar share = sum.over(half.plus(e.constant(TINY)));
    Scalar below = e.function(MathFunction.MIN, e.one(), share);
    Scalar r = larger(e.constant(-1), below);
    Scalar above = r.plus(e.one());
    Scalar cube = above.squared().times(above);
    Scalar factor = e.constant(7);
    for (int coefficient : new int[] {-42, 102, -122, 63}) {
      factor = r.times(factor).plus(e.constant(coefficient));
    }
    Scalar rounded = half.times(cube.squared().times(factor).times(1.0 / 512));
    return rounded.plus(larger(e.zero(), sum.minus(half)));
  }

  /** Returns the damper's part of the force. */
  Scalar dissipative(Scalar x, Scalar rate) {
    return isDamped() ? force(x, rate).minus(elastic(x)) : zero();
  }

  /** Returns the potential energy at the overlap x, J. */
  public Scalar potential(Scalar x) {
    return k.isZero() ? k : new SmoothPart(x, eps).integral(n).times(k);
  }
}
