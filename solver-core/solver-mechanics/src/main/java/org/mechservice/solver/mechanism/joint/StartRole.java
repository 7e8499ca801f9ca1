package org.mechservice.solver.mechanism.joint;

/** Freedom of assembly to change the start values of a joint's coordinates. */
public enum StartRole {
  /** The start values are kept in every bit; a loop that then cannot close is an error. */
  FIXED,
  /** The start values were given: they change as little as the loops permit. */
  PREFERRED,
  /** The start values were not given: assembly chooses them. */
  FREE
}
