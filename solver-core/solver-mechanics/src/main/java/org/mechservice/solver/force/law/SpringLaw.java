package org.mechservice.solver.force.law;

import java.util.List;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;

/**
 * A spring and damper of one coordinate z with rate z′: the tension T, positive against growing z.
 * With x = z − z0: T = F0 + k x + c x′ on both sides, the push of a {@link PushLaw} of x above, and
 * its opposite with y = −x below.
 *
 * @param side side on which it acts
 * @param k stiffness, N/m or N·m/rad
 * @param c damping, N·s/m or N·m·s/rad
 * @param rest z0, m or rad
 * @param preload F0, N or N·m; not used unless it acts on both sides
 * @param eps smoothing ε of pos, m or rad; not used if it acts on both sides
 * @param chi dissipation χ, s/m or s/rad; not used if it acts on both sides
 */
public record SpringLaw(
    Side side, Scalar k, Scalar c, Scalar rest, Scalar preload, Scalar eps, Scalar chi) {
  /** Names of the coefficients in printed methods. */
  static final List<String> SYMBOLS =
      List.of("stiffness", "damping", "rest", "preload", "eps", "chi");

  /** Returns the law of coefficients in the order of the elements: k, c, z0, F0, ε, χ. */
  public static SpringLaw of(Side side, List<Scalar> c) {
    return new SpringLaw(side, c.get(0), c.get(1), c.get(2), c.get(3), c.get(4), c.get(5));
  }

  private Expressions expressions() {
    return k.expressions();
  }

  private Scalar elongation(Scalar z) {
    return z.minus(rest);
  }

  private PushLaw push() {
    return new PushLaw(k, expressions().one(), c, chi, eps);
  }

  /** Returns a value with the sign of the side. */
  private Scalar signed(Scalar value) {
    return side == Side.ABOVE ? value : value.negated();
  }

  /** Returns the part of the tension without potential energy: that of the damper. */
  Scalar dampingForce(Scalar z, Scalar rate) {
    if (side == Side.BOTH) {
      return c.isZero() ? expressions().zero() : rate.times(c);
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

  /** Returns the energy of spring and preload, zero at the rest position, J. */
  Scalar potential(Scalar z) {
    if (side == Side.BOTH) {
      Scalar x = elongation(z);
      return x.times(k.times(0.5)).plus(preload).times(x);
    }
    return push().potential(signed(elongation(z)));
  }
}
