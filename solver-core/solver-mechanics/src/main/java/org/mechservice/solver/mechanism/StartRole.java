package org.mechservice.solver.mechanism;

/** How far assembly may move the coordinates of a joint from where its file starts them. */
public enum StartRole {
  /** They stay to the bit; a loop that then cannot close is an error. */
  FIXED,
  /** They were given: they move as little as the loops allow. */
  PREFERRED,
  /** They were not given: they go where the loops put them. */
  FREE
}
