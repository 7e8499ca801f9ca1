package org.mechservice.solver.api;

import java.util.Locale;

/**
 * Groups of result columns that can be asked for; time and the joints' positions and velocities
 * always come first.
 */
public enum ColumnGroup {
  /** Joint positions and velocities; always present. */
  JOINTS,
  /** Joint accelerations. */
  ACCELERATIONS,
  /**
   * Pose and velocity of every body; the model must have been built with it ({@link BodyPoses}).
   */
  BODIES,
  /** Kinetic and potential energy and the work of non-conservative forces. */
  ENERGY;

  /** Returns the group's name on the command line. */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }
}
