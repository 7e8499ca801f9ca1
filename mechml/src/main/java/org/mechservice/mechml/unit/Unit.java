package org.mechservice.mechml.unit;

/**
 * A unit of measurement: 1 unit = numerator / denominator in SI. The two factors keep 3 mm at the
 * double nearest to 0.003 m; 1/1000 alone has no exact binary form.
 *
 * @param numerator factor to SI
 * @param denominator divisor to SI
 * @param dimension its dimension
 */
public record Unit(double numerator, double denominator, Dimension dimension) {
  /** The unit of pure numbers. */
  public static final Unit ONE = new Unit(1, 1, Dimension.NONE);

  /** Returns a value given in this unit in SI; infinite if that is too large for a double. */
  public double toSi(double value) {
    return value * numerator / denominator;
  }

  /** Returns a value given in SI in this unit; infinite if that is too large for a double. */
  public double fromSi(double value) {
    return value * denominator / numerator;
  }

  /** Returns the product of two units. */
  public Unit times(Unit other) {
    return new Unit(
        numerator * other.numerator,
        denominator * other.denominator,
        dimension.times(other.dimension));
  }

  /** Returns a whole power of the unit, also a negative one. */
  public Unit power(int n) {
    Unit power = ONE;
    for (int i = 0; i < Math.abs(n); i++) {
      power = power.times(n > 0 ? this : inverse());
    }
    return power;
  }

  private Unit inverse() {
    return new Unit(
        /* numerator= */ denominator, /* denominator= */ numerator, dimension.power(-1));
  }
}
