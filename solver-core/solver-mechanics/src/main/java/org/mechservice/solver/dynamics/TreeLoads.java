package org.mechservice.solver.dynamics;

import java.util.Arrays;
import org.mechservice.solver.force.ForceSet;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.kinematics.TreeMotion;

/** The loads on a tree except gravity, as wrenches and joint forces. Workspace of one thread. */
public final class TreeLoads {
  private final ForceSet forces;
  private final double[] wrench;
  private final double[] tau;

  /**
   * Prepares the forces of a mechanism.
   *
   * @param motion swept by the caller, world poses included, before each evaluation
   * @param source creates the user forces
   * @throws IllegalArgumentException if a force cannot be used; see {@link ForceSet}
   */
  public TreeLoads(TreeMotion motion, UserForceSource source) {
    forces = new ForceSet(motion, source);
    wrench = new double[forces.count() == 0 ? 0 : 6 * motion.tree().linkCount];
    tau = new double[motion.tree().velocityCount];
  }

  /** Returns the forces. */
  public ForceSet forces() {
    return forces;
  }

  /** Returns whether there are no forces but gravity. */
  public boolean isEmpty() {
    return forces.count() == 0;
  }

  /**
   * Evaluates all forces.
   *
   * @param t time, s
   * @return {@link ForceSet#REGULAR}, or the index of the force that has no finite value
   */
  public int evaluate(double t) {
    if (isEmpty()) {
      return ForceSet.REGULAR;
    }
    Arrays.fill(wrench, 0);
    Arrays.fill(tau, 0);
    return forces.apply(t, wrench, tau);
  }

  /**
   * Returns the wrenches of the last evaluation, [moment; force] in link axes at the reference
   * points, 6 per link, N·m, N; empty if there are no forces; not to be modified.
   */
  public double[] wrench() {
    return wrench;
  }

  /**
   * Returns the joint forces of the last evaluation, one per extended velocity, N·m or N; not to be
   * modified.
   */
  public double[] tau() {
    return tau;
  }
}
