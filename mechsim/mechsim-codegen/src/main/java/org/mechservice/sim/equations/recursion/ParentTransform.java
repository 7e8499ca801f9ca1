package org.mechservice.sim.equations.recursion;

import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.step.ArticulatedInertia;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/** Transformation of quantities from a link's computing frame to its parent's. */
public final class ParentTransform {
  private final Expressions expressions;
  private final Coordinates coordinates;

  public ParentTransform(Expressions expressions, Coordinates coordinates) {
    this.expressions = expressions;
    this.coordinates = coordinates;
  }

  /** Returns an inertia in the parent's computing frame. */
  public ArticulatedInertia inertia(Link link, ArticulatedInertia inertia) {
    return coordinates.step(link).toParent(inertia);
  }

  /** Returns a wrench in the parent's computing frame. */
  public Wrench wrench(Link link, Wrench wrench) {
    return coordinates.step(link).toParent(wrench);
  }

  /** Returns an inertia and its changes in the parent's computing frame. */
  public RigidComposite composite(Link link, RigidComposite composite) {
    RigidComposite inParentAxes =
        composite.in(
            new RigidComposite.AxesOf() {
              @Override
              public ScalarVector vector(ScalarVector v) {
                return ParentTransform.this.vector(link, v);
              }

              @Override
              public ScalarMatrix matrix(ScalarMatrix m) {
                return ParentTransform.this.matrix(link, m);
              }
            });
    ScalarVector offset = ScalarVector.of(expressions, link.offset());
    return inParentAxes.shifted(
        link.slides() ? offset.plus(link.axes().toParent(way(link))) : offset);
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

  private ScalarMatrix matrix(Link link, ScalarMatrix m) {
    ScalarMatrix atJoint = m;
    if (link.isBall()) {
      atJoint = m.in(coordinates.ballRotation(link));
    } else if (link.turns()) {
      atJoint = m.turned(2, coordinates.cosine(link), coordinates.sine(link));
    }
    return link.axes().toParent(atJoint);
  }

  private ScalarVector way(Link link) {
    Scalar zero = expressions.zero();
    return new ScalarVector(zero, zero, coordinates.way(link));
  }
}
