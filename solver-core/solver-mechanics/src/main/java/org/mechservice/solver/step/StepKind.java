package org.mechservice.solver.step;

import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.links.Link;

/** The kinds of steps for which methods are printed: one for each kind of joint and of turn. */
public enum StepKind {
  /** A turn about z. */
  TURN(LinkKind.TURN, false, -1),
  /** A displacement along z. */
  SLIDE(LinkKind.SLIDE, false, -1),
  /** Both in proportion. */
  SCREW(LinkKind.SCREW, false, -1),
  /** A rotation by Euler parameters of the link relative to its parent. */
  BALL(LinkKind.BALL, false, -1),
  /** A rotation by Euler parameters of the parent relative to the link. */
  BALL_BACK(LinkKind.BALL, true, -1),
  /** A constant turn about the x axis, a step of its own. */
  AXES_X(LinkKind.FIXED, false, 0),
  /** A constant turn about the y axis. */
  AXES_Y(LinkKind.FIXED, false, 1),
  /** A constant turn about the z axis. */
  AXES_Z(LinkKind.FIXED, false, 2);

  private final LinkKind link;
  private final boolean inverse;
  private final int turnAxis;

  StepKind(LinkKind link, boolean inverse, int turnAxis) {
    this.link = link;
    this.inverse = inverse;
    this.turnAxis = turnAxis;
  }

  /** Returns the kind of the step of a link's joint. */
  public static StepKind of(Link link) {
    return switch (link.kind()) {
      case TURN -> TURN;
      case SLIDE -> SLIDE;
      case SCREW -> SCREW;
      case BALL -> link.inverse() ? BALL_BACK : BALL;
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
