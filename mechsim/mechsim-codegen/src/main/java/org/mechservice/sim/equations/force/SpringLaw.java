package org.mechservice.sim.equations.force;

import org.mechservice.solver.mechanism.force.Side;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;

/**
 * A spring and damper of one coordinate z with rate z′: the tension T, positive against growing z.
 * With x = z − z0: T = F0 + k x + c x′ on both sides, the push of a {@link PushLaw} of x above, and
 * its opposite with y = −x below.
 *
 * @param side side on which it acts
 * @param k stiffness
 * @param c damping
 * @param chi dissipation
 * @param rest z0
 * @param preload F0
 * @param eps smoothing of pos
 */
record SpringLaw(
    Side side, Scalar k, Scalar c, Scalar chi, Scalar rest, Scalar preload, double eps) {
  /** Tension, relative to its terms, that counts as zero. */
  private static final double NO_TENSION = 1e-9;

  private Scalar elongation(Scalar z) {
    return z.minus(rest);
  }

  private PushLaw push() {
    return new PushLaw(k, 1, c, chi, eps);
  }

  /** Returns a value with the sign of the side. */
  private Scalar signed(Scalar value) {
    return side == Side.ABOVE ? value : value.negated();
  }

  /** Returns whether there is no tension at z = z′ = 0, up to rounding of its terms. */
  boolean isSlackAtZero(Expressions e) {
    Scalar tension = tension(e.zero(), e.zero());
    double size = Math.abs(k.value()) * (Math.abs(rest.value()) + eps);
    double scale = Math.abs(preload.value()) + size;
    return tension.isConstant() && Math.abs(tension.value()) <= NO_TENSION * scale;
  }

  /** Returns the part of the tension without potential energy: that of the damper. */
  Scalar dampingForce(Scalar z, Scalar rate) {
    if (side == Side.BOTH) {
      return c.isZero() ? z.expressions().zero() : rate.times(c);
    }
    return signed(push().dissipative(signed(elongation(z)), signed(rate)));
  }

  /** Returns the tension. */
  Scalar tension(Scalar z, Scalar rate) {
    if (side == Side.BOTH) {
      return preload.plus(elongation(z).times(k)).plus(dampingForce(z, rate));
    }
    return signed(push().force(signed(elongation(z)), signed(rate)));
  }

  /** Returns the energy of the spring, zero at the rest position. */
  Scalar potential(Scalar z) {
    if (side == Side.BOTH) {
      Scalar x = elongation(z);
      return x.times(k.times(0.5)).plus(preload).times(x);
    }
    return push().potential(signed(elongation(z)));
  }
}
