package org.mechservice.sim.build.dynamics;

import org.mechservice.sim.symbolic.Expressions;
import org.mechservice.sim.symbolic.Scalar;
import org.mechservice.sim.symbolic.ScalarMatrix;
import org.mechservice.sim.symbolic.ScalarVector;

/** How the parent sees what a link has in its own computing frame. */
final class ToParent {
  private final Expressions expressions;
  private final Coordinates coordinates;

  ToParent(Expressions expressions, Coordinates coordinates) {
    this.expressions = expressions;
    this.coordinates = coordinates;
  }

  /** Returns an inertia in the parent's computing frame. */
  ArticulatedInertia inertia(Link link, ArticulatedInertia inertia) {
    ArticulatedInertia atJoint = inertia;
    if (link.isBall()) {
      atJoint = inertia.in(coordinates.ballRotation(link));
    }
    if (link.turns()) {
      atJoint = atJoint.turned(2, coordinates.cosine(link), coordinates.sine(link));
    }
    if (link.slides()) {
      atJoint = atJoint.shifted(way(link));
    }
    return atJoint.toParent(link.axes()).shifted(ScalarVector.of(expressions, link.offset()));
  }

  /** Returns a wrench in the parent's computing frame. */
  Wrench wrench(Link link, Wrench wrench) {
    Wrench atJoint = wrench;
    if (link.isBall()) {
      ScalarMatrix rotation = coordinates.ballRotation(link);
      atJoint = wrench.in(rotation);
    }
    if (link.turns()) {
      atJoint = atJoint.turned(2, coordinates.cosine(link), coordinates.sine(link));
    }
    if (link.slides()) {
      atJoint = atJoint.shifted(way(link));
    }
    return atJoint.toParent(link.axes()).shifted(ScalarVector.of(expressions, link.offset()));
  }

  private ScalarVector way(Link link) {
    Scalar zero = expressions.zero();
    return new ScalarVector(zero, zero, coordinates.way(link));
  }
}
