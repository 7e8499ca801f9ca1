package org.mechservice.solver.analysis;

import static org.mechservice.solver.spatial.Blocks.cross;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.force.ForceSet;
import org.mechservice.solver.force.UserForceSource;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.Attachment;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.mechanism.force.JointFriction;
import org.mechservice.solver.mechanism.force.JointSpringDamper;

/** What passes through a cut joint, on its body 2 at that body's point. */
final class CutReaction {
  private final EquationsOfMotion equations;

  /** Forces that act in the joint's own coordinates. */
  private final ForceSet inJoint;

  /** A body of the joint that moves: body 2 unless that is the root. */
  private final int link;

  /** 1 for body 2, −1 for body 1, which takes the opposite. */
  private final int sign;

  private final int link2;

  /** Multipliers of this joint's equations, zero elsewhere. */
  private final double[] lambda;

  private final boolean[] own;
  private final double[] wrench;
  private final double[] tau;
  private final double[] point = new double[3];
  private final double[] joint = new double[3];
  private final double[] reference = new double[3];
  private final double[] arm = new double[3];
  private final double[] moment = new double[3];

  CutReaction(EquationsOfMotion equations, UserForceSource userForces, int closure) {
    this.equations = equations;
    TreeGeometry tree = equations.tree;
    LoopClosure cut = tree.mechanism().closures().get(closure);
    Attachment attachment = ((JointClosure) cut).joint().attachment();
    boolean second = attachment.child() != Mechanism.ROOT;
    sign = second ? 1 : -1;
    link = tree.linkOf(second ? attachment.child() : attachment.parent());
    link2 = tree.linkOf(attachment.child());
    tree.fromReference(new BodyPoint(attachment.child(), attachment.childPoint()), point, 0);
    inJoint =
        new ForceSet(equations.motion, userForces, forcesIn(closure, tree.mechanism().forces()));
    lambda = new double[equations.lambda.length];
    own = new boolean[lambda.length];
    for (int row = 0; row < own.length; row++) {
      own[row] = equations.loops.closure(row) == cut;
    }
    wrench = new double[equations.wrench.length];
    tau = new double[equations.tau.length];
  }

  private static List<ForceElement> forcesIn(int closure, List<ForceElement> all) {
    List<ForceElement> inJoint = new ArrayList<>();
    for (ForceElement force : all) {
      if (coordinateOf(force) instanceof ClosureCoordinate cut && cut.closure() == closure) {
        inJoint.add(force);
      }
    }
    return inJoint;
  }

  /** Returns the coordinate a force acts in; that of no cut joint if it acts elsewhere. */
  private static Coordinate coordinateOf(ForceElement force) {
    if (force instanceof JointSpringDamper spring) {
      return spring.coordinate();
    } else if (force instanceof JointFriction friction) {
      return friction.coordinate();
    }
    return force instanceof JointForce given ? given.coordinate() : new ClosureCoordinate(-1, 0);
  }

  /** Writes force and moment, six numbers. */
  void write(double t, double[] values, int at) {
    Arrays.fill(wrench, 0);
    Arrays.fill(tau, 0);
    for (int row = 0; row < lambda.length; row++) {
      lambda[row] = own[row] ? equations.lambda[row] : 0;
    }
    equations.loops.addForces(lambda, -1, wrench, tau);
    inJoint.apply(t, wrench, tau);
    inJoint.accepted();
    equations.motion.toWorld(link, wrench, 6 * link + 3, values, at);
    equations.motion.toWorld(link, wrench, 6 * link, values, at + 3);
    equations.motion.pointPosition(link2, point, 0, joint, 0);
    System.arraycopy(equations.motion.worldPosition, 3 * link, reference, 0, 3);
    for (int i = 0; i < 3; i++) {
      arm[i] = reference[i] - joint[i];
    }
    cross(arm, 0, values, at, moment, 0);
    for (int i = 0; i < 3; i++) {
      values[at + i] *= sign;
      values[at + 3 + i] = sign * (values[at + 3 + i] + moment[i]);
    }
  }
}
