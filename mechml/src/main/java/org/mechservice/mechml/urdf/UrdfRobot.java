package org.mechservice.mechml.urdf;

import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * The content of a URDF file; URDF is always in SI units.
 *
 * @param name name of the robot
 * @param links in file order
 * @param joints in file order
 */
record UrdfRobot(String name, List<Link> links, List<Joint> joints) {
  /**
   * A frame in another one.
   *
   * @param at its origin, m
   * @param rpy roll, pitch and yaw about the other's axes x, y and z, one after the other, rad
   */
  record Frame(Vector3 at, Vector3 rpy) {
    static final Frame SAME = new Frame(Vector3.ZERO, Vector3.ZERO);

    private static final Vector3 X = new Vector3(1, 0, 0);
    private static final Vector3 Y = new Vector3(0, 1, 0);
    private static final Vector3 Z = new Vector3(0, 0, 1);

    /** Returns the rotation from its axes to those of the other: Rz(yaw) Ry(pitch) Rx(roll). */
    Rotation turn() {
      return rpy.equals(Vector3.ZERO)
          ? Rotation.IDENTITY
          : Rotation.about(Z, rpy.z())
              .times(Rotation.about(Y, rpy.y()))
              .times(Rotation.about(X, rpy.x()));
    }

    /** Returns the Euler parameters of the same rotation. */
    List<Double> eulerParameters() {
      double cr = StrictMath.cos(rpy.x() / 2);
      double sr = StrictMath.sin(rpy.x() / 2);
      double cp = StrictMath.cos(rpy.y() / 2);
      double sp = StrictMath.sin(rpy.y() / 2);
      double cy = StrictMath.cos(rpy.z() / 2);
      double sy = StrictMath.sin(rpy.z() / 2);
      return List.of(
          cr * cp * cy + sr * sp * sy,
          sr * cp * cy - cr * sp * sy,
          cr * sp * cy + sr * cp * sy,
          cr * cp * sy - sr * sp * cy);
    }
  }

  /**
   * A body.
   *
   * @param element its element in the file
   * @param inertial its inertia, if it has any
   * @param mesh file of its visual, if that is a mesh
   */
  record Link(Element element, Optional<Inertial> inertial, Optional<String> mesh) {
    String name() {
      return element.required("name");
    }
  }

  /**
   * Mass and inertia of a link.
   *
   * @param element their element in the file
   * @param frame at the centre of mass, in the link's frame
   * @param mass kg
   * @param moments xx, yy, zz, xy, xz, yz of the tensor about the centre of mass in the axes of
   *     {@code frame}, kg·m²
   */
  record Inertial(Element element, Frame frame, double mass, List<Double> moments) {}

  /** Type of a joint. */
  enum Freedom {
    REVOLUTE,
    CONTINUOUS,
    PRISMATIC,
    FIXED,
    FLOATING,
    PLANAR;

    boolean hasAxis() {
      return this != FIXED && this != FLOATING;
    }

    /** Returns whether the joint has one coordinate, so that others may follow it. */
    boolean isSingle() {
      return this == REVOLUTE || this == CONTINUOUS || this == PRISMATIC;
    }
  }

  /**
   * A joint.
   *
   * @param element its element in the file
   * @param type its type
   * @param parent name of the link nearer the root
   * @param child name of the link beyond
   * @param frame the child's frame at zero, in the parent's
   * @param axis in the child's axes
   * @param limits lowest and highest position
   * @param damping N·s/m or N·m·s/rad
   * @param friction N or N·m
   * @param mimic the joint that it follows
   */
  record Joint(
      Element element,
      Freedom type,
      String parent,
      String child,
      Frame frame,
      Vector3 axis,
      Optional<Range> limits,
      double damping,
      double friction,
      Optional<Mimic> mimic) {
    String name() {
      return element.required("name");
    }
  }

  /** Range of a coordinate. */
  record Range(double lower, double upper) {
    double nearestToZero() {
      return Math.max(lower, Math.min(upper, 0));
    }
  }

  /**
   * A joint follows another: q = multiplier · other + offset.
   *
   * @param element its element in the file
   * @param joint name of the other
   */
  record Mimic(Element element, String joint, double multiplier, double offset) {}
}
