package org.mechservice.solver.mechanism.joint;

import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

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

  /**
   * Returns the joint's axes as its record defines them, unit vectors: none, one, or that of the
   * file's body 1 and that of its body 2.
   */
  default List<Vector3> axes() {
    return List.of();
  }

  /**
   * Returns whether the tree leads from the file's body 2 to its body 1 and the record still
   * describes the joint in the file's sense. It is false for joints that are described by their
   * parent's axes either way.
   */
  default boolean fileBody2IsParent() {
    return false;
  }

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
