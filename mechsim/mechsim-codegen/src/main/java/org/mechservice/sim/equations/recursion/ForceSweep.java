package org.mechservice.sim.equations.recursion;

import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.sim.equations.links.AxesChange;
import org.mechservice.sim.equations.links.Link;
import org.mechservice.sim.equations.links.Links;
import org.mechservice.sim.equations.links.Motion;
import org.mechservice.sim.equations.links.Wrench;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * First sweep, outwards: the motion of each body and its inertia wrench, with zero or given joint
 * accelerations (recursive Newton-Euler, Featherstone 2008, §5.3).
 *
 * <p>Accelerations are those of points of the bodies, so no linear velocity occurs; W is formed
 * once per body and used for its centre of mass and all its joints.
 */
public final class ForceSweep {
  private final Program program;
  private final Expressions expressions;
  private final Links mechanism;
  private final Coordinates coordinates;
  private final Motion[] motions;
  private final ScalarMatrix[] spreads;
  private final Motion root;

  public ForceSweep(Program program, Links mechanism, Coordinates coordinates) {
    this.program = program;
    this.expressions = program.expressions();
    this.mechanism = mechanism;
    this.coordinates = coordinates;
    this.motions = new Motion[mechanism.links().size()];
    this.spreads = new ScalarMatrix[mechanism.links().size()];
    ScalarVector none = ScalarVector.zero(expressions);
    // An acceleration of the root opposite to gravity represents gravity on every body.
    this.root = new Motion(none, none, ScalarVector.of(expressions, mechanism.gravity().negated()));
  }

  /** Returns the inertia wrench of each link's body, about its computing origin. */
  public Wrench[] sweep() {
    Wrench[] needed = new Wrench[motions.length];
    for (int i = 0; i < motions.length; i++) {
      Link link = mechanism.links().get(i);
      program.section(title(link), link.bodyLabel());
      motions[i] = moved(link);
      String label = link.bodyLabel();
      program.named("omega_" + label, motions[i].omega());
      program.named("alpha_" + label, motions[i].alpha());
      program.named("a_" + label, motions[i].acceleration());
      spreads[i] = program.named("W_" + label, motions[i].spread());
      needed[i] = needed(link, motions[i], spreads[i]);
    }
    return needed;
  }

  /** Returns the motion of a link after the sweep, with gravity as an acceleration of the root. */
  public Motion motion(int link) {
    return link == Links.ROOT ? root : motions[link];
  }

  private static String title(Link link) {
    return "Sweep 1, outwards: "
        + link.title()
        + ".\n"
        + equation(link)
        + (link.mass() == 0 ? "" : ", f = m (a + W c), n = I alpha + omega x I omega + c x f");
  }

  private static String equation(Link link) {
    return switch (link.kind()) {
      case TURN ->
          "omega = R' omega_p + v z, alpha = R' alpha_p + v omega x z, a = R' (a_p + W_p r)";
      case SLIDE ->
          "omega = R' omega_p, alpha = R' alpha_p, a = R' (a_p + W_p r) + q W z + 2 v omega x z";
      case SCREW ->
          "omega = R' omega_p + v z, alpha = R' alpha_p + v omega x z,"
              + " a = R' (a_p + W_p (r + h q z) + 2 h v omega_p x z)";
      default ->
          link.inverse()
              ? "omega = R' omega_p - v, alpha = R' (alpha_p) - R' omega_p x v, a = R' (a_p + W_p"
                  + " r)"
              : "omega = R' (omega_p + v), alpha = R' (alpha_p + omega_p x v), a = R' (a_p + W_p"
                  + " r)";
    };
  }

  /** Returns the motion of the parent at the joint, in the child's axes at q = 0. */
  private Motion atJoint(Link link) {
    Motion parent = link.parent() == Links.ROOT ? root : motions[link.parent()];
    ScalarVector acceleration = parent.acceleration();
    if (link.parent() != Links.ROOT) {
      ScalarVector offset = ScalarVector.of(expressions, link.offset());
      acceleration = acceleration.plus(spreads[link.parent()].times(offset));
    }
    AxesChange axes = link.axes();
    return new Motion(
        axes.toChild(parent.omega()), axes.toChild(parent.alpha()), axes.toChild(acceleration));
  }

  private Motion moved(Link link) {
    Motion motion = atJoint(link);
    if (link.isBall()) {
      return link.inverse() ? turnedBack(link, motion) : turnedBall(link, motion);
    }
    Motion slid = link.slides() ? slid(link, motion) : motion;
    return link.turns() ? turned(link, slid) : slid;
  }

  private Motion turned(Link link, Motion joint) {
    Scalar cosine = coordinates.cosine(link);
    Scalar back = coordinates.sine(link).negated();
    Scalar v = coordinates.velocity(link);
    ScalarVector omega = joint.omega().turned(2, cosine, back);
    ScalarVector alpha = joint.alpha().turned(2, cosine, back).plus(acrossZ(omega).times(v));
    return new Motion(
        alongZ(omega, v),
        alongZ(alpha, coordinates.knownAcceleration(link)),
        joint.acceleration().turned(2, cosine, back));
  }

