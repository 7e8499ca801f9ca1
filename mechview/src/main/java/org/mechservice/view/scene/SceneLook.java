package org.mechservice.view.scene;

import java.util.List;

/**
 * Solids that a body is shown as, without a part in its mass.
 *
 * @param solids in axes of the look, m
 * @param at these axes in those of the body
 * @param colour 0xRRGGBB, or {@link #NO_COLOUR}
 * @param opacity 1 for opaque solids
 */
public record SceneLook(List<SceneSolid> solids, BodyPose at, int colour, double opacity) {
  /** Stands for the colour that the body has in pictures. */
  public static final int NO_COLOUR = -1;

  public SceneLook {
    solids = List.copyOf(solids);
  }
}
