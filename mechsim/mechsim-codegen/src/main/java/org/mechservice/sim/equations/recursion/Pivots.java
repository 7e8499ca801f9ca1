package org.mechservice.sim.equations.recursion;

import java.util.List;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.sim.equations.links.DegreeOfFreedom;
import org.mechservice.sim.equations.links.Link;
import org.mechservice.sim.symbolic.Expressions;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.sim.symbolic.Scalar;

/**
 * Lets a program check the inertias it divides by: what the bodies beyond a joint answer to it with
 * the joints beyond it free, which vanishes where nothing resists.
 */
public final class Pivots {
  /** A pivot below this part of the inertia it is left of is rounding (NUMERICS §2, DTR). */
  private static final double SINGULAR = 64 * 0x1p-52;

  /** Own inertia above this part of all inertia beyond the joint is never rounding. */
  private static final double CLEARLY_POSITIVE = 1e-12;

  /** The same where a joint slides on the way, so that the inertia beyond grows with q. */
  private static final double CLEARLY_POSITIVE_SLIDING = 1e-9;

  private final Program program;
  private final Expressions expressions;
  private final List<Link> links;
  private final Coordinates coordinates;
  private final InertiaBound[] bounds;
  private final InertiaBound[] boundsAtStart;
  private final boolean checked;

  /**
   * @param checked whether the program checks pivots
   */
  public Pivots(Program program, List<Link> links, Coordinates coordinates, boolean checked) {
    this.program = program;
    this.expressions = program.expressions();
    this.links = links;
    this.coordinates = coordinates;
    this.checked = checked;
    this.bounds = InertiaBound.of(expressions, links, this::slid);
    this.boundsAtStart = InertiaBound.of(expressions, links, this::slidAtStart);
  }

  /**
   * Lets the program check the pivot where it can vanish.
   *
   * @return whether it vanishes always
   */
  public boolean guarded(int i, DegreeOfFreedom freedom, Scalar pivot) {
    Link link = links.get(i);
    Scalar all = bounds[i].along(link);
    double clearly = all.isConstant() ? CLEARLY_POSITIVE : CLEARLY_POSITIVE_SLIDING;
    if (freedom.ownInertia(link) > clearly * boundsAtStart[i].along(link).value()) {
      return false;
    }
    Scalar bound = all.times(SINGULAR);
    boolean known = pivot.isConstant() && bound.isConstant();
    boolean always = pivot.isZero() || (known && pivot.value() <= bound.value());
    if (checked && (always || !known)) {
      String meaning = "no inertia beyond the joint";
      program.guard(new Program.Guard(pivot, bound, link.stateJoint(), meaning));
    }
    return always;
  }

  /** The size of the way along a sliding link. */
  private Scalar slid(Link link) {
    return coordinates.way(link).squared().squareRoot();
  }

  /** The same at the start, with a metre to spare. */
  private Scalar slidAtStart(Link link) {
    return expressions.constant(1 + Math.abs(link.way() * link.initialPosition()));
  }
}
