package org.mechservice.robot;

import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.spatial.EulerParameters;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * A robot as its file describes it, in SI units, whatever the format.
 *
 * @param format its format
 * @param name name of the robot
 * @param gravity acceleration of free fall, m/s²; empty if the format leaves it to the simulator
 * @param links in file order
 * @param joints in file order
 */
record Robot(
    RobotFormat format,
    String name,
    Optional<Vector3> gravity,
    List<Link> links,
    List<Joint> joints) {
  /**
   * A frame in another one.
   *
   * @param at its origin, in the other's axes, m
   * @param turn from its axes to those of the other
   */
  record Frame(Vector3 at, Rotation turn) {
    static final Frame SAME = new Frame(Vector3.ZERO, Rotation.IDENTITY);

    private static final Vector3 X = new Vector3(1, 0, 0);
    private static final Vector3 Y = new Vector3(0, 1, 0);
    private static final Vector3 Z = new Vector3(0, 0, 1);

    /**
     * Returns the frame with the rotation Rz(yaw) Ry(pitch) Rx(roll).
     *
     * @param at its origin, m
     * @param rpy roll, pitch and yaw about the other's axes x, y and z, one after the other, rad
     */
    static Frame ofRollPitchYaw(Vector3 at, Vector3 rpy) {
      return new Frame(
          at,
          rpy.equals(Vector3.ZERO)
              ? Rotation.IDENTITY
              : Rotation.about(Z, rpy.z())
                  .times(Rotation.about(Y, rpy.y()))
                  .times(Rotation.about(X, rpy.x())));
    }

    /** Returns the frame that an inner frame of this one has in the other. */
    Frame times(Frame inner) {
      return new Frame(at.plus(turn.apply(inner.at)), turn.times(inner.turn));
    }

    /** Returns the other frame in this one. */
    Frame inverse() {
      Rotation back = turn.transposed();
      return new Frame(back.apply(at).negated(), back);
    }

    /** Returns the Euler parameters of its rotation, e0 not negative. */
    List<Double> eulerParameters() {
      double[] r = {
        turn.xx(), turn.xy(), turn.xz(),
        turn.yx(), turn.yy(), turn.yz(),
        turn.zx(), turn.zy(), turn.zz()
      };
      double[] e = new double[4];
      EulerParameters.of(r, 0, e, 0);
      return List.of(e[0], e[1], e[2], e[3]);
    }
  }

  /**
   * A body.
   *
   * @param element its element in the file
   * @param name name of the body
   * @param inertial its inertia, if it has any
   * @param mesh file of its visual, if that is a mesh
   */
  record Link(Element element, String name, Optional<Inertial> inertial, Optional<String> mesh) {}

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
    REVOLUTE("R"),
    CONTINUOUS("R"),
    PRISMATIC("P"),
    SCREW("H"),
    SPHERICAL("S"),
    FIXED("W"),
    FLOATING("F"),
    PLANAR("PL");

    private final String letter;

    Freedom(String letter) {
      this.letter = letter;
    }

    /** Returns the type of the joint in MechML. */
    String letter() {
      return letter;
    }

    /** Returns whether the joint has an axis. */
    boolean hasAxis() {
      return this != FIXED && this != FLOATING && this != SPHERICAL;
    }

    /** Returns whether the joint's coordinates are Euler parameters. */
    boolean turnsFreely() {
      return this == FLOATING || this == SPHERICAL;
    }

    /** Returns whether the joint has one coordinate, so that others may follow it. */
    boolean isSingle() {
      return this == REVOLUTE || this == CONTINUOUS || this == PRISMATIC || this == SCREW;
    }
  }

  /**
   * A joint.
   *
   * @param element its element in the file
   * @param name name of the joint
   * @param type its type
   * @param parent name of the link nearer the root
   * @param child name of the link beyond
   * @param place where it is
   * @param coordinate what acts along its coordinate; of joints that have one coordinate
   */
  record Joint(
      Element element,
      String name,
      Freedom type,
      String parent,
      String child,
      Place place,
      Coordinate coordinate) {}

  /**
   * The place of a joint.
   *
   * @param frame the child's frame at zero, in the parent's
   * @param point a point on the axis, in the child's axes from the child's origin, m
   * @param axis unit vector in the child's axes
   * @param lead advance of a screw along its axis in one turn, m
   */
  record Place(Frame frame, Vector3 point, Vector3 axis, double lead) {
    /** Returns the place of a joint with one axis through the child's origin. */
    static Place at(Frame frame, Vector3 axis) {
      return along(frame, Vector3.ZERO, axis);
    }

    /** Returns the place of a joint with one axis. */
    static Place along(Frame frame, Vector3 point, Vector3 axis) {
      return new Place(frame, point, axis, 0);
    }

    /** Returns the joint's point from the parent's origin, in the parent's axes, m. */
    Vector3 pointOnParent() {
      return frame.at().plus(frame.turn().apply(point));
    }

    /**
     * Returns a unit vector normal to the axis, in the child's axes; a coordinate axis if possible.
     */
    Vector3 side() {
      double x = Math.abs(axis.x());
      double y = Math.abs(axis.y());
      double z = Math.abs(axis.z());
      Vector3 least =
          x <= y && x <= z
              ? new Vector3(1, 0, 0)
              : y <= z ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1);
      return least.minus(axis.times(axis.dot(least))).normalized();
    }
  }

  /**
   * Limits and forces along the coordinate of a joint, rad or m.
   *
   * @param limits lowest and highest position
   * @param stiffness of a spring, N/m or N·m/rad
   * @param freePosition position at which the spring exerts nothing
   * @param damping N·s/m or N·m·s/rad
   * @param friction N or N·m
   * @param mimic the joint that it follows
   */
  record Coordinate(
      Optional<Range> limits,
      double stiffness,
      double freePosition,
      double damping,
      double friction,
      Optional<Mimic> mimic) {
    static final Coordinate FREE = new Coordinate(Optional.empty(), 0, 0, 0, 0, Optional.empty());
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
