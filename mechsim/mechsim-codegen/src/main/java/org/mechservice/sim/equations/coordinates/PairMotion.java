package org.mechservice.sim.equations.coordinates;

import org.mechservice.sim.equations.kinematics.BodyPoints;
import org.mechservice.sim.equations.kinematics.LinkKinematics;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * The line between two points of different bodies, in the axes of the nearest common ancestor of
 * their links.
 */
public final class PairMotion {
  private final LinkKinematics kinematics;
  private final int link1;
  private final int link2;
  private final int ancestor;
  private final ScalarVector r1;
  private final ScalarVector r2;

  public PairMotion(
      LinkKinematics kinematics, BodyPoints points, BodyPoint point1, BodyPoint point2) {
    this.kinematics = kinematics;
    this.link1 = points.link(point1.body());
    this.link2 = points.link(point2.body());
    this.ancestor = kinematics.commonAncestor(link1, link2);
    this.r1 = points.inLink(point1);
    this.r2 = points.inLink(point2);
  }

  /** Returns whether the points belong to one rigid body, or to bodies welded together. */
  public boolean isRigid() {
    return link1 == link2;
  }

  /** Returns point 2 from point 1, m. */
  public ScalarVector way() {
    ScalarVector first = kinematics.pointFrom(ancestor, link1, r1);
    ScalarVector second = kinematics.pointFrom(ancestor, link2, r2);
    return second.minus(first);
  }

  /** Returns the velocity of point 2 less that of point 1, m/s. */
  public ScalarVector velocity() {
    ScalarVector first = kinematics.toAncestor(ancestor, link1, kinematics.velocityAt(link1, r1));
    ScalarVector second = kinematics.toAncestor(ancestor, link2, kinematics.velocityAt(link2, r2));
    return second.minus(first);
  }

  /** Adds a force on point 2, given in these axes, and the opposite one on point 1. */
  public void addForce(ScalarVector force, Loads loads) {
    ScalarVector none = kinematics.zero();
    if (link2 != Links.ROOT) {
      loads.add(link2, r2, kinematics.fromAncestor(ancestor, link2, force), none);
    }
    if (link1 != Links.ROOT) {
      ScalarVector back = force.map(Scalar::negated);
      loads.add(link1, r1, kinematics.fromAncestor(ancestor, link1, back), none);
    }
  }
}
