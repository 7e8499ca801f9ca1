package org.mechservice.solver.links;

import java.util.List;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.spatial.Vector3;

/**
 * A mechanism in computing frames.
 *
 * @param mechanism the mechanism
 * @param links moving links from the root outwards: parents come before their children
 * @param bodies placement of each body, in the mechanism's order
 * @param positionCount number of positions in the state
 * @param velocityCount number of velocities in the state
 * @param gravity acceleration of free fall in root axes, m/s²
 * @param fixedMass mass welded to the root, kg
 * @param fixedCenter its centre, in root axes, m
 */
public record Links(
    Mechanism mechanism,
    List<Link> links,
    List<BodyPlacement> bodies,
    int positionCount,
    int velocityCount,
    Vector3 gravity,
    double fixedMass,
    Vector3 fixedCenter) {
  /** Link index of the root. */
  public static final int ROOT = -1;

  public Links {
    links = List.copyOf(links);
    bodies = List.copyOf(bodies);
  }

  /** Returns the same mechanism with other links. */
  public Links with(List<Link> others) {
    return new Links(
        mechanism, others, bodies, positionCount, velocityCount, gravity, fixedMass, fixedCenter);
  }

  /** Chooses the computing frames of a mechanism. */
  public static Links of(Mechanism mechanism) {
    return of(new TreeGeometry(mechanism));
  }

  /** Chooses the computing frames of a tree. */
  public static Links of(TreeGeometry tree) {
    return new LinkLayout(tree).links();
  }
}
