package org.mechservice.solver.step;

import java.util.List;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * The step that each recursion over a tree takes from a link to its parent or back. The equations
 * of a mechanism's own program and those of the printed methods for any mechanism are both derived
 * by it, so that they have the same operations in the same order.
 *
 * <p>Quantities of a link are in its computing frame ({@code solver.links}). Accelerations are
 * those of points of the bodies, so no linear velocity occurs. Sources: Featherstone 2008, §5.3 and
 * §7.2; docs/theory/formulations.md.
 */
public final class LinkStep {
  /** The axis of joints that turn or slide. */
  private static final int Z = 2;

  private final Expressions expressions;
  private final LinkNumbers numbers;
  private final JointTerms joint;

  public LinkStep(Expressions expressions, LinkNumbers numbers, JointTerms joint) {
    this.expressions = expressions;
    this.numbers = numbers;
    this.joint = joint;
  }

  private boolean isBall() {
    return numbers.kind() == LinkKind.BALL;
  }

  private boolean turns() {
    return numbers.kind() == LinkKind.TURN || numbers.kind() == LinkKind.SCREW;
  }

  private boolean slides() {
    return !numbers.way().isZero();
  }

  /** Returns the degrees of freedom in the order of elimination; those of a fixed link are none. */
  public List<DegreeOfFreedom> freedoms() {
    return numbers.kind() == LinkKind.FIXED
        ? List.of()
        : DegreeOfFreedom.of(isBall(), turns(), numbers.way(), numbers.armature());
  }

  // The motion, outwards.

  /**
   * Returns the motion of the link.
   *
   * @param parent motion of its parent; that of the root is an acceleration opposite to gravity
   * @param spread W of the parent
   */
  public Motion motion(Motion parent, ScalarMatrix spread) {
    ScalarVector ofPoint = parent.acceleration().plus(spread.times(numbers.offset()));
    Motion atJoint = new Motion(toChild(parent.omega()), toChild(parent.alpha()), toChild(ofPoint));
    if (isBall()) {
      return numbers.inverse() ? turnedBack(atJoint) : turnedBall(atJoint);
    }
    Motion slid = slides() ? slid(atJoint) : atJoint;
    return turns() ? turned(slid) : slid;
  }

  private Motion turned(Motion before) {
    Scalar cosine = joint.cosine();
    Scalar back = joint.sine().negated();
    Scalar v = joint.velocity();
    ScalarVector omega = before.omega().turned(Z, cosine, back);
    ScalarVector alpha = before.alpha().turned(Z, cosine, back).plus(acrossZ(omega).times(v));
    return new Motion(
        alongZ(omega, v),
        alongZ(alpha, joint.knownAcceleration()),
        before.acceleration().turned(Z, cosine, back));
  }

  private Motion slid(Motion before) {
    Scalar twiceV = joint.wayRate().times(2);
    ScalarVector relative = before.spread().column(Z).times(joint.way());
    ScalarVector coriolis = acrossZ(before.omega()).times(twiceV);
    ScalarVector acceleration = before.acceleration().plus(relative).plus(coriolis);
    Scalar driven = joint.knownAcceleration().times(numbers.way());
    return new Motion(before.omega(), before.alpha(), alongZ(acceleration, driven));
  }

  /** Returns the motion of a ball whose angular velocity v is in parent axes. */
  private Motion turnedBall(Motion before) {
    ScalarMatrix toChild = joint.ballRotation().transposed();
    ScalarVector v = joint.ballVelocity();
    ScalarVector added = before.omega().cross(v).plus(joint.knownBallAcceleration());
    return new Motion(
        toChild.times(before.omega().plus(v)),
        toChild.times(before.alpha().plus(added)),
        toChild.times(before.acceleration()));
  }

