package org.mechservice.mechml.unit;

/**
 * The units of a model file's bare numbers; time is always in s.
 *
 * @param mass unit of masses
 * @param length unit of lengths
 * @param angle unit of angles
 * @param force unit of forces
 */
public record UnitSystem(Unit mass, Unit length, Unit angle, Unit force) {
  private static final Unit SECOND = new Unit(1, 1, Dimension.TIME);
  private static final Unit RADIAN = new Unit(1, 1, Dimension.ANGLE);

  /** Units whose force is mass · length / s². */
  public static UnitSystem composed(Unit mass, Unit length, Unit angle) {
    return new UnitSystem(mass, length, angle, mass.times(length).times(SECOND.power(-2)));
  }

  /**
   * Returns the unit of bare numbers of a quantity. Quantities per angle are per rad, also if the
   * file's unit of angles is deg.
   */
  public Unit of(Quantity quantity) {
    return composed(quantity.dimension(), quantity.force(), angle);
  }

  /**
   * Returns the unit in which an expression sees a value of a dimension: the file's unit, except
   * that angles are in rad.
   */
  public Unit inExpressions(Dimension dimension) {
    int forces =
        Quantity.named().stream()
            .filter(quantity -> quantity.dimension().equals(dimension))
            .findFirst()
            .map(Quantity::force)
            .orElse(0);
    return composed(dimension, forces, RADIAN);
  }

  private Unit composed(Dimension dimension, int forces, Unit angles) {
    Unit perAngle = dimension.angle() < 0 ? RADIAN : angles;
    return force
        .power(forces)
        .times(mass.power(dimension.mass() - forces))
        .times(length.power(dimension.length() - forces))
        .times(SECOND.power(dimension.time() + 2 * forces))
        .times(perAngle.power(dimension.angle()));
  }
}
