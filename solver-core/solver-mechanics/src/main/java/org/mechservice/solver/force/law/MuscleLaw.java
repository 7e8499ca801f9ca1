package org.mechservice.solver.force.law;

import java.util.List;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;

/**
 * A muscle of Hill's kind without a tendon of its own: its tension by length, rate and activation,
 * and how the activation follows the excitation.
 *
 * <p>Legend: L, V length and rate in units of the length L₀ at which it is strongest; a the
 * activation; F₀ its peak force. The tension is
 *
 * <pre>
 * F₀ (a f_L(L) f_V(V) + f_P(L))
 * </pre>
 *
 * with f_L of four parabolas between l_min and l_max that is 1 at 1; f_V = (1 + V)² while it
 * shortens, no slower than −1, and a parabola up to f_vmax while it lengthens; and f_P a parabola
 * from 1 on and a straight line from (1 + l_max)/2 on. All are continuous with their slopes. The
 * activation follows the excitation u with a time constant for each way, a′ = (u − a)/τ,
 *
 * <pre>
 * τ = τ_act (0.5 + 1.5 a) where u > a,  τ_deact / (0.5 + 1.5 a) where u < a
 * </pre>
 *
 * or a blend of both over a width of u − a. Sources: MuJoCo documentation, Modeling, "Muscles", and
 * engine_util_misc.c; Millard, Uchida, Seth and Delp 2013, Flexing computational muscle, J.
 * Biomech. Eng. 135, for the activation.
 *
 * @param e of the scalars
 * @param force F₀, N
 * @param shortest length at {@code low}, m
 * @param longest length at {@code high}, m
 * @param low L of the shortest length
 * @param high L of the longest
 * @param least l_min, at most 1
 * @param most l_max, at least 1
 * @param fastest V = −1 at this speed, L₀/s
 * @param passive f_P at l_max
 * @param eccentric f_vmax, at least 1
 */
public record MuscleLaw(
    Expressions e,
    Scalar force,
    Scalar shortest,
    Scalar longest,
    Scalar low,
    Scalar high,
    Scalar least,
    Scalar most,
    Scalar fastest,
    Scalar passive,
    Scalar eccentric) {
  /** Least divisor, as MuJoCo's. */
  private static final double TINY = 1e-15;

  /** Returns the tension, N, at a length, m, a rate of it, m/s, and an activation. */
  public Scalar tension(Scalar length, Scalar rate, Scalar activation) {
    Scalar unit = unit();
    Scalar l = low.plus(length.minus(shortest).over(unit));
    Scalar v = rate.over(divisor(unit.times(fastest)));
    Scalar tension = force.times(activation.times(byLength(l)).times(byRate(v)).plus(passive(l)));
    // its curves join with their slopes, and none is narrow
    return e.whole(MathFunction.SMOOTH, List.of(tension));
  }

  /** Returns by how much a length exceeds that of l_min, from which on the muscle pulls, m. */
  public Scalar stretch(Scalar length) {
    return length.minus(shortest.plus(least.minus(low).times(unit())));
  }

  private Scalar unit() {
    return divisor(longest.minus(shortest).over(divisor(high.minus(low))));
  }

  private Scalar byLength(Scalar l) {
    Scalar one = e.one();
    Scalar below = half(least.plus(one));
    Scalar above = half(one.plus(most));
    Scalar rising = half(l.minus(least).over(divisor(below.minus(least))).squared());
    Scalar left = one.minus(half(one.minus(l).over(divisor(one.minus(below))).squared()));
    Scalar right = one.minus(half(l.minus(one).over(divisor(above.minus(one))).squared()));
    Scalar falling = half(most.minus(l).over(divisor(most.minus(above))).squared());
    Scalar curve = upTo(l, below, rising, upTo(l, one, left, upTo(l, above, right, falling)));
    return upTo(least, l, upTo(l, most, curve, e.zero()), e.zero());
  }

  private Scalar byRate(Scalar v) {
    Scalar one = e.one();
    Scalar lengthening = eccentric.minus(one);
    Scalar shortens = v.plus(one).squared();
    Scalar lengthens = eccentric.minus(lengthening.minus(v).squared().over(divisor(lengthening)));
    return upTo(
        v,
        e.constant(-1),
        e.zero(),
        upTo(v, e.zero(), shortens, upTo(v, lengthening, lengthens, eccentric)));
  }

  private Scalar passive(Scalar l) {
    Scalar one = e.one();
    Scalar above = half(one.plus(most));
    Scalar width = divisor(above.minus(one));
    Scalar parabola = half(l.minus(one).over(width).squared());
    Scalar line = e.constant(0.5).plus(l.minus(above).over(width));
    return passive.times(upTo(l, one, e.zero(), upTo(l, above, parabola, line)));
  }

  /**
   * Returns the rate of an activation, 1/s.
   *
   * @param excitation u, which is taken between 0 and 1
   * @param activation a
   * @param rising τ_act, s
   * @param falling τ_deact, s
   * @param width of u − a over which both blend; 0: none
   */
  public static Scalar activationRate(
      Scalar excitation, Scalar activation, Scalar rising, Scalar falling, double width) {
    Expressions e = activation.expressions();
    Scalar wish = between(excitation);
    Scalar share = e.constant(0.5).plus(between(activation).times(1.5));
    Scalar up = rising.times(share);
    Scalar down = falling.over(share);
    Scalar excess = wish.minus(activation);
    Scalar time;
    if (width > 0) {
      Scalar x = between(excess.over(e.constant(width)).plus(e.constant(0.5)));
      // 6 x⁵ − 15 x⁴ + 10 x³
      Scalar inner = x.times(x.times(6).minus(e.constant(15))).plus(e.constant(10));
      time = down.plus(up.minus(down).times(x.squared().times(x).times(inner)));
    } else {
      time = e.function(MathFunction.CHOOSE, excess, e.zero(), down, up);
    }
    return excess.over(e.function(MathFunction.MAX, time, e.constant(TINY)));
  }

  private static Scalar between(Scalar x) {
    Expressions e = x.expressions();
    Scalar below = e.function(MathFunction.MIN, e.one(), x);
    return e.function(MathFunction.MAX, e.zero(), below);
  }

  private Scalar divisor(Scalar x) {
    return e.function(MathFunction.MAX, x, e.constant(TINY));
  }

  private Scalar half(Scalar x) {
    return x.times(0.5);
  }

  /** Returns one value where x is at most a bound, else another. */
  private Scalar upTo(Scalar x, Scalar bound, Scalar one, Scalar other) {
    return e.function(MathFunction.CHOOSE, x, bound, one, other);
  }
}
