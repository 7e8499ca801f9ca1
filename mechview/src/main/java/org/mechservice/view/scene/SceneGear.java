package org.mechservice.view.scene;

/**
 * A wheel that a coupling of joints stands for.
 *
 * @param kind what it looks like
 * @param body the body that it is a part of
 * @param centre in body axes, m
 * @param axis unit vector in body axes
 * @param tooth unit vector in body axes from the centre to the middle of a tooth
 * @param radius of the pitch circle, m
 * @param teeth their number; 0 for a pulley
 */
public record SceneGear(
    Kind kind, int body, Point3 centre, Point3 axis, Point3 tooth, double radius, int teeth) {
  /** The kinds of wheels. */
  public enum Kind {
    /** Its teeth are outside. */
    WHEEL,
    /** Its teeth are inside. */
    RING,
    /** A belt runs over it. */
    PULLEY
  }
}
