package org.mechservice.view.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * An applied force of a picture.
 *
 * @param name name in the model file
 * @param kind what acts
 * @param anchors where it acts: the two ends of a spring, damper or bushing; the point of a force;
 *     centre of the sphere and origin of the surface of a contact; the points of a user's force;
 *     the joint's points for what acts in a joint
 * @param direction unit vector in world axes at the start: the direction of a force or moment, the
 *     outward normal of a contact's surface, if it is a plane; zero where there is none
 * @param inBodyAxes whether the components of the force in results are in axes of the body it acts
 *     on, not of the world
 * @param radius radius of a contact's sphere, disc or wheel, m; 0 for every other force
 * @param joint name of the joint it acts in; empty if it acts between points
 * @param axle unit vector along the axle of a disc or wheel in contact, in the axes of the first
 *     anchor's body; zero for every other force
 * @param box the box that touches in a contact of a box; none for every other force
 */
public record SceneForce(
    String name,
    Kind kind,
    List<Anchor> anchors,
    Point3 direction,
    boolean inBodyAxes,
    double radius,
    String joint,
    Point3 axle,
    Optional<Box> box) {
  /** The kinds of forces. */
  public enum Kind {
    /** A spring without damping between two points. */
    SPRING,
    /** A damper without stiffness between two points. */
    DAMPER,
    /** Spring and damper side by side between two points. */
    SPRING_DAMPER,
    /** Spring, damper or both in a joint. */
    JOINT_SPRING,
    /** A force or a moment in a joint. */
    JOINT_FORCE,
    /** Friction in a joint. */
    JOINT_FRICTION,
    /** An elastic joint between two frames. */
    BUSHING,
    /** A force at a point. */
    FORCE,
    /** A moment on a body. */
    MOMENT,
    /** A sphere pressed against a surface. */
    CONTACT,
    /** A rope that passes all anchors, from its first end to its last. */
    ROPE,
    /** A spring between coordinates of joints, whose points are the anchors. */
    COUPLING,
    /** A class of the user. */
    USER
  }

  /**
   * A box that touches.
   *
   * @param at its centre and edges, in the axes of the first anchor's body
   * @param edges their lengths, m
   */
  public record Box(BodyPose at, Point3 edges) {
    /**
     * Returns its eight corners in the axes of the first anchor's body, m. Two whose places in the
     * list differ by one power of two share an edge.
     */
    public List<Point3> corners() {
      List<Point3> corners = new ArrayList<>();
      for (int corner = 0; corner < 8; corner++) {
        corners.add(
            at.toWorld(
                new Point3(
                    half(corner, 0, edges.x()),
                    half(corner, 1, edges.y()),
                    half(corner, 2, edges.z()))));
      }
      return corners;
    }

    private static double half(int corner, int axis, double edge) {
      return (corner >> axis & 1) == 0 ? -edge / 2 : edge / 2;
    }
  }

  public SceneForce {
    anchors = List.copyOf(anchors);
  }

  /** Creates a force without a disc, wheel or box. */
  public SceneForce(
      String name,
      Kind kind,
      List<Anchor> anchors,
      Point3 direction,
      boolean inBodyAxes,
      double radius,
      String joint) {
    this(name, kind, anchors, direction, inBodyAxes, radius, joint, Point3.ZERO, Optional.empty());
  }

  /** Returns whether it is the contact of a disc or wheel. */
  public boolean isOfDisc() {
    return axle.norm() > 0;
  }
}
