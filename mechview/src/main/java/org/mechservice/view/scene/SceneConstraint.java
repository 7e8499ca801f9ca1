package org.mechservice.view.scene;

import java.util.List;
import java.util.Optional;

/**
 * A constraint of a picture other than a cut joint.
 *
 * @param name name in the model file
 * @param kind what it says
 * @param anchors the two points of a distance; the point, then a point of the line or plane; what a
 *     rope passes; empty for another coupling
 * @param direction unit vector along the line or normal to the plane, in the axes of the second
 *     anchor's body; zero for the others
 * @param wheel what rolls, on the first anchor; empty for the others
 * @param joints names of the joints whose coordinates a coupling relates; empty for the others
 */
public record SceneConstraint(
    String name,
    Kind kind,
    List<Anchor> anchors,
    Point3 direction,
    Optional<Wheel> wheel,
    List<String> joints) {
  /**
   * A wheel or a ball.
   *
   * @param axle unit vector along the axle, in the axes of the first anchor's body; zero for a ball
   * @param radius m
   */
  public record Wheel(Point3 axle, double radius) {
    /** Returns whether it is a ball. */
    public boolean isBall() {
      return axle.equals(Point3.ZERO);
    }
  }

  /** The kinds of constraints. */
  public enum Kind {
    /** Two points keep their distance, by a rod without mass. */
    DISTANCE,
    /** Two points keep their distance, by a rod with mass. */
    ROD,
    /** Coordinates of joints obey a relation, such as a gear's. */
    COUPLING,
    /** A point stays on a line. */
    POINT_ON_LINE,
    /** A point stays in a plane. */
    POINT_ON_PLANE,
    /** A wheel or ball rolls on a plane. */
    ROLLING,
    /** A point does not move in a direction of its body: the direction is in the first anchor's. */
    KNIFE_EDGE
  }

  public SceneConstraint {
    anchors = List.copyOf(anchors);
    joints = List.copyOf(joints);
  }
}
