package org.mechservice.solver.dynamics.recursion;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.kinematics.pair.CutJoint;
import org.mechservice.solver.kinematics.pair.PairFunction;
import org.mechservice.solver.kinematics.pair.RelativeMotion;
import org.mechservice.solver.mechanism.joint.Joint;

/**
 * Reactions of the joints of a tree: the wrench that a joint transmits, minus that of the springs,
 * dampers, motors and friction along its coordinates. Reactions consist of constraint forces and of
 * driving forces; they do no work in a free joint.
 *
 * <p>The wrench of a joint force τ is τ times the gradient of the coordinate, for joints of the
 * tree as for cut ones, so a reaction does not depend on the choice of the cut joint.
 *
 * <p>Workspace of one thread; nothing allocates after construction.
 */
public final class JointReactions {
  private final TreeGeometry tree;
  private final TreeMotion motion;
  private final NewtonEuler newtonEuler;
  private final MassiveRods rods;
  private final List<JointSide> sides = new ArrayList<>();

  /** [moment; force], 6 per link: first the load on it, then the wrench of its parent on it. */
  private final double[] loads;

  private final double[] onA = new double[6];
  private final double[] onB = new double[6];

  /**
   * M a + b − τ of the last evaluation, one per extended velocity; the driving forces among them.
   */
  private final double[] residual;

  /**
   * Reactions, [force; moment] per joint in file order, N, N·m: the load of the inner body on the
   * outer one, at the joint's point on the outer one, in world axes.
   */
  public final double[] wrench;

  /**
   * @param motion motion of the tree, swept by the caller before each evaluation
   */
  public JointReactions(TreeMotion motion) {
    this.motion = motion;
    tree = motion.tree();
    newtonEuler = new NewtonEuler(motion, new LinkInertias(tree));
    rods = new MassiveRods(tree);
    for (Joint joint : tree.mechanism().joints()) {
      sides.add(new JointSide(tree, joint));
    }
    loads = new double[6 * tree.linkCount];
    residual = new double[tree.velocityCount];
    wrench = new double[6 * sides.size()];
  }

  /** A joint of the tree: its coordinates, and the link of its child. */
  private static final class JointSide {
    final int child;
    final int velocityAt;
    final RelativeMotion relative;
    final PairFunction[] coordinates;

    JointSide(TreeGeometry tree, Joint joint) {
      child = tree.linkOf(joint.attachment().child());
      int first = child;
      while (tree.parent[first] != TreeGeometry.ROOT
          && tree.joint[tree.parent[first]] == tree.joint[child]) {
        first = tree.parent[first];
      }
      velocityAt = tree.velocityAt[first] - tree.component[first];
      CutJoint cut = new CutJoint(tree, joint);
      relative = cut.relative();
      coordinates = new PairFunction[joint.type().velocityCount()];
      for (int k = 0; k < coordinates.length; k++) {
        coordinates[k] = cut.coordinate(k);
      }
    }
  }

  /**
   * Evaluates the reactions for the motion's last sweep and acceleration sweep.
   *
   * @param applied wrenches on the links, [moment; force] in link axes at the reference points, 6
   *     per link, N·m, N: of forces and of the loops; rods with mass are added here; not modified
   * @param tau joint forces, one per extended velocity, N·m or N; not modified
   */
  public void evaluate(double[] applied, double[] tau) {
    System.arraycopy(applied, 0, loads, 0, loads.length);
    rods.addForces(motion, loads);
    newtonEuler.evaluate(loads, tau, residual);
    System.arraycopy(newtonEuler.force, 0, loads, 0, loads.length);
    for (int j = 0; j < sides.size(); j++) {
      subtractJointForces(sides.get(j), tau);
      write(sides.get(j).child, 6 * j);
    }
  }

  private void subtractJointForces(JointSide side, double[] tau) {
    boolean placed = false;
    for (int k = 0; k < side.coordinates.length; k++) {
      double force = tau[side.velocityAt + k];
      if (force != 0) {
        if (!placed) {
          side.relative.place(motion);
          placed = true;
        }
        side.coordinates[k].evaluate(side.relative);
        subtract(side, side.coordinates[k].gradient, force);
      }
    }
  }

  private void subtract(JointSide side, double[] gradient, double force) {
    side.relative.wrenches(gradient, onA, onB);
    double[] onChild = side.relative.linkB() == side.child ? onB : onA;
    for (int i = 0; i < 6; i++) {
      loads[6 * side.child + i] -= force * onChild[i];
    }
  }

  /** Converts [moment; force] in link axes to [force; moment] in world axes. */
  private void write(int link, int at) {
    motion.toWorld(link, loads, 6 * link + 3, wrench, at);
    motion.toWorld(link, loads, 6 * link, wrench, at + 3);
  }

  /**
   * Returns a driving force of the last evaluation.
   *
   * @param velocity among the extended velocities, those of a driven joint
   */
  public double drivingForce(int velocity) {
    return residual[velocity];
  }
}
