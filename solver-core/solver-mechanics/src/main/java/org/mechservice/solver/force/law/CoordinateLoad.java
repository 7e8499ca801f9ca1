package org.mechservice.solver.force.law;

import java.util.List;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;

/**
 * A force on one coordinate as a formula of its position and its rate.
 *
 * @param force positive if it increases the coordinate, N or N·m
 * @param potential potential energy, J; zero if it has none
 * @param power power of the part without potential energy, W, positive into the mechanism
 */
public record CoordinateLoad(Scalar force, Scalar potential, Scalar power) {
  /** Names of the coefficients of friction in printed methods. */
  static final List<String> FRICTION_SYMBOLS = List.of("coulomb", "speed", "viscous");

  /** Returns the load of a spring and damper: the negative tension. */
  public static CoordinateLoad ofSpring(SpringLaw law, Scalar position, Scalar rate) {
    return new CoordinateLoad(
        law.tension(position, rate).negated(),
        law.potential(position),
        law.dampingForce(position, rate).times(rate).negated());
  }

  /**
   * Returns friction: −coulomb v / √(v² + speed²) − viscous v.
   *
   * @param coulomb dry friction, N or N·m
   * @param viscous N·s/m or N·m·s/rad
   * @param speed rate at which dry friction has 1/√2 of its full force, m/s or rad/s
   */
  public static CoordinateLoad ofFriction(
      Scalar coulomb, Scalar viscous, Scalar speed, Scalar rate) {
    Expressions e = rate.expressions();
    Scalar force = rate.times(viscous.negated());
    if (!coulomb.isZero()) {
      Scalar root = rate.squared().plus(speed.squared()).squareRoot();
      Scalar dry = rate.over(root).times(coulomb);
      boolean isKnown = coulomb.isConstant();
      Scalar whole =
          isKnown ? dry : e.function(MathFunction.CHOOSE, coulomb, e.zero(), e.zero(), dry);
      force = force.minus(whole);
    }
    return new CoordinateLoad(force, e.zero(), force.times(rate));
  }
}
