package org.mechservice.mechml.unit;

import java.util.stream.Stream;

/**
 * Physical quantity of an attribute: it determines the dimension of its unit and the unit of its
 * bare numbers.
 */
public enum Quantity {
  NUMBER(Dimension.NONE, 0),
  MASS(Dimension.MASS, 0),
  LENGTH(Dimension.LENGTH, 0),
  TIME(Dimension.TIME, 0),
  ANGLE(Dimension.ANGLE, 0),
  INERTIA(Dimension.INERTIA, 0),
  DENSITY(new Dimension(1, -3, 0, 0), 0),
  SPEED(new Dimension(0, 1, -1, 0), 0),
  ANGULAR_SPEED(new Dimension(0, 0, -1, 1), 0),
  ACCELERATION(Dimension.ACCELERATION, 0),
  FORCE(Dimension.FORCE, 1),
  TORQUE(Dimension.TORQUE, 1),
  /** Force per length. */
  STIFFNESS(new Dimension(1, 0, -2, 0), 1),
  /** Force per speed. */
  DAMPING(new Dimension(1, 0, -1, 0), 1),
  /** Torque per angle; a unit without rad means per rad. */
  TORSIONAL_STIFFNESS(new Dimension(1, 2, -2, -1), 1),
  /** Torque per angular speed; likewise. */
  TORSIONAL_DAMPING(new Dimension(1, 2, -1, -1), 1),
  /** Force per angle; likewise. */
  FORCE_PER_ANGLE(new Dimension(1, 1, -2, -1), 1),
  /** Force per angular speed; likewise. */
  FORCE_PER_ANGULAR_SPEED(new Dimension(1, 1, -1, -1), 1),
  /** Torque per speed. */
  TORQUE_PER_SPEED(new Dimension(1, 1, -1, 0), 1),
  /** Length per angle: the pitch of a screw; likewise. */
  PITCH(new Dimension(0, 1, 0, -1), 0),
  /** Of a contact: per speed. */
  DISSIPATION(new Dimension(0, -1, 1, 0), 0),
  /** Force times area: of forces by the inverse square of a distance. */
  FORCE_TIMES_AREA(new Dimension(1, 3, -2, 0), 1);

  @SuppressWarnings("ImmutableEnumChecker") // a record of numbers
  private final Dimension dimension;

  private final int force;

  Quantity(Dimension dimension, int force) {
    this.dimension = dimension;
    this.force = force;
  }

  /**
   * Returns the quantity of a unit in SI; of those with one dimension the first.
   *
   * @throws IllegalArgumentException if there is no such unit, or no quantity that it measures
   */
  public static Quantity inSi(String unit) {
    try {
      Dimension dimension = UnitParser.parse(unit).dimension();
      return Stream.of(values())
          .filter(quantity -> quantity.dimension.equals(dimension))
          .findFirst()
          .orElseThrow(() -> new IllegalArgumentException("no quantity is measured in " + unit));
    } catch (UnitException e) {
      throw new IllegalArgumentException(unit + " is no unit", e);
    }
  }

  /** Returns the dimension of its unit. */
  public Dimension dimension() {
    return dimension;
  }

  /** Returns the power of the unit of force in the unit of bare numbers. */
  int force() {
    return force;
  }

  /** Returns whether a unit measures it; units per angle may omit the angle. */
  public boolean isMeasuredBy(Unit unit) {
    Dimension given = unit.dimension();
    return given.equals(dimension)
        || (dimension.angle() == -1 && given.equals(dimension.times(Dimension.ANGLE)));
  }
}
