package org.mechservice.view.scene;

/**
 * A point fixed in a body.
 *
 * @param body index of the body, or {@link #ROOT}
 * @param point from the body's origin, in body axes, m
 */
public record Anchor(int body, Point3 point) {
  /** Index of the root where a body is meant. */
  public static final int ROOT = -1;
}
