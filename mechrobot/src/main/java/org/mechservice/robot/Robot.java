package org.mechservice.robot;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
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
 * @param loops equations between two links, in file order
 * @param couplings equations between coordinates, in file order
 * @param forces in file order
 * @param starts positions and velocities at the start by joint name, where the file gives them
 */
record Robot(
    RobotFormat format,
    String name,
    Optional<Vector3> gravity,
    List<Link> links,
    List<Joint> joints,
    List<Loop> loops,
    List<Coupling> couplings,
    List<Force> forces,
    Map<String, Start> starts) {
  Robot {
    links = List.copyOf(links);
    joints = List.copyOf(joints);
    loops = List.copyOf(loops);
    couplings = List.copyOf(couplings);
    forces = List.copyOf(forces);
    starts = Map.copyOf(starts);
  }

  /** A robot of links and joints alone. */
  Robot(
      RobotFormat format,
      String name,
      Optional<Vector3> gravity,
      List<Link> links,
      List<Joint> joints) {
    this(format, name, gravity, links, joints, List.of(), List.of(), List.of(), Map.of());
  }

  /** Returns the robot with other links and joints. */
  Robot with(List<Link> otherLinks, List<Joint> otherJoints) {
    return new Robot(
        format, name, gravity, otherLinks, otherJoints, loops, couplings, forces, starts);
  }

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

    /** Returns the rotation of a quaternion of any length; none if the length is zero. */
    static Rotation rotation(double w, double x, double y, double z) {
      double[] e = {w, x, y, z};
      if (!(EulerParameters.norm(e, 0) > 0)) {
        return Rotation.IDENTITY;
      }
      double[] r = new double[9];
      EulerParameters.rotation(e, 0, r, 0);
      return new Rotation(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]);
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
   * @param visuals what it looks like
   */
  record Link(Element element, String name, Optional<Inertial> inertial, List<Visual> visuals) {
    Link {
      visuals = List.copyOf(visuals);
    }

    /** A body that is not seen. */
    Link(Element element, String name, Optional<Inertial> inertial) {
      this(element, name, inertial, List.of());
    }

    /** Returns the same link with another inertia. */
    Link with(Optional<Inertial> other) {
      return new Link(element, name, other, visuals);
    }
  }

  /**
   * A part of what a body looks like.
   *
   * @param element its element in the file
   * @param frame of the shape in the body
   * @param shape its surface
   * @param colour red, green, blue and opacity from 0 to 1, as screens take them; empty if the file
   *     leaves it open
   */
  record Visual(Element element, Frame frame, Shape shape, Optional<List<Double>> colour) {}

  /** The surface of a visual. */
  sealed interface Shape {}

  /** A surface that the file itself describes. */
  record OwnShape(TriangleMesh surface) implements Shape {}

  /**
   * A surface in a file.
   *
   * @param name as the robot's file writes it
   * @param file where it is; empty if it is not found
   * @param scale factors along its axes
   */
  record FileShape(String name, Optional<Path> file, Vector3 scale) implements Shape {}

  /**
   * Mass and inertia of a link.
   *
   * @param element their element in the file
   * @param frame at the centre of mass, in the link's frame
   * @param mass kg
   * @param moments xx, yy, zz, xy, xz, yz of the tensor about the centre of mass in the axes of
   *     {@code frame}, kg·m²
   */
  record Inertial(Element element, Frame frame, double mass, List<Double> moments) {
    /** Returns mass and moments times a factor. */
    Inertial times(double factor) {
      return new Inertial(
          element, frame, factor * mass, moments.stream().map(m -> factor * m).toList());
    }
  }

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
      Coordinate coordinate) {
    /** Returns the same joint with other things along its coordinate. */
    Joint with(Coordinate other) {
      return new Joint(element, name, type, parent, child, place, other);
    }
  }

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
   * @param limits lowest and highest position; a side without a limit is infinite
   * @param stop how the limits push
   * @param stiffness of a spring, N/m or N·m/rad; negative ones push away
   * @param freePosition position at which the spring exerts nothing
   * @param damping N·s/m or N·m·s/rad
   * @param friction N or N·m
   * @param armature inertia of a motor as the coordinate feels it, kg or kg·m²; of a ball or free
   *     joint that of each of its velocities
   * @param mimic the joint that it follows
   */
  record Coordinate(
      Optional<Range> limits,
      Stop stop,
      double stiffness,
      double freePosition,
      double damping,
      double friction,
      double armature,
      Optional<Mimic> mimic) {
    static final Coordinate FREE =
        new Coordinate(Optional.empty(), Stop.ASSUMED, 0, 0, 0, 0, 0, Optional.empty());

    /** Returns the same with another spring and damper. */
    Coordinate with(double newStiffness, double newDamping) {
      return new Coordinate(
          limits, stop, newStiffness, freePosition, newDamping, friction, armature, mimic);
    }

    /** Returns the same without limits. */
    Coordinate unlimited() {
      return new Coordinate(
          Optional.empty(), stop, stiffness, freePosition, damping, friction, armature, mimic);
    }

    /** Returns the same with another friction. */
    Coordinate rubbing(double newFriction) {
      return new Coordinate(
          limits, stop, stiffness, freePosition, damping, newFriction, armature, mimic);
    }

    /** Returns the same with another armature. */
    Coordinate armed(double newArmature) {
      return new Coordinate(
          limits, stop, stiffness, freePosition, damping, friction, newArmature, mimic);
    }
  }

  /**
   * How a limit pushes: as a spring and a damper.
   *
   * @param time time constant of the spring, s; with the inertia m that it holds, its stiffness is
   *     m/(time · ratio)² and its damping 2 m/time
   * @param ratio damping ratio
   * @param stiffness in place of them, N/m or N·m/rad; 0 if the time constant holds
   * @param damping with the stiffness, N·s/m or N·m·s/rad
   */
  record Stop(double time, double ratio, double stiffness, double damping) {
    /** What the import assumes where a format defines nothing. */
    static final Stop ASSUMED = new Stop(0, 0, 0, 0);

    /**
     * Returns the stop that MuJoCo's two numbers describe: time constant and damping ratio, or,
     * both negative, stiffness and damping for 1 kg or 1 kg·m².
     */
    static Stop of(double first, double second) {
      if (first > 0 && second > 0) {
        return new Stop(first, second, 0, 0);
      }
      double k = -first;
      double b = -second;
      return k > 0 && b > 0 ? new Stop(2 / b, b / (2 * Math.sqrt(k)), 0, 0) : ASSUMED;
    }

    boolean isAssumed() {
      return time == 0 && stiffness == 0;
    }
  }

  /** Range of a coordinate; an end that it lacks is infinite. */
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

  /**
   * Two links share a point, or move as one.
   *
   * @param element its element in the file
   * @param name of the constraint
   * @param rigid whether they move as one
   * @param first a link
   * @param inFirst the frame of the constraint in it
   * @param second the other link
   * @param inSecond the same frame in that one; only its origin counts unless {@code rigid}
   */
  record Loop(
      Element element,
      String name,
      boolean rigid,
      String first,
      Frame inFirst,
      String second,
      Frame inSecond) {}

  /**
   * An equation between coordinates: a sum of them with factors, or an expression, plus a constant,
   * is zero.
   *
   * @param element its element in the file
   * @param name of the constraint
   * @param terms factors by joint; empty if there is an expression
   * @param expression in MechML
   * @param constant of the sum, as MechML has it on its right side
   */
  record Coupling(
      Element element,
      String name,
      Map<String, Double> terms,
      Optional<String> expression,
      double constant) {}

  /** Something that acts on the robot. */
  sealed interface Force {
    /** Returns its element in the file. */
    Element element();

    /** Returns its name. */
    String name();
  }

  /**
   * A force along a coordinate.
   *
   * @param expression in MechML, N or N·m
   */
  record JointForce(Element element, String name, String joint, String expression)
      implements Force {}

  /**
   * A force on a link.
   *
   * @param at where it acts, in the link's axes, m
   * @param turning whether force and torque are in the link's axes, or else in those of the world
   * @param force its three components, N, in MechML
   * @param torque its three components, N·m, in MechML; empty if there is none
   */
  record BodyForce(
      Element element,
      String name,
      String link,
      Vector3 at,
      boolean turning,
      List<String> force,
      List<String> torque)
      implements Force {
    BodyForce {
      force = List.copyOf(force);
      torque = List.copyOf(torque);
    }

    /** Returns a constant force in world axes, N. */
    static BodyForce constant(
        Element element, String name, String link, Vector3 at, Vector3 force) {
      List<String> components =
          List.of(
              MechmlText.number(force.x()),
              MechmlText.number(force.y()),
              MechmlText.number(force.z()));
      return new BodyForce(element, name, link, at, false, components, List.of());
    }
  }

  /**
   * A point of a link that expressions of forces name; it exerts nothing itself.
   *
   * @param at in the link's axes, m
   */
  record Mark(Element element, String name, String link, Vector3 at) implements Force {
    /** Returns a component of its place or velocity in MechML, such as {@code x} or {@code vx}. */
    String part(String component) {
      return MechmlText.name(link) + "." + MechmlText.name(name) + "." + component;
    }
  }

  /** What a path passes. */
  sealed interface Waypoint {}

  /**
   * A point of a link through which a path slides, or to which it is tied.
   *
   * @param at in the link's axes, m
   */
  record Eye(String link, Vector3 at) implements Waypoint {}

  /**
   * A sphere or a cylinder around which a path goes.
   *
   * @param frame in the link; the axis of a cylinder is its z axis
   * @param radius m
   * @param side a point on whose side the path passes
   * @param inside whether it goes through the shape as through a ring
   */
  record Around(
      String link, Frame frame, boolean cylinder, double radius, Optional<Eye> side, boolean inside)
      implements Waypoint {}

  /**
   * The path begins anew.
   *
   * @param share of the length behind it that counts
   */
  record Branch(double share) implements Waypoint {}

  /**
   * A spring and damper along a path.
   *
   * @param rest length at which the spring exerts nothing, m
   * @param side {@code both}, {@code tension} above rest only, or {@code compression} below it only
   */
  record PathSpring(
      Element element,
      String name,
      List<Waypoint> stops,
      double stiffness,
      double damping,
      double rest,
      String side)
      implements Force {
    PathSpring {
      stops = List.copyOf(stops);
    }
  }

  /**
   * A tension along a path.
   *
   * @param expression in MechML, of {@code length}, {@code rate} and inputs, N
   */
  record PathTension(Element element, String name, List<Waypoint> stops, String expression)
      implements Force {
    PathTension {
      stops = List.copyOf(stops);
    }
  }

  /**
   * A muscle along a path or a sum of coordinates.
   *
   * @param stops of the path; empty if there are terms
   * @param terms factors by joint
   * @param excitation in MechML
   * @param numbers by the names of their attributes
   */
  record Muscle(
      Element element,
      String name,
      List<Waypoint> stops,
      Map<String, Double> terms,
      String excitation,
      Map<String, Double> numbers)
      implements Force {
    Muscle {
      stops = List.copyOf(stops);
    }
  }

  /**
   * A spring and damper along a sum of coordinates.
   *
   * @param angle whether the sum is an angle, or else a length
   * @param terms factors by joint
   * @param rest the sum at which the spring exerts nothing
   * @param side {@code both}, {@code tension} above rest only, or {@code compression} below it only
   */
  record CouplingSpring(
      Element element,
      String name,
      boolean angle,
      Map<String, Double> terms,
      double stiffness,
      double damping,
      double rest,
      String side)
      implements Force {}

  /**
   * A spring that brings one link back into its place in another.
   *
   * @param frame of the second in the first, where the spring exerts nothing
   * @param at where both meet, in the second's axes from its origin, m
   * @param sliding stiffness along every axis, N/m
   * @param turning stiffness about every axis, N·m/rad
   */
  record PoseSpring(
      Element element,
      String name,
      String first,
      String second,
      Frame frame,
      Vector3 at,
      double sliding,
      double turning)
      implements Force {}

  /**
   * A spring and damper between points of two links.
   *
   * @param rest length at which the spring exerts nothing, m
   */
  record PointSpring(
      Element element,
      String name,
      String first,
      Vector3 inFirst,
      String second,
      Vector3 inSecond,
      double stiffness,
      double damping,
      double rest)
      implements Force {}

  /**
   * A signal from outside, zero until somebody sets it.
   *
   * @param unit of its value, a label
   */
  record Input(Element element, String name, String unit) implements Force {}

  /**
   * A quantity with a rate of its own, zero at the start.
   *
   * @param unit of its value
   * @param derivative its rate, in MechML
   */
  record State(Element element, String name, String unit, String derivative) implements Force {}

  /** Positions and velocities of a joint at the start, in the order of MechML. */
  record Start(List<Double> positions, List<Double> velocities) {}
}
