package org.mechservice.solver.kinematics;

/** The elementary motions of which all joints are composed. */
public enum LinkKind {
  /** Rotates about an axis fixed on both sides. */
  TURN(1),
  /** Translates along an axis fixed on both sides. */
  SLIDE(1),
  /** Rotates about an axis and translates along it in proportion. */
  SCREW(1),
  /**
   * Rotates by four Euler parameters; its three velocities are the angular velocity in the axes of
   * the file's body 1.
   */
  BALL(3),
  /** Does not move. */
  FIXED(0);

  private final int velocityCount;

  LinkKind(int velocityCount) {
    this.velocityCount = velocityCount;
  }

  /** Returns the number of velocities. */
  public int velocityCount() {
    return velocityCount;
  }
}
