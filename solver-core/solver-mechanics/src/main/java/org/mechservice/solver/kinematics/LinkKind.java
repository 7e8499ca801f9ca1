package org.mechservice.solver.kinematics;

/** The elementary motions that all joints are made of. */
public enum LinkKind {
  /** Turns about an axis fixed on both sides. */
  TURN(1, 1),
  /** Slides along an axis fixed on both sides. */
  SLIDE(1, 1),
  /** Turns about an axis and moves along it in proportion. */
  SCREW(1, 1),
  /**
   * Turns as four Euler parameters say; its three velocities are the angular velocity in the axes
   * of the file's body 1.
   */
  BALL(4, 3),
  /** Does not move. */
  FIXED(0, 0);

  private final int positionCount;
  private final int velocityCount;

  LinkKind(int positionCount, int velocityCount) {
    this.positionCount = positionCount;
    this.velocityCount = velocityCount;
  }

  /** Returns the number of positions. */
  public int positionCount() {
    return positionCount;
  }

  /** Returns the number of velocities. */
  public int velocityCount() {
    return velocityCount;
  }
}
