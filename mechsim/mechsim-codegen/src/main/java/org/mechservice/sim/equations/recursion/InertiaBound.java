package org.mechservice.sim.equations.recursion;

import java.util.List;
import java.util.function.Function;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;

/**
 * A bound of the inertia beyond a joint with all joints beyond it locked. The articulated inertia
 * of a singular joint is very small relative to it.
 *
 * <p>The bound is the largest rigid-body inertia over all positions: Σ m ρ² + trace I, with ρ the
 * length of the path from the joint to the centre of mass. It is a constant unless a sliding joint
 * is on the path.
 *
 * @param mass Σ m, kg
 * @param first Σ m ρ, kg·m
 * @param second Σ (m ρ² + trace I), kg·m²
 */
record InertiaBound(Scalar mass, Scalar first, Scalar second) {

  /**
   * Returns the bounds at every link's computing origin.
   *
   * @param slid the path length that a sliding joint adds, m
   */
  static InertiaBound[] of(Expressions expressions, List<Link> links, Function<Link, Scalar> slid) {
    InertiaBound[] bounds = new InertiaBound[links.size()];
    for (int i = 0; i < bounds.length; i++) {
      bounds[i] = own(expressions, links.get(i));
    }
    for (int i = bounds.length - 1; i > 0; i--) {
      Link link = links.get(i);
      if (link.parent() != Links.ROOT) {
        Scalar length = finite(expressions, link.offset().norm());
        InertiaBound seen = bounds[i].from(link.slides() ? length.plus(slid.apply(link)) : length);
        bounds[link.parent()] = bounds[link.parent()].plus(seen);
      }
    }
    return bounds;
  }

  private static InertiaBound own(Expressions expressions, Link link) {
    double distance = link.centerOfMass().norm();
    double moment = link.mass() * distance;
    return new InertiaBound(
        finite(expressions, link.mass()),
        finite(expressions, moment),
        finite(expressions, moment * distance + link.inertia().trace()));
  }

  /**
   * Returns a finite bound. If the bound overflows, the bounded value overflows too, and the run
   * reports its position.
   */
  private static Scalar finite(Expressions expressions, double bound) {
    return expressions.constant(Math.min(bound, Double.MAX_VALUE));
  }

  private InertiaBound plus(InertiaBound other) {
    return new InertiaBound(
        mass.plus(other.mass), first.plus(other.first), second.plus(other.second));
  }

  private InertiaBound from(Scalar way) {
    Scalar more = way.times(mass);
    return new InertiaBound(
        mass, first.plus(more), second.plus(way.times(first.times(2).plus(more))));
  }

  /** Returns the bound along a joint: of the moment of inertia, or of the mass. */
  Scalar along(Link link) {
    if (link.kind() == LinkKind.SLIDE) {
      return mass;
    }
    return second.plus(mass.times(link.way() * link.way()));
  }
}
