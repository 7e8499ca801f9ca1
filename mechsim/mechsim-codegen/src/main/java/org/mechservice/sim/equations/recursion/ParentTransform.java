package org.mechservice.sim.equations.recursion;

import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.ScalarVector;

/** Transformation of quantities from a link's computing frame to its parent's. */
public final class ParentTransform {
  private final Coordinates coordinates;

  public ParentTransform(Coordinates coordinates) {
    this.coordinates = coordinates;
  }

  /** Returns a wrench in the parent's computing frame. */
  public Wrench wrench(Link link, Wrench wrench) {
    return coordinates.step(link).toParent(wrench);
  }

  /** Returns a vector in parent axes. */
  public ScalarVector vector(Link link, ScalarVector v) {
    ScalarVector atJoint = v;
    if (link.isBall()) {
      atJoint = coordinates.ballRotation(link).times(v);
    } else if (link.turns()) {
      atJoint = v.turned(2, coordinates.cosine(link), coordinates.sine(link));
    }
    return link.axes().toParent(atJoint);
  }
}
