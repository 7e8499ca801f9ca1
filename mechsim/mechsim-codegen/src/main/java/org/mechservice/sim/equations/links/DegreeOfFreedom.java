package org.mechservice.sim.equations.links;

import java.util.List;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * One degree of freedom of a link: a rotation about a coordinate axis of its computing frame, a
 * displacement along z, or both in proportion.
 *
 * @param axis 0, 1, 2 for x, y, z
 * @param turns whether it rotates
 * @param way displacement along the axis per coordinate
 */
public record DegreeOfFreedom(int axis, boolean turns, double way) {

  /** Returns the degrees of freedom of a link in the order of elimination. */
  public static List<DegreeOfFreedom> of(Link link) {
    return link.isBall()
        ? List.of(
            new DegreeOfFreedom(0, true, 0),
            new DegreeOfFreedom(1, true, 0),
            new DegreeOfFreedom(2, true, 0))
        : List.of(new DegreeOfFreedom(2, link.turns(), link.way()));
  }

  /** Returns the component of a wrench along the degree of freedom. */
  public Scalar along(Wrench wrench) {
    Scalar sum = wrench.moment().x().expressions().zero();
    if (turns) {
      sum = sum.plus(wrench.moment().at(axis));
    }
    return way == 0 ? sum : sum.plus(wrench.force().at(axis).times(way));
  }

  /** Returns whether it is a pure rotation or a pure displacement. */
  public boolean isPlain() {
    return turns != (way != 0);
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

  /** Returns the link's own inertia along the degree of freedom: kg·m², or kg. */
  public double ownInertia(Link link) {
    if (link.isBall()) {
      return SmallTensor.pivots(link.inertiaAtOrigin())[axis];
    }
    double turning = turns ? link.inertiaAtOrigin().zz() : 0;
    return turning + way * way * link.mass();
  }
}
