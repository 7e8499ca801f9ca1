package org.mechservice.solver.expression;

import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * A right-handed frame fixed in a body.
 *
 * @param body index among the mechanism's bodies; {@link BodyPoint#ROOT} for the root
 * @param position the frame's origin from the body's origin, in body axes, m
 * @param axes from the frame's axes to body axes
 */
public record BodyFrame(int body, Vector3 position, Rotation axes) {
  /** Returns the frame's origin. */
  public BodyPoint origin() {
    return new BodyPoint(body, position);
  }
}
