package org.mechservice.solver.expression;

import org.mechservice.solver.spatial.Vector3;

/**
 * A point fixed in a body.
 *
 * @param body index among the mechanism's bodies; {@link #ROOT} for the root
 * @param position from the body's origin, in body axes, m
 */
public record BodyPoint(int body, Vector3 position) {
  /** Body index of the root. */
  public static final int ROOT = -1;
}
