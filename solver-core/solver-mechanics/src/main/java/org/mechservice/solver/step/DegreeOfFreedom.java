package org.mechservice.solver.step;

import java.util.List;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * One degree of freedom of a link: a rotation about a coordinate axis of its computing frame, a
 * displacement along z, or both in proportion.
 *
 * @param axis 0, 1, 2 for x, y, z
 * @param turns whether it rotates
 * @param way displacement along the axis per coordinate
 * @param armature inertia of its own, kg·m² or kg
 */
public record DegreeOfFreedom(int axis, boolean turns, Scalar way, Scalar armature) {

  /** Returns the degrees of freedom of a link in the order of elimination. */
  public static List<DegreeOfFreedom> of(Expressions expressions, Link link) {
    return of(
        link.isBall(),
        link.turns(),
        expressions.constant(link.way()),
        expressions.constant(link.armature()));
  }

  /** Returns the degrees of freedom of a link in the order of elimination. */
  static List<DegreeOfFreedom> of(boolean ball, boolean turns, Scalar way, Scalar armature) {
    return ball
        ? List.of(
            new DegreeOfFreedom(0, true, way, armature),
            new DegreeOfFreedom(1, true, way, armature),
            new DegreeOfFreedom(2, true, way, armature))
        : List.of(new DegreeOfFreedom(2, turns, way, armature));
  }

  /** Returns the component of a wrench along the degree of freedom. */
  public Scalar along(Wrench wrench) {
    Scalar sum = way.expressions().zero();
    if (turns) {
      sum = sum.plus(wrench.moment().at(axis));
    }
    return slides() ? sum.plus(wrench.force().at(axis).times(way)) : sum;
  }

  /** Returns whether it displaces. */
  public boolean slides() {
    return !way.isZero();
  }

  /**
   * Returns the inertia of a joint along the degree of freedom with its armature.
   *
   * @param column moment and force of a unit acceleration
   */
  public Scalar pivot(Wrench column) {
    return along(column).plus(armature);
  }

  /**
   * Returns whether it is a pure rotation or a pure displacement without armature: no wrench along
   * its axis but the joint force is left when it is eliminated.
   */
  public boolean isPlain() {
    return turns != slides() && armature.isZero();
  }

  /** Returns a wrench with its element on the axis of a plain degree of freedom replaced. */
  public Wrench with(Wrench wrench, Scalar onAxis) {
    if (!isPlain()) {
      return wrench;
    }
    return turns
        ? new Wrench(replaced(wrench.moment(), onAxis), wrench.force())
        : new Wrench(wrench.moment(), replaced(wrench.force(), onAxis));
  }

  /** Returns a vector with its component along the axis replaced. */
  public ScalarVector replaced(ScalarVector vector, Scalar component) {
    return new ScalarVector(
        axis == 0 ? component : vector.x(),
        axis == 1 ? component : vector.y(),
        axis == 2 ? component : vector.z());
  }
}
