package org.mechservice.mechml.unit;

import java.util.List;

/**
 * Physical quantity of an attribute: it determines the dimension of its unit and the unit of its
 * bare numbers.
 *
 * @param dimension of its unit
 * @param force the power of the unit of force in the unit of bare numbers
 */
public record Quantity(Dimension dimension, int force) {
  public static final Quantity NUMBER = new Quantity(Dimension.NONE, 0);
  public static final Quantity MASS = new Quantity(Dimension.MASS, 0);
  public static final Quantity LENGTH = new Quantity(Dimension.LENGTH, 0);
  public static final Quantity TIME = new Quantity(Dimension.TIME, 0);
  public static final Quantity ANGLE = new Quantity(Dimension.ANGLE, 0);
  public static final Quantity INERTIA = new Quantity(Dimension.INERTIA, 0);
  public static final Quantity DENSITY = new Quantity(new Dimension(1, -3, 0, 0), 0);
  public static final Quantity SPEED = new Quantity(new Dimension(0, 1, -1, 0), 0);
  public static final Quantity ANGULAR_SPEED = new Quantity(new Dimension(0, 0, -1, 1), 0);
  public static final Quantity ACCELERATION = new Quantity(Dimension.ACCELERATION, 0);
  public static final Quantity FORCE = new Quantity(Dimension.FORCE, 1);
  public static final Quantity TORQUE = new Quantity(Dimension.TORQUE, 1);

  /** Force per length. */
  public static final Quantity STIFFNESS = new Quantity(new Dimension(1, 0, -2, 0), 1);

  /** Force per speed. */
  public static final Quantity DAMPING = new Quantity(new Dimension(1, 0, -1, 0), 1);

  /** Torque per angle; a unit without rad means per rad. */
  public static final Quantity TORSIONAL_STIFFNESS = new Quantity(new Dimension(1, 2, -2, -1), 1);

  /** Torque per angular speed; likewise. */
  public static final Quantity TORSIONAL_DAMPING = new Quantity(new Dimension(1, 2, -1, -1), 1);

  /** Force per angle; likewise. */
  public static final Quantity FORCE_PER_ANGLE = new Quantity(new Dimension(1, 1, -2, -1), 1);

  /** Force per angular speed; likewise. */
  public static final Quantity FORCE_PER_ANGULAR_SPEED =
      new Quantity(new Dimension(1, 1, -1, -1), 1);

  /** Torque per speed. */
  public static final Quantity TORQUE_PER_SPEED = new Quantity(new Dimension(1, 1, -1, 0), 1);

  /** Length per angle: the pitch of a screw; likewise. */
  public static final Quantity PITCH = new Quantity(new Dimension(0, 1, 0, -1), 0);

  /** Of a contact: per speed. */
  public static final Quantity DISSIPATION = new Quantity(new Dimension(0, -1, 1, 0), 0);

  private static final List<Quantity> NAMED =
      List.of(
          NUMBER,
          MASS,
          LENGTH,
          TIME,
          ANGLE,
          INERTIA,
          DENSITY,
          SPEED,
          ANGULAR_SPEED,
          ACCELERATION,
          FORCE,
          TORQUE,
          STIFFNESS,
          DAMPING,
          TORSIONAL_STIFFNESS,
          TORSIONAL_DAMPING,
          FORCE_PER_ANGLE,
          FORCE_PER_ANGULAR_SPEED,
          TORQUE_PER_SPEED,
          PITCH,
          DISSIPATION);

  /** Returns the named quantities. */
  static List<Quantity> named() {
    return NAMED;
  }

  /**
   * Returns the quantity that a unit in SI measures; its bare numbers have the file's unit of force
   * where the unit is written with newtons, joules or watts.
   *
   * @throws IllegalArgumentException if there is no such unit
   */
  public static Quantity inSi(String unit) {
    try {
      Dimension dimension = UnitParser.parse(unit).dimension();
      boolean ofForce = unit.matches(".*[NJW].*");
      return new Quantity(dimension, ofForce ? dimension.mass() : 0);
    } catch (UnitException e) {
      throw new IllegalArgumentException(unit + " is no unit", e);
    }
  }

  /** Returns whether a unit measures it; units per angle may omit the angle. */
  public boolean isMeasuredBy(Unit unit) {
    Dimension given = unit.dimension();
    return given.equals(dimension)
        || (dimension.angle() == -1 && given.equals(dimension.times(Dimension.ANGLE)));
  }
}
