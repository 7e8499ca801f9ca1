package org.mechservice.sim.build.dynamics;

import java.util.List;
import java.util.function.Function;
import org.mechservice.sim.symbolic.Expressions;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.sim.symbolic.Scalar;
import org.mechservice.sim.symbolic.ScalarVector;

/**
 * Second sweep, inwards: articulated inertias, and what the joints leave of the wrenches of the
 * first sweep (Featherstone 2008, §7.2, with the residual in place of the bias forces).
 *
 * <p>With U the column of the articulated inertia along the joint's axis, D its element on the
 * axis, and u the joint force less the wrench along the axis, the parent sees I − U Uᵀ / D and p +
 * U u / D.
 */
final class InertiaSweep {
  /** A pivot below this part of the inertia it is left of is rounding (NUMERICS §2, DTR). */
  private static final double SINGULAR = 64 * 0x1p-52;

  /** Own inertia above this part of all inertia beyond the joint is never rounding. */
  private static final double CLEARLY_POSITIVE = 1e-12;

  /** The same where a joint slides on the way, so that the inertia beyond grows with q. */
  private static final double CLEARLY_POSITIVE_SLIDING = 1e-9;

  private final Program program;
  private final Expressions expressions;
  private final List<Link> links;
  private final JointAngles angles;
  private final Function<Link, Scalar> jointForce;
  private final InertiaBound[] bounds;
  private final InertiaBound[] boundsAtStart;
  private final ArticulatedInertia[] inertias;
  private final Wrench[] wrenches;
  private final Wrench[] shares;
  private final Scalar[] driven;

  /**
   * @param wrenches what each body needs; overwritten with what all beyond it need
   * @param jointForce force along each joint, N·m or N
   */
  InertiaSweep(
      Program program,
      Links mechanism,
      JointAngles angles,
      Wrench[] wrenches,
      Function<Link, Scalar> jointForce) {
    this.program = program;
    this.expressions = program.expressions();
    this.links = mechanism.links();
    this.angles = angles;
    this.jointForce = jointForce;
    this.bounds = InertiaBound.of(expressions, links, link -> slid(angles, link));
    this.boundsAtStart = InertiaBound.of(expressions, links, link -> slidAtStart(angles, link));
    this.inertias = new ArticulatedInertia[links.size()];
    this.wrenches = wrenches;
    this.shares = new Wrench[links.size()];
    this.driven = new Scalar[links.size()];
  }

  /**
   * Sweeps from the leaves to the root.
   *
   * @return whether every joint can have an inertia; if not, the program ends with a guard that
   *     always holds
   */
  boolean sweep() {
    for (int i = 0; i < inertias.length; i++) {
      inertias[i] = ArticulatedInertia.of(expressions, links.get(i));
    }
    for (int i = links.size() - 1; i >= 0; i--) {
      if (!inwards(i, links.get(i))) {
        return false;
      }
    }
    return true;
  }

  /** Returns U / D of each joint; the element along the axis is 1. */
  Wrench[] shares() {
    return shares;
  }

  /** Returns u / D of each joint: its acceleration if its parent did not accelerate. */
  Scalar[] driven() {
    return driven;
  }

  private boolean inwards(int i, Link link) {
    program.section(
        "Sweep 2, inwards: "
            + link.title()
            + ".\nk = U / D, u = tau - p.z, I_p += X (I - U k') X', p_p += X (p + k u)",
        link.bodyLabel());
    Wrench column = named(link, inertias[i]).along(link.turns());
    Scalar pivot = program.named("D_" + link.jointLabel(), onAxis(link, column));
    if (guarded(i, link, pivot)) {
      return false;
    }
    Scalar reciprocal =
        program.named("one_over_D_" + link.jointLabel(), expressions.one().over(pivot));
    Wrench share = share(link, column, reciprocal);
    Scalar force = jointForce.apply(link);
    Scalar left = force.minus(onAxis(link, wrenches[i]));
    shares[i] = share;
    // The reciprocal pays where the column is divided too, which nothing needs at the root.
    Scalar atRest = link.parent() == Links.ROOT ? left.over(pivot) : left.times(reciprocal);
    driven[i] = program.named("u_over_D_" + link.jointLabel(), atRest);
    if (link.parent() != Links.ROOT) {
      ArticulatedInertia projected = inertias[i].projected(link.turns(), column, share);
      Wrench rest = rest(link, wrenches[i], column, driven[i], force);
      pass(link, projected, rest);
    }
    return true;
  }

