package org.mechservice.sim.equations.force;

import org.mechservice.sim.symbolic.Expressions;
import org.mechservice.sim.symbolic.Scalar;
import org.mechservice.solver.mechanism.force.Side;

/**
 * A spring and damper of one coordinate z with rate z′: the tension T, positive against growing z.
 * With x = z − z0: T = F0 + k x + c x′ on both sides, k pos(x) + c x′ pos′(x) above, −(k pos(y) + c
 * y′ pos′(y)) with y = −x below.
 *
 * @param side side on which it acts
 * @param k stiffness
 * @param c damping
 * @param rest z0
 * @param preload F0
 * @param eps smoothing of pos
 */
record SpringLaw(Side side, Scalar k, Scalar c, Scalar rest, Scalar preload, double eps) {
  /** Tension, relative to its terms, that counts as zero. */
  private static final double NO_TENSION = 1e-9;

  private Scalar elongation(Scalar z) {
    return z.minus(rest);
  }

  private SmoothPart part(Scalar z) {
    Scalar x = elongation(z);
    return new SmoothPart(side == Side.ABOVE ? x : x.negated(), eps);
  }

  /** Returns whether there is no tension at z = z′ = 0, up to rounding of its terms. */
  boolean isSlackAtZero(Expressions e) {
    Scalar tension = tension(e.zero(), e.zero());
    double size = Math.abs(k.value()) * (Math.abs(rest.value()) + eps);
    double scale = Math.abs(preload.value()) + size;
    return tension.isConstant() && Math.abs(tension.value()) <= NO_TENSION * scale;
  }

  /** Returns the damper's part of the tension. */
  Scalar dampingForce(Scalar z, Scalar rate) {
    if (c.isZero()) {
      return z.expressions().zero();
    }
    Scalar force = rate.times(c);
    return side == Side.BOTH ? force : force.times(part(z).slope());
  }

  /** Returns the tension. */
  Scalar tension(Scalar z, Scalar rate) {
    Expressions e = z.expressions();
    Scalar damping = dampingForce(z, rate);
    if (side == Side.BOTH) {
      return preload.plus(elongation(z).times(k)).plus(damping);
    }
    Scalar spring =
        k.isZero() ? e.zero() : part(z).value().times(side == Side.ABOVE ? k : k.negated());
    return spring.plus(damping);
  }

  /** Returns the energy of the spring, zero at the rest position. */
  Scalar potential(Scalar z) {
    Expressions e = z.expressions();
    if (side == Side.BOTH) {
      Scalar x = elongation(z);
      return x.times(k.times(0.5)).plus(preload).times(x);
    }
    return k.isZero() ? e.zero() : part(z).integral(1).times(k);
  }
}
