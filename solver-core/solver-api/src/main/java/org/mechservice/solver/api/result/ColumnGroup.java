package org.mechservice.solver.api.result;

import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;

/** Groups of result columns; time and the joints' positions and velocities always come first. */
public enum ColumnGroup {
  /** Joint positions and velocities; always present. */
  JOINTS,
  /** Joint accelerations. */
  ACCELERATIONS,
  /**
   * Pose and velocity of every body; the model must have been built with it ({@code BodyPoses}).
   */
  BODIES,
  /** Kinetic and potential energy and the work of non-conservative forces. */
  ENERGY,
  /** Largest residuals of the constraints, and each one's multipliers ({@code ResultColumns}). */
  CONSTRAINTS,
  /** Force and moment in every joint ({@code ResultColumns}). */
  REACTIONS,
  /** Values of the applied forces ({@code ResultColumns}). */
  FORCES,
  /** User-defined outputs, given by expressions ({@code ResultColumns}). */
  OUTPUTS,
  /** Total momentum and the impulse that has acted on the mechanism ({@code MomentumBalance}). */
  MOMENTUM,
  /** Motion and power of driven joints, which have no states ({@code ResultColumns}). */
  DRIVES;

  /** Returns the group's name on the command line. */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * Returns the groups with the given labels, and that of the joints.
   *
   * @param labels separated by commas
   * @throws IllegalArgumentException if there is no group with one of the labels
   */
  public static Set<ColumnGroup> of(String labels) {
    Set<ColumnGroup> groups = EnumSet.of(JOINTS);
    for (String label : labels.split(",", -1)) {
      groups.add(valueOf(label.toUpperCase(Locale.ROOT)));
    }
    return groups;
  }
}
