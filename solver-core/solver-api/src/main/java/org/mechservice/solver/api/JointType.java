package org.mechservice.solver.api;

/**
 * The joints of MechML with the units of their coordinates, in state order (docs/mechml.md#joints).
 */
public enum JointType {
  /** Rotation about a vector. */
  R("rad", "rad/s"),
  /** Displacement along a vector. */
  P("m", "m/s"),
  /** Displacement along and rotation about a vector. */
  C("m rad", "m/s rad/s"),
  /** Rotation about the vector of body 1, then about the vector of body 2. */
  U("rad rad", "rad/s rad/s"),
  /** Spherical: Euler parameters, angular velocity in the axes of body 1. */
  S("1 1 1 1", "rad/s rad/s rad/s"),
  /** Planar: two displacements and an angle. */
  PL("m m rad", "m/s m/s rad/s"),
  /** Screw. */
  H("rad", "rad/s"),
  /** Free: Euler parameters and position, angular and linear velocity in the axes of body 1. */
  F("1 1 1 1 m m m", "rad/s rad/s rad/s m/s m/s m/s"),
  /** Weld. */
  W("", "");

  private final String positionUnits;
  private final String velocityUnits;

  JointType(String positionUnits, String velocityUnits) {
    this.positionUnits = positionUnits;
    this.velocityUnits = velocityUnits;
  }

  private static String[] split(String units) {
    return units.isEmpty() ? new String[0] : units.split(" ", -1);
  }

  /** Returns the number of positions q of the joint in the state. */
  public int positionCount() {
    return split(positionUnits).length;
  }

  /** Returns the number of velocities v of the joint in the state. */
  public int velocityCount() {
    return split(velocityUnits).length;
  }

  /** Returns the unit of the joint's position {@code index}. */
  public String positionUnit(int index) {
    return split(positionUnits)[index];
  }

  /** Returns the unit of the joint's velocity {@code index}. */
  public String velocityUnit(int index) {
    return split(velocityUnits)[index];
  }

  /** Returns whether the first four positions are Euler parameters. */
  public boolean hasEulerParameters() {
    return this == S || this == F;
  }
}