  private ArticulatedInertia named(Link link, ArticulatedInertia inertia) {
    program.named("J_" + link.bodyLabel(), inertia.rotational());
    program.named("H_" + link.bodyLabel(), inertia.coupling());
    program.named("M_" + link.bodyLabel(), inertia.translational());
    return inertia;
  }

  private static Scalar onAxis(Link link, Wrench wrench) {
    return link.turns() ? wrench.moment().z() : wrench.force().z();
  }

  /**
   * Lets the program check the pivot where it can vanish.
   *
   * @return whether it vanishes always
   */
  private boolean guarded(int i, Link link, Scalar pivot) {
    Scalar all = bounds[i].along(link);
    double clearly = all.isConstant() ? CLEARLY_POSITIVE : CLEARLY_POSITIVE_SLIDING;
    if (link.ownInertia() > clearly * boundsAtStart[i].along(link).value()) {
      return false;
    }
    Scalar bound = all.times(SINGULAR);
    boolean known = pivot.isConstant() && bound.isConstant();
    boolean always = pivot.isZero() || (known && pivot.value() <= bound.value());
    if (always || !known) {
      program.guard(new Program.Guard(pivot, bound, link.joint(), "no inertia beyond the joint"));
    }
    return always;
  }

  /** |q| of a joint that slides. */
  private static Scalar slid(JointAngles angles, Link link) {
    return angles.position(link).squared().squareRoot();
  }

  /** The same at the start, with a metre to spare. */
  private static Scalar slidAtStart(JointAngles angles, Link link) {
    return angles.position(link).expressions().constant(1 + Math.abs(link.initialPosition()));
  }

  private Wrench share(Link link, Wrench column, Scalar reciprocal) {
    ScalarVector moment = column.moment().times(reciprocal);
    ScalarVector force = column.force().times(reciprocal);
    Scalar one = expressions.one();
    Wrench share =
        link.turns()
            ? new Wrench(new ScalarVector(moment.x(), moment.y(), one), force)
            : new Wrench(moment, new ScalarVector(force.x(), force.y(), one));
    program.named("kn_" + link.jointLabel(), share.moment());
    program.named("kf_" + link.jointLabel(), share.force());
    return share;
  }

  /** p + U u / D; along the axis that is the joint force. */
  private static Wrench rest(
      Link link, Wrench wrench, Wrench column, Scalar driven, Scalar jointForce) {
    ScalarVector moment = wrench.moment().plus(column.moment().times(driven));
    ScalarVector force = wrench.force().plus(column.force().times(driven));
    return link.turns()
        ? new Wrench(new ScalarVector(moment.x(), moment.y(), jointForce), force)
        : new Wrench(moment, new ScalarVector(force.x(), force.y(), jointForce));
  }

  /** Adds what the parent sees of a link to the parent. */
  private void pass(Link link, ArticulatedInertia inertia, Wrench wrench) {
    ArticulatedInertia atJoint;
    Wrench wrenchAtJoint;
    if (link.turns()) {
      Scalar cosine = angles.cosine(link);
      Scalar sine = angles.sine(link);
      atJoint = inertia.turned(2, cosine, sine);
      wrenchAtJoint = wrench.turned(2, cosine, sine);
    } else {
      Scalar zero = expressions.zero();
      ScalarVector way = new ScalarVector(zero, zero, angles.position(link));
      atJoint = inertia.shifted(way);
      wrenchAtJoint = wrench.shifted(way);
    }
    ScalarVector offset = ScalarVector.of(expressions, link.offset());
    int p = link.parent();
    inertias[p] = inertias[p].plus(atJoint.toParent(link.axes()).shifted(offset));
    wrenches[p] = wrenches[p].plus(wrenchAtJoint.toParent(link.axes()).shifted(offset));
  }
}