  private Motion slid(Link link, Motion joint) {
    Scalar twiceV = coordinates.wayRate(link).times(2);
    ScalarVector relative = joint.spread().column(2).times(coordinates.way(link));
    ScalarVector coriolis = acrossZ(joint.omega()).times(twiceV);
    ScalarVector acceleration = joint.acceleration().plus(relative).plus(coriolis);
    Scalar driven = coordinates.knownAcceleration(link).times(link.way());
    return new Motion(joint.omega(), joint.alpha(), alongZ(acceleration, driven));
  }

  /** Returns the motion of a ball whose angular velocity v is in parent axes. */
  private Motion turnedBall(Link link, Motion joint) {
    ScalarMatrix toChild = coordinates.ballRotation(link).transposed();
    ScalarVector v = coordinates.ballVelocity(link);
    ScalarVector added = joint.omega().cross(v).plus(coordinates.knownBallAcceleration(link));
    return new Motion(
        toChild.times(joint.omega().plus(v)),
        toChild.times(joint.alpha().plus(added)),
        toChild.times(joint.acceleration()));
  }

  /** Returns the motion of a ball whose angular velocity −v is in the link's own axes. */
  private Motion turnedBack(Link link, Motion joint) {
    ScalarMatrix toChild = coordinates.ballRotation(link).transposed();
    ScalarVector back = coordinates.ballVelocity(link).map(Scalar::negated);
    ScalarVector omega = toChild.times(joint.omega());
    return new Motion(
        omega.plus(back),
        toChild
            .times(joint.alpha())
            .plus(omega.cross(back))
            .minus(coordinates.knownBallAcceleration(link)),
        toChild.times(joint.acceleration()));
  }

  private static ScalarVector alongZ(ScalarVector vector, Scalar more) {
    return new ScalarVector(vector.x(), vector.y(), vector.z().plus(more));
  }

  /** Returns v × z. */
  private ScalarVector acrossZ(ScalarVector v) {
    return new ScalarVector(v.y(), v.x().negated(), expressions.zero());
  }

  private Wrench needed(Link link, Motion motion, ScalarMatrix spread) {
    ScalarVector center = ScalarVector.of(expressions, link.centerOfMass());
    ScalarVector atCenter = motion.acceleration().plus(spread.times(center));
    Scalar mass = expressions.constant(link.mass());
    ScalarVector force = program.named("f_" + link.bodyLabel(), atCenter.times(mass));
    ScalarVector moment = momentAboutCenter(link, motion, spread).plus(center.cross(force));
    return new Wrench(program.named("n_" + link.bodyLabel(), moment), force);
  }

  /** I α + ω × I ω. */
  private ScalarVector momentAboutCenter(Link link, Motion motion, ScalarMatrix spread) {
    InertiaTensor inertia = link.inertia();
    double[][] tensor = {
      {inertia.xx(), inertia.xy(), inertia.xz()},
      {inertia.xy(), inertia.yy(), inertia.yz()},
      {inertia.xz(), inertia.yz(), inertia.zz()}
    };
    return new ScalarVector(
        moment(tensor, motion, spread, 0),
        moment(tensor, motion, spread, 1),
        moment(tensor, motion, spread, 2));
  }

  /**
   * Component i of I α + ω × I ω, with j, k following i in the cycle: diagonal part + Iik Wji − Iij
   * Wki + Ijk (ωj² − ωk²).
   */
  private Scalar moment(double[][] inertia, Motion motion, ScalarMatrix spread, int i) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    Scalar squares = motion.omega().at(j).squared().minus(motion.omega().at(k).squared());
    return diagonalPart(inertia, motion, spread, i)
        .plus(spread.at(j, i).times(inertia[i][k]))
        .minus(spread.at(k, i).times(inertia[i][j]))
        .plus(squares.times(inertia[j][k]));
  }

  /**
   * Iii αi + (Ikk − Ijj) ωj ωk, or the same as Σjj Wkj − Σkk Wjk with Σ the second moments of mass,
   * whichever has fewer terms: a slender rod has one second moment, a wheel two equal moments of
   * inertia.
   */
  private static Scalar diagonalPart(
      double[][] inertia, Motion motion, ScalarMatrix spread, int i) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    double ii = inertia[i][i];
    double difference = inertia[k][k] - inertia[j][j];
    double secondJ = (inertia[i][i] + inertia[k][k] - inertia[j][j]) / 2;
    double secondK = (inertia[i][i] + inertia[j][j] - inertia[k][k]) / 2;
    if (nonZeros(ii, difference) <= nonZeros(secondJ, secondK)) {
      Scalar product = motion.omega().at(j).times(motion.omega().at(k));
      return motion.alpha().at(i).times(ii).plus(product.times(difference));
    }
    return spread.at(k, j).times(secondJ).minus(spread.at(j, k).times(secondK));
  }

  private static int nonZeros(double a, double b) {
    return (a == 0 ? 0 : 1) + (b == 0 ? 0 : 1);
  }
}
