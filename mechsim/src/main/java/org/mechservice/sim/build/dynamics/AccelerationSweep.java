package org.mechservice.sim.build.dynamics;

import java.util.List;
import org.mechservice.sim.symbolic.Expressions;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.sim.symbolic.Scalar;
import org.mechservice.sim.symbolic.ScalarVector;

/**
 * Third sweep, outwards: joint accelerations q'' = u / D − (U / D) · A, with A what the joint
 * accelerations nearer the root add to the motion of the first sweep (Featherstone 2008, §7.2).
 */
final class AccelerationSweep {
  /** What joint accelerations add: angular and linear acceleration of a computing frame. */
  private record Added(ScalarVector alpha, ScalarVector acceleration) {}

  private final Program program;
  private final Expressions expressions;
  private final List<Link> links;
  private final JointAngles angles;
  private final InertiaSweep inertias;
  private final Added[] added;

  AccelerationSweep(Program program, Links mechanism, JointAngles angles, InertiaSweep inertias) {
    this.program = program;
    this.expressions = program.expressions();
    this.links = mechanism.links();
    this.angles = angles;
    this.inertias = inertias;
    this.added = new Added[links.size()];
  }

  /** Sweeps from the root to the leaves and puts the joint accelerations out. */
  void sweep() {
    for (int i = 0; i < added.length; i++) {
      Link link = links.get(i);
      program.section(
          "Sweep 3, outwards: " + link.title() + ".\nq'' = u / D - k.A, A = X' A_p + q'' z",
          link.bodyLabel());
      Added before = fromParent(link);
      Scalar acceleration = jointAcceleration(i, before);
      program.named("qdd_" + link.jointLabel(), acceleration);
      program.output(link.velocity(), acceleration);
      added[i] = after(link, before, acceleration);
      program.named("dalpha_" + link.bodyLabel(), added[i].alpha());
      program.named("da_" + link.bodyLabel(), added[i].acceleration());
    }
  }

  private Added fromParent(Link link) {
    if (link.parent() == Links.ROOT) {
      ScalarVector none = ScalarVector.zero(expressions);
      return new Added(none, none);
    }
    Added parent = added[link.parent()];
    ScalarVector offset = ScalarVector.of(expressions, link.offset());
    ScalarVector atJoint = parent.acceleration().plus(parent.alpha().cross(offset));
    ScalarVector alpha = link.axes().toChild(parent.alpha());
    ScalarVector acceleration = link.axes().toChild(atJoint);
    if (link.turns()) {
      Scalar cosine = angles.cosine(link);
      Scalar back = angles.sine(link).negated();
      return new Added(alpha.turned(2, cosine, back), acceleration.turned(2, cosine, back));
    }
    Scalar zero = expressions.zero();
    ScalarVector way = new ScalarVector(zero, zero, angles.position(link));
    return new Added(alpha, acceleration.plus(alpha.cross(way)));
  }

  private Scalar jointAcceleration(int i, Added before) {
    Wrench share = inertias.shares()[i];
    Scalar taken =
        share.moment().dot(before.alpha()).plus(share.force().dot(before.acceleration()));
    return inertias.driven()[i].minus(taken);
  }

  private static Added after(Link link, Added before, Scalar jointAcceleration) {
    ScalarVector alpha = before.alpha();
    ScalarVector acceleration = before.acceleration();
    return link.turns()
        ? new Added(
            new ScalarVector(alpha.x(), alpha.y(), alpha.z().plus(jointAcceleration)), acceleration)
        : new Added(
            alpha,
            new ScalarVector(
                acceleration.x(), acceleration.y(), acceleration.z().plus(jointAcceleration)));
  }
}
