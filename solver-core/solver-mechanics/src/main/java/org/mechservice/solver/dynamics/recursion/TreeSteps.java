package org.mechservice.solver.dynamics.recursion;

import java.util.Arrays;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.dynamics.recursion.StepBlocks.Step;
import org.mechservice.solver.dynamics.tree.PivotCheck;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.step.StepBlock;

/**
 * The recursions over an open tree, of any size, by printed steps: one method per kind of joint and
 * sweep ({@code solver.step}), with the numbers of each link in its block of one array. Generated
 * code is derived from the same steps.
 *
 * <p>Accelerations are those of the articulated-body algorithm (DTR, Featherstone 2008, ch. 7),
 * forces those of the recursive Newton-Euler algorithm (§5.3). Driven joints are not eliminated;
 * their driving forces are computed (§9.2). Rods with mass, which couple two bodies, are not known.
 *
 * <p>Workspace of one thread; nothing allocates after construction.
 */
public final class TreeSteps {
  private final TreeGeometry tree;
  private final StepBlocks blocks;
  private final BodyLoads bodies;
  private final double[] w;
  private final double[] driving;

  /**
   * Prepares the steps of a tree.
   *
   * @param motion has the coordinates, set by the caller before each evaluation; its links need not
   *     be swept
   */
  public TreeSteps(TreeMotion motion) {
    tree = motion.tree();
    blocks = new StepBlocks(motion, false, 0);
    w = blocks.w;
    putGravity(blocks.links.gravity());
    bodies = new BodyLoads(tree, blocks.links, blocks.blocks);
    driving = new double[tree.velocityCount - tree.stateVelocityCount];
  }

  /** An acceleration of the root opposite to gravity represents gravity on every body. */
  private void putGravity(Vector3 gravity) {
    w[StepBlock.MOTION + 6] = 0 - gravity.x();
    w[StepBlock.MOTION + 7] = 0 - gravity.y();
    w[StepBlock.MOTION + 8] = 0 - gravity.z();
  }

  /** Returns the check of the pivots of the last accelerations. */
  public PivotCheck check() {
    return blocks.check();
  }

  /**
   * Returns the driving forces of the last accelerations, in addition to joint forces applied
   * there, in the order of the extended velocities, N·m or N; must not be modified.
   */
  public double[] drivingForces() {
    return driving;
  }

  /**
   * Solves M(q) a + b(q, v) = τ + Jᵀ w.
   *
   * @param wrench external wrenches [moment; force] in link axes at the reference points, 6 per
   *     link, N·m, N; empty for none; not modified
   * @param tau joint forces, one per extended velocity, N·m or N; not modified
   * @param a joint accelerations in state order from {@code aAt}, rad/s² or m/s²; overwritten
   * @param aAt where the accelerations begin
   * @return {@link ExplicitModel#REGULAR}, or the index of a velocity without inertia
   */
  public int accelerations(double[] wrench, double[] tau, double[] a, int aAt) {
    bodies.load(wrench, w);
    for (Step step : blocks.steps) {
      if (!step.isTurn()) {
        blocks.place(step, tau);
        if (!step.driven()) {
          Arrays.fill(w, step.known(), step.known() + step.kind().velocityCount(), 0);
        }
      }
      step.kernel().motion(w, step.at(), step.parent());
    }
    blocks.startChecks();
    for (int i = blocks.steps.length - 1; i >= 0; i--) {
      int singular = inwards(blocks.steps[i]);
      if (singular != ExplicitModel.REGULAR) {
        blocks.clear();
        return singular;
      }
    }
    for (Step step : blocks.steps) {
      outwards(step, a, aAt);
    }
    return ExplicitModel.REGULAR;
  }

  private int inwards(Step step) {
    if (step.isTurn() || step.driven()) {
      if (!step.onRoot()) {
        step.kernel().pass(w, step.at(), step.parent());
      }
      return ExplicitModel.REGULAR;
    }
    if (step.onRoot()) {
      step.kernel().inertiaOnRoot(w, step.at(), step.parent());
    } else {
      step.kernel().inertia(w, step.at(), step.parent());
    }
    return blocks.singular(step);
  }

  private void outwards(Step step, double[] a, int aAt) {
    if (step.isTurn()) {
      step.kernel().carry(w, step.at(), step.parent());
    } else if (step.driven()) {
      step.kernel().carry(w, step.at(), step.parent());
      step.kernel().driving(w, step.at(), step.parent());
      blocks.get(step, driving, 0 - tree.stateVelocityCount);
    } else {
      step.kernel().acceleration(w, step.at(), step.parent());
      blocks.get(step, a, aAt);
    }
  }

  /**
   * Writes M(q) a + b(q, v) − τ − Jᵀ w.
   *
   * @param wrench as for {@link #accelerations}
   * @param tau as for {@link #accelerations}
   * @param a accelerations of the state from {@code aAt}; not modified
   * @param out one number per extended velocity, N·m or N; overwritten; entries of driven
   *     velocities are the driving forces
   */
  public void forces(double[] wrench, double[] tau, double[] a, int aAt, double[] out) {
    bodies.load(wrench, w);
    for (Step step : blocks.steps) {
      if (!step.isTurn()) {
        blocks.place(step, tau);
        if (!step.driven()) {
          int count = step.kind().velocityCount();
          System.arraycopy(a, aAt + step.velocity(), w, step.known(), count);
        }
      }
      step.kernel().motion(w, step.at(), step.parent());
    }
    for (int i = blocks.steps.length - 1; i >= 0; i--) {
      Step step = blocks.steps[i];
      if (step.onRoot()) {
        step.kernel().forceOnRoot(w, step.at(), step.parent());
      } else {
        step.kernel().force(w, step.at(), step.parent());
      }
      if (!step.isTurn()) {
        blocks.get(step, out, 0);
      }
    }
  }
}
