package org.mechservice.solver.mechanism.joint;

/** Freedom of assembly to change the start values of a joint's coordinates. */
public enum StartRole {
  /** The start values are kept in every bit; a loop that then cannot close is an error. */
  FIXED,
  /** The start values were given: they change as little as the loops permit. */
  PREFERRED,
  /** The positions were given, the velocities were not: assembly chooses these. */
  PREFERRED_POSITIONS,
  /** The velocities were given, the positions were not: assembly chooses these. */
  PREFERRED_VELOCITIES,
  /** The start values were not given: assembly chooses them. */
  FREE;

  /** Returns the role of the positions alone: fixed, preferred or free. */
  public StartRole ofPositions() {
    return switch (this) {
      case PREFERRED_POSITIONS -> PREFERRED;
      case PREFERRED_VELOCITIES -> FREE;
      default -> this;
    };
  }

  /** Returns the role of the velocities alone: fixed, preferred or free. */
  public StartRole ofVelocities() {
    return switch (this) {
      case PREFERRED_POSITIONS -> FREE;
      case PREFERRED_VELOCITIES -> PREFERRED;
      default -> this;
    };
  }
}
