package org.mechservice.sim.equations.force;

import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;

/**
 * The force of two things that push each other while they overlap by x and exert no force while
 * they are apart: the law of {@code solver.force.law.OneSidedLaw}, in its order of operations. With
 * p = pos(x), E = k pⁿ and D = c x′ pos′(x) + χ x′ E it is F = max(0, E + D), and with ε &gt; 0 F =
 * ½ E φ(2 + 2 D/E), φ a rounded positive part.
 *
 * @param k stiffness, N/mⁿ
 * @param n exponent
 * @param c linear damping, N·s/m
 * @param chi dissipation, s/m
 * @param eps ε of pos, m
 */
record PushLaw(Scalar k, double n, Scalar c, Scalar chi, double eps) {
  /** Keeps the share of a push defined where it is zero, N. */
  private static final double TINY = 1e-300;

  /** Returns the part with potential energy. */
  Scalar elastic(Scalar x) {
    return k.isZero() ? k : new SmoothPart(x, eps).power(n).times(k);
  }

  private Scalar damper(Scalar x, Scalar rate, Scalar elastic) {
    Scalar linear = c.isZero() ? c : rate.times(c).times(new SmoothPart(x, eps).slope());
    return chi.isZero() ? linear : linear.plus(rate.times(chi).times(elastic));
  }

  /** Returns the force, never negative. */
  Scalar force(Scalar x, Scalar rate) {
    return eps == 0 && chi.isZero() && !c.isZero() ? linear(x, rate) : any(x, rate);
  }

  /**
   * Returns the force with pos′ chosen outside of the bound: what is bounded, E + c x′, does not
   * jump at a touch, and its zero is where the push ends.
   */
  private Scalar linear(Scalar x, Scalar rate) {
    Expressions e = x.expressions();
    Scalar damper = rate.times(c);
    Scalar pressed = e.function(MathFunction.MAX, e.zero(), elastic(x).plus(damper));
    Scalar half = e.function(MathFunction.MAX, e.zero(), damper.times(0.5));
    Scalar touching = e.function(MathFunction.CHOOSE, e.zero(), x, half, e.zero());
    return e.function(MathFunction.CHOOSE, x, e.zero(), touching, pressed);
  }

  private Scalar any(Scalar x, Scalar rate) {
    Scalar elastic = elastic(x);
    Scalar damper = damper(x, rate, elastic);
    return damper.isZero() ? elastic : bounded(elastic, elastic.plus(damper));
  }

  private Scalar bounded(Scalar elastic, Scalar sum) {
    Expressions e = sum.expressions();
    if (eps == 0 || elastic.isZero()) {
      return e.function(MathFunction.MAX, e.zero(), sum);
    }
    // beyond ±1 of the share r the rounded part is constant: its slope there is 0
    Scalar half = elastic.times(0.5);
    Scalar share = sum.over(half.plus(e.constant(TINY)));
    Scalar below = e.function(MathFunction.MIN, e.one(), share);
    Scalar r = e.function(MathFunction.MAX, e.constant(-1), below);
    Scalar above = r.plus(e.one());
    Scalar cube = above.squared().times(above);
    Scalar factor = e.constant(7);
    for (int coefficient : new int[] {-42, 102, -122, 63}) {
      factor = r.times(factor).plus(e.constant(coefficient));
    }
    Scalar rounded = half.times(cube.squared().times(factor).times(1.0 / 512));
    return rounded.plus(e.function(MathFunction.MAX, e.zero(), sum.minus(half)));
  }

  /** Returns the damper's part of the force. */
  Scalar dissipative(Scalar x, Scalar rate) {
    boolean damped = !(c.isZero() && chi.isZero());
    return damped ? force(x, rate).minus(elastic(x)) : x.expressions().zero();
  }

  /** Returns the potential energy, J. */
  Scalar potential(Scalar x) {
    return k.isZero() ? k : new SmoothPart(x, eps).integral(n).times(k);
  }
}
