package org.mechservice.mechml.unit;

/**
 * The units of a model file's bare numbers; time is always in s.
 *
 * @param mass unit of masses
 * @param length unit of lengths
 * @param angle unit of angles
 */
public record UnitSystem(Unit mass, Unit length, Unit angle) {
  private static final Unit SECOND = new Unit(1, 1, Dimension.TIME);

  /** Returns the unit of bare numbers of a dimension, composed of the base units. */
  public Unit of(Dimension dimension) {
    return mass.power(dimension.mass())
        .times(length.power(dimension.length()))
        .times(SECOND.power(dimension.time()))
        .times(angle.power(dimension.angle()));
  }
}