  /** Returns the motion of a ball whose angular velocity −v is in the link's own axes. */
  private Motion turnedBack(Motion before) {
    ScalarMatrix toChild = joint.ballRotation().transposed();
    ScalarVector back = joint.ballVelocity().map(Scalar::negated);
    ScalarVector omega = toChild.times(before.omega());
    return new Motion(
        omega.plus(back),
        toChild.times(before.alpha()).plus(omega.cross(back)).minus(joint.knownBallAcceleration()),
        toChild.times(before.acceleration()));
  }

  private static ScalarVector alongZ(ScalarVector vector, Scalar more) {
    return new ScalarVector(vector.x(), vector.y(), vector.z().plus(more));
  }

  /** Returns v × z. */
  private ScalarVector acrossZ(ScalarVector v) {
    return new ScalarVector(v.y(), v.x().negated(), expressions.zero());
  }

  /** Returns the force that the motion of the link's own body takes: m (a + W c). */
  public ScalarVector inertiaForce(Motion motion, ScalarMatrix spread) {
    LinkNumbers.Body body = numbers.body();
    ScalarVector atCenter = motion.acceleration().plus(spread.times(body.center()));
    return atCenter.times(body.mass());
  }

  /**
   * Returns the moment that it takes about the computing origin: I α + ω × I ω + c × f.
   *
   * @param force f, the force that it takes
   */
  public ScalarVector inertiaMoment(Motion motion, ScalarMatrix spread, ScalarVector force) {
    ScalarVector aboutCenter =
        new ScalarVector(
            moment(motion, spread, 0), moment(motion, spread, 1), moment(motion, spread, 2));
    return aboutCenter.plus(numbers.body().center().cross(force));
  }

