package org.mechservice.view.scene;

import java.util.List;

/**
 * The findings of {@code mech check} about a model.
 *
 * @param degreesOfFreedom by rank where it is known, else by count
 * @param equations number of equations that close the loops
 * @param redundant how many of them follow from the others
 * @param assembled whether the loops are closed in the position of the picture
 * @param warnings messages about suspicious data
 */
public record SceneVerdict(
    int degreesOfFreedom, int equations, int redundant, boolean assembled, List<String> warnings) {
  public SceneVerdict {
    warnings = List.copyOf(warnings);
  }
}
