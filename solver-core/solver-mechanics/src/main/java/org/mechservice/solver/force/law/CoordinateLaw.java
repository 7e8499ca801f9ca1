package org.mechservice.solver.force.law;

import java.util.List;
import org.mechservice.solver.symbol.Scalar;

/**
 * The laws of forces on one coordinate: each a formula of its position, its rate and coefficients.
 *
 * <p>A printed law has these two variables; it puts out the load, one number, positive if it
 * increases the coordinate; its derivatives by position and rate; and results as {@link PairLaw}
 * does, without values.
 */
public enum CoordinateLaw {
  SPRING,
  /** A spring above its rest position, the upper stop of a joint. */
  UPPER_STOP,
  /** A spring below its rest position, the lower stop of a joint. */
  LOWER_STOP,
  FRICTION;

  /** Number of variables of a printed law. */
  public static final int VARIABLES = 2;

  /** Returns the law of a spring. */
  public static CoordinateLaw of(Side side) {
    return switch (side) {
      case BOTH -> SPRING;
      case ABOVE -> UPPER_STOP;
      case BELOW -> LOWER_STOP;
    };
  }

  /** Returns the number of coefficients. */
  public int coefficientCount() {
    return symbols().size();
  }

  /** Returns the coefficient for which a law is printed twice, as {@link PairLaw#smoothing}. */
  public int smoothing() {
    return this == UPPER_STOP || this == LOWER_STOP ? symbols().indexOf("eps") : -1;
  }

  /** Returns the names of the coefficients in printed methods. */
  public List<String> symbols() {
    return this == FRICTION ? CoordinateLoad.FRICTION_SYMBOLS : SpringLaw.SYMBOLS;
  }

  /**
   * Returns the load as formulas.
   *
   * @param coefficients in the order of the element's
   */
  public CoordinateLoad of(Scalar position, Scalar rate, List<Scalar> coefficients) {
    return switch (this) {
      case SPRING -> spring(Side.BOTH, position, rate, coefficients);
      case UPPER_STOP -> spring(Side.ABOVE, position, rate, coefficients);
      case LOWER_STOP -> spring(Side.BELOW, position, rate, coefficients);
      case FRICTION ->
          CoordinateLoad.ofFriction(
              coefficients.get(0), coefficients.get(2), coefficients.get(1), rate);
    };
  }

  private static CoordinateLoad spring(Side side, Scalar position, Scalar rate, List<Scalar> c) {
    return CoordinateLoad.ofSpring(SpringLaw.of(side, c), position, rate);
  }
}
