package org.mechservice.view.scene;

import java.util.List;

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
 */
public record SceneForce(
    String name,
    Kind kind,
    List<Anchor> anchors,
    Point3 direction,
    boolean inBodyAxes,
    double radius,
    String joint,
    Point3 axle) {
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

  public SceneForce {
    anchors = List.copyOf(anchors);
  }

  /** Creates a force without a disc or wheel. */
  public SceneForce(
      String name,
      Kind kind,
      List<Anchor> anchors,
      Point3 direction,
      boolean inBodyAxes,
      double radius,
      String joint) {
    this(name, kind, anchors, direction, inBodyAxes, radius, joint, Point3.ZERO);
  }

  /** Returns whether it is the contact of a disc or wheel. */
  public boolean isOfDisc() {
    return axle.norm() > 0;
  }
}
