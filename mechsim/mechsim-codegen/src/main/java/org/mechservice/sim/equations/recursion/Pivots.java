package org.mechservice.sim.equations.recursion;

import java.util.List;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.SmallTensor;
import org.mechservice.solver.step.DegreeOfFreedom;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;

/**
 * Adds checks of pivots to a program. A pivot is the inertia beyond a joint with all joints beyond
 * it free; it is zero if the joint moves no inertia.
 */
public final class Pivots {
  /**
   * Fraction of the locked inertia below which a pivot is rounding
   * (docs/theory/formulations.md#pivots).
   */
  private static final double SINGULAR = 64 * 0x1p-52;

  /**
   * Fraction of all inertia beyond the joint above which a body's own inertia is never rounding.
   */
  private static final double CLEARLY_POSITIVE = 1e-12;

  /** The same fraction if a sliding joint is beyond, so that the inertia grows with q. */
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
   * Adds a check of a pivot that can be zero.
   *
   * @return whether it is always zero
   */
  public boolean guarded(int i, DegreeOfFreedom freedom, Scalar pivot) {
    Link link = links.get(i);
    Scalar all = bounds[i].along(link);
    double clearly = all.isConstant() ? CLEARLY_POSITIVE : CLEARLY_POSITIVE_SLIDING;
    if (ownInertia(freedom, link) > clearly * boundsAtStart[i].along(link).value()) {
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

  /** Returns the link's own inertia along a degree of freedom: kg·m², or kg. */
  private static double ownInertia(DegreeOfFreedom freedom, Link link) {
    if (link.isBall()) {
      return link.armature() + SmallTensor.pivots(link.inertiaAtOrigin())[freedom.axis()];
    }
    double turning = freedom.turns() ? link.inertiaAtOrigin().zz() : 0;
    return link.armature() + turning + link.way() * link.way() * link.mass();
  }

  /** Returns the absolute displacement of a sliding link. */
  private Scalar slid(Link link) {
    return coordinates.way(link).squared().squareRoot();
  }

  /** Returns the absolute displacement at the start plus one metre. */
  private Scalar slidAtStart(Link link) {
    return expressions.constant(1 + Math.abs(link.way() * link.initialPosition()));
  }
}
