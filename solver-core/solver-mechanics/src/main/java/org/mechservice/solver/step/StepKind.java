package org.mechservice.solver.step;

import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.links.Link;

/** The kinds of steps for which methods are printed: one for each kind of joint and of turn. */
public enum StepKind {
  /** A turn about z. */
  TURN(LinkKind.TURN, false, false, -1),
  /** A displacement along z. */
  SLIDE(LinkKind.SLIDE, false, false, -1),
  /** Both in proportion. */
  SCREW(LinkKind.SCREW, false, false, -1),
  /** A rotation by Euler parameters of the link relative to its parent. */
  BALL(LinkKind.BALL, false, false, -1),
  /** A rotation by Euler parameters of the parent relative to the link. */
  BALL_BACK(LinkKind.BALL, true, false, -1),
  /** A constant turn about the x axis, a step of its own. */
  AXES_X(LinkKind.FIXED, false, false, 0),
  /** A constant turn about the y axis. */
  AXES_Y(LinkKind.FIXED, false, false, 1),
  /** A constant turn about the z axis. */
  AXES_Z(LinkKind.FIXED, false, false, 2),
  /** The joints above with an armature, in their order. */
  TURN_ARMED(LinkKind.TURN, false, true, -1),
  SLIDE_ARMED(LinkKind.SLIDE, false, true, -1),
  SCREW_ARMED(LinkKind.SCREW, false, true, -1),
  BALL_ARMED(LinkKind.BALL, false, true, -1),
  BALL_BACK_ARMED(LinkKind.BALL, true, true, -1);

  private final LinkKind link;
  private final boolean inverse;
  private final boolean armed;
  private final int turnAxis;

  StepKind(LinkKind link, boolean inverse, boolean armed, int turnAxis) {
    this.link = link;
    this.inverse = inverse;
    this.armed = armed;
    this.turnAxis = turnAxis;
  }

  /** Returns the kind of the step of a link's joint. */
  public static StepKind of(Link link) {
    return of(link, false);
  }

  /**
   * Returns the kind of the step of a link's joint.
   *
   * @param arms whether its joint takes an armature even if the link has none
   */
  public static StepKind of(Link link, boolean arms) {
    boolean armed = arms || link.armature() != 0;
    return switch (link.kind()) {
      case TURN -> armed ? TURN_ARMED : TURN;
      case SLIDE -> armed ? SLIDE_ARMED : SLIDE;
      case SCREW -> armed ? SCREW_ARMED : SCREW;
      case BALL ->
          link.inverse() ? (armed ? BALL_BACK_ARMED : BALL_BACK) : (armed ? BALL_ARMED : BALL);
      case FIXED -> throw new IllegalArgumentException("a fixed link is not a step");
    };
  }

  /** Returns the kind of a constant turn about a coordinate axis. */
  public static StepKind ofTurn(int axis) {
    return switch (axis) {
      case 0 -> AXES_X;
      case 1 -> AXES_Y;
      default -> AXES_Z;
    };
  }

  /** Returns the elementary motion of its joint. */
  LinkKind link() {
    return link;
  }

  /** Returns whether Euler parameters turn the parent relative to the link. */
  boolean inverse() {
    return inverse;
  }

  /** Returns whether its joint has an armature. */
  boolean armed() {
    return armed;
  }

  /** Returns the axis of its constant turn; −1 if it is a joint. */
  int turnAxis() {
    return turnAxis;
  }

  /** Returns the length of its block. */
  public int size() {
    return link == LinkKind.BALL ? StepBlock.BALL_SIZE : StepBlock.SIZE;
  }

  /** Returns whether it is a joint, not a constant turn. */
  public boolean isJoint() {
    return turnAxis < 0;
  }
}
