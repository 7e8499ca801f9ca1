package org.mechservice.solver.mechanism;

import org.mechservice.solver.api.JointType;

/** A joint of the tree: it moves its child body relative to its parent body. */
public sealed interface Joint
    permits Revolute, Prismatic, Cylindrical, Universal, Spherical, Planar, Screw, Free, Weld {
  /** Returns the name in the model file. */
  String name();

  /** Returns the bodies that it connects and their relative pose at zero. */
  Attachment attachment();

  /** Returns its position in the model file. */
  Origin origin();

  /** Returns the joint's type, which determines the number of coordinates. */
  JointType type();

  /** Returns the unit of a force that acts along a velocity, which is N·m or N. */
  default String forceUnit(int component) {
    return type().velocityUnit(component).startsWith("rad") ? "N·m" : "N";
  }

  /**
   * Returns the joint with parent and child exchanged; the coordinates keep their sense (motion of
   * the file's body 2 relative to its body 1).
   */
  Joint reversed();

  /**
   * Writes the joint's coordinates at the start.
   *
   * @param q positions, rad or m; {@code type().positionCount()} of them from {@code offset}
   *     overwritten
   */
  void initialPositions(double[] q, int offset);

  /**
   * Writes the joint's velocities at the start.
   *
   * @param v velocities, rad/s or m/s; {@code type().velocityCount()} of them from {@code offset}
   *     overwritten
   */
  void initialVelocities(double[] v, int offset);
}