  /**
   * Component i of I α + ω × I ω, with j, k following i in the cycle: Iii αi + (Ikk − Ijj) ωj ωk +
   * Iik Wji − Iij Wki + Ijk (ωj² − ωk²).
   */
  private Scalar moment(Motion motion, ScalarMatrix spread, int i) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    ScalarMatrix own = numbers.body().inertia();
    ScalarVector omega = motion.omega();
    Scalar difference = own.at(k, k).minus(own.at(j, j));
    return motion
        .alpha()
        .at(i)
        .times(own.at(i, i))
        .plus(omega.at(j).times(omega.at(k)).times(difference))
        .plus(spread.at(j, i).times(own.at(i, k)))
        .minus(spread.at(k, i).times(own.at(i, j)))
        .plus(omega.at(j).squared().minus(omega.at(k).squared()).times(own.at(j, k)));
  }

  // Articulated inertias, inwards.

  /** Returns the inertia of the link's own body: J about the origin, H = m [c]×, M = m 1. */
  public ArticulatedInertia inertia() {
    LinkNumbers.Body body = numbers.body();
    Scalar zero = expressions.zero();
    return new ArticulatedInertia(
        body.second(),
        ScalarMatrix.cross(body.first()),
        ScalarMatrix.of((row, column) -> row == column ? body.mass() : zero));
  }

  /** Returns the inertia of the link's own body as a rigid one. */
  public RigidInertia rigidInertia() {
    LinkNumbers.Body body = numbers.body();
    return new RigidInertia(body.mass(), body.first(), body.second());
  }

  /**
   * The elimination of a degree of freedom from an articulated inertia.
   *
   * @param column U, the wrench of a unit acceleration
   * @param pivot D, its component along the freedom with the armature
   * @param reciprocal 1 / D
   * @param share U / D; the element of a plain degree of freedom is 1
   * @param rate u / D, the acceleration of the freedom for a parent without acceleration
   * @param inertia I − U Uᵀ / D
   * @param wrench p + U u / D
   */
  public record Elimination(
      Wrench column,
      Scalar pivot,
      Scalar reciprocal,
      Wrench share,
      Scalar rate,
      ArticulatedInertia inertia,
      Wrench wrench) {}

  /**
   * Eliminates a degree of freedom.
   *
   * @param force applied force along it
   * @param passedOn whether inertia and wrench are needed afterwards
   */
  public Elimination eliminate(
      DegreeOfFreedom freedom,
      ArticulatedInertia inertia,
      Wrench wrench,
      Scalar force,
      boolean passedOn) {
    Wrench column = inertia.along(freedom);
    Scalar pivot = freedom.pivot(column);
    Scalar reciprocal = expressions.one().over(pivot);
    Wrench divided =
        new Wrench(column.moment().times(reciprocal), column.force().times(reciprocal));
    Wrench share = freedom.with(divided, expressions.one());
    Scalar left = force.minus(freedom.along(wrench));
    // The reciprocal saves operations if the column is divided too, which is not needed at the
    // root.
    Scalar rate = passedOn ? left.times(reciprocal) : left.over(pivot);
    if (!passedOn) {
      return new Elimination(column, pivot, reciprocal, share, rate, inertia, wrench);
    }
    Wrench rest = rest(freedom, wrench, column, rate, force);
    ArticulatedInertia projected = inertia.projected(freedom, column, share);
    return new Elimination(column, pivot, reciprocal, share, rate, projected, rest);
  }

  /** Returns p + U u / D; its component along a plain degree of freedom is the joint force. */
  private static Wrench rest(
      DegreeOfFreedom freedom, Wrench wrench, Wrench column, Scalar rate, Scalar jointForce) {
    Wrench rest =
        new Wrench(
            wrench.moment().plus(column.moment().times(rate)),
            wrench.force().plus(column.force().times(rate)));
    return freedom.with(rest, freedom.turns() ? jointForce : jointForce.over(freedom.way()));
  }

  /**
   * The wrench of a multiplier, without what a degree of freedom gives way to.
   *
   * @param along kappa, its component along the freedom
   * @param rest K - (U / D) kappa
   */
  public record Coupled(Scalar along, Wrench rest) {}

  /**
   * Eliminates a degree of freedom from the wrench of a multiplier.
   *
   * @param share U / D
   * @param wrench K
   * @param direct force of the multiplier on the joint itself, which is not in K
   */
  public static Coupled couple(
      DegreeOfFreedom freedom, Wrench share, Wrench wrench, Scalar direct) {
    Scalar along = direct.plus(freedom.along(wrench));
    Wrench rest = wrench.minus(share.times(along));
    Scalar onJoint = direct.negated();
    return new Coupled(
        along, freedom.with(rest, freedom.turns() ? onJoint : onJoint.over(freedom.way())));
  }

  /** A wrench on a link, and the part u / D of a force along a degree of freedom. */
  public record Pushed(Scalar rate, Wrench rest) {}

  /**
   * Eliminates a degree of freedom from a wrench with the factors of its inertia.
   *
   * @param pivot D
   * @param share U / D
   * @param wrench p
   * @param force applied force along the freedom
   */
  public static Pushed push(
      DegreeOfFreedom freedom, Scalar pivot, Wrench share, Wrench wrench, Scalar force) {
    Scalar left = force.minus(freedom.along(wrench));
    Wrench rest = wrench.plus(share.times(left));
    return new Pushed(
        left.over(pivot), freedom.with(rest, freedom.turns() ? force : force.over(freedom.way())));
  }

  /** Returns a wrench on the link, or an inertia, in its parent's frame. */
  public <T extends Moved<T>> T toParent(T ofLink) {
    T atJoint = isBall() ? ofLink.in(joint.ballRotation()) : ofLink;
    if (turns()) {
      atJoint = atJoint.turned(Z, joint.cosine(), joint.sine());
    }
    if (slides()) {
      atJoint = atJoint.shifted(wayVector());
    }
    T before = atJoint.in(numbers.axes());
    return numbers
        .turn()
        .map(turn -> before.turned(turn.axis(), turn.cosine(), turn.sine()))
        .orElse(before)
        .shifted(numbers.offset());
  }

  private ScalarVector wayVector() {
    Scalar zero = expressions.zero();
    return new ScalarVector(zero, zero, joint.way());
  }

  // Accelerations, outwards.

  /**
   * The acceleration of a link that joint accelerations add to the motion of the first sweep.
   *
   * @param alpha angular acceleration, rad/s²
   * @param acceleration acceleration of the origin, m/s²
   */
  public record Added(ScalarVector alpha, ScalarVector acceleration) {
    /** Returns the power of a wrench per unit of time: w · A. */
    Scalar dot(Wrench wrench) {
      return wrench.moment().dot(alpha).plus(wrench.force().dot(acceleration));
    }
  }

  /** Returns the acceleration that the parent's adds to the link, with its joint locked. */
  public Added fromParent(Added parent) {
    ScalarVector atJoint = parent.acceleration().plus(parent.alpha().cross(numbers.offset()));
    ScalarVector alpha = toChild(parent.alpha());
    ScalarVector acceleration = toChild(atJoint);
    if (isBall()) {
      ScalarMatrix toChild = joint.ballRotation().transposed();
      return new Added(toChild.times(alpha), toChild.times(acceleration));
    }
    if (slides()) {
      acceleration = acceleration.plus(alpha.cross(wayVector()));
    }
    if (turns()) {
      Scalar cosine = joint.cosine();
      Scalar back = joint.sine().negated();
      alpha = alpha.turned(Z, cosine, back);
      acceleration = acceleration.turned(Z, cosine, back);
    }
    return new Added(alpha, acceleration);
  }

  /** Returns q'' = u / D − (U / D) · A of a degree of freedom. */
  public static Scalar rate(Scalar atRest, Wrench share, Added before) {
    return atRest.minus(before.dot(share));
  }

  /** Returns the acceleration with that of a degree of freedom. */
  public static Added after(DegreeOfFreedom freedom, Added before, Scalar rate) {
    ScalarVector alpha = before.alpha();
    ScalarVector acceleration = before.acceleration();
    int axis = freedom.axis();
    if (freedom.turns()) {
      alpha = freedom.replaced(alpha, alpha.at(axis).plus(rate));
    }
    if (freedom.slides()) {
      Scalar moved = acceleration.at(axis).plus(rate.times(freedom.way()));
      acceleration = freedom.replaced(acceleration, moved);
    }
    return new Added(alpha, acceleration);
  }

  /**
   * Converts rates or moments of a ball to the form of the state: those of the file's body 2
   * relative to its body 1, in the axes of body 1.
   *
   * @param inLink in link axes, of the link relative to its parent
   */
  public ScalarVector ballToState(ScalarVector inLink) {
    return numbers.inverse() ? inLink.map(Scalar::negated) : joint.ballRotation().times(inLink);
  }

  /**
   * Returns the force that the known joint acceleration takes of the armature, along an axis of the
   * link, N·m or N.
   */
  public Scalar armatureForce(DegreeOfFreedom freedom) {
    if (freedom.armature().isZero()) {
      return expressions.zero();
    }
    Scalar acceleration =
        isBall() ? knownBallInLink().at(freedom.axis()) : joint.knownAcceleration();
    return acceleration.times(freedom.armature());
  }

  /** Returns what {@link #ballToState} converts to the known acceleration. */
  private ScalarVector knownBallInLink() {
    ScalarVector known = joint.knownBallAcceleration();
    return numbers.inverse()
        ? known.map(Scalar::negated)
        : joint.ballRotation().transposed().times(known);
  }

  /**
   * Returns a vector of the parent's axes in those of the link before its joint moves.
   *
   * @param v in the parent's computing axes
   */
  public ScalarVector toChild(ScalarVector v) {
    ScalarVector before =
        numbers
            .turn()
            .map(turn -> v.turned(turn.axis(), turn.cosine(), turn.sine().negated()))
            .orElse(v);
    return numbers.axes().transposed().times(before);
  }
}
