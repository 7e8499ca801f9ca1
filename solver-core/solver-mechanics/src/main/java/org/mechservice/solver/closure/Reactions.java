package org.mechservice.solver.closure;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.closure.assembly.ScaledJacobian;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.dynamics.recursion.JointReactions;
import org.mechservice.solver.mechanism.closure.JointClosure;

/**
 * Multipliers of closed loops and reactions of tree joints and cut joints, at a state with known
 * accelerations: M v' + b − τ + Jᵀ λ = 0.
 *
 * <p>Multipliers of redundant equations are not unique ({@link #areUnique}). The ones written have
 * the least norm; forces are multiplied by a length of the mechanism to compare them with moments.
 *
 * <p>A joint's reaction consists of its constraint forces and of the forces of its prescribed
 * motion; springs, dampers, motors and friction along its coordinates are not part of it. Workspace
 * of one thread; nothing allocates after construction.
 */
public final class Reactions {
  private final ClosedTree work;
  private final int rank;
  private final JointReactions joints;
  private final ScaledJacobian jacobian;
  private final List<JointClosure> cutJoints = new ArrayList<>();
  private final CutReaction[] cuts;
  private final double[] residual;
  private final double[] loads;
  private final double[] tau;

  /**
   * λ, one per loop equation in their order, N or N·m; positive if it opposes growing Φ, as the
   * tension of a rod does.
   */
  public final double[] multipliers;

  /**
   * Reactions of the tree's joints, [force; moment] per joint in file order, N, N·m: the load of
   * the inner body on the outer one, at the joint's point on the outer one, world axes.
   */
  public final double[] onJoints;

  /**
   * Reactions of the cut joints, [force; moment] per joint in the order of {@link #cutJoints}, N,
   * N·m: the load of body 1 on body 2, at the joint's point on body 2, world axes.
   */
  public final double[] onCutJoints;

  /**
   * @param work the equations; its motion, forces and loops are evaluated at each state
   * @param rank number of independent equations among those of the loops
   */
  public Reactions(ClosedTree work, int rank) {
    this.work = work;
    this.rank = rank;
    joints = new JointReactions(work.motion);
    onJoints = joints.wrench;
    LoopEquations loops = work.loops;
    jacobian = new ScaledJacobian(loops, work.units.velocities);
    residual = new double[work.tree.velocityCount];
    loads = new double[work.wrench.length];
    tau = new double[work.tau.length];
    multipliers = new double[loops.count()];
    cuts = cuts().toArray(CutReaction[]::new);
    onCutJoints = new double[6 * cuts.length];
  }

  private List<CutReaction> cuts() {
    List<CutReaction> found = new ArrayList<>();
    LoopEquations loops = work.loops;
    for (int row = 0; row < loops.count(); row++) {
      boolean first = row == 0 || loops.closure(row) != loops.closure(row - 1);
      if (first && loops.closure(row) instanceof JointClosure joint) {
        cutJoints.add(joint);
        found.add(new CutReaction(joint, work.tree, loops, row));
      }
    }
    return found;
  }

  /** Returns the cut joints with reactions, in the order of their equations. */
  public List<JointClosure> cutJoints() {
    return List.copyOf(cutJoints);
  }

  /** Returns the equations the multipliers belong to. */
  public LoopEquations equations() {
    return work.loops;
  }

  /** Returns whether the multipliers are unique: no equation is redundant. */
  public boolean areUnique() {
    return rank == work.loops.count();
  }

  /**
   * Evaluates multipliers and reactions.
   *
   * @param t time, s
   * @param y state [q; v] that closes the loops; not modified
   * @param a accelerations v' from {@code aAt} that satisfy the equations of motion; not modified
   * @return false if a force has no value there
   */
  public boolean evaluate(double t, double[] y, double[] a, int aAt) {
    work.place(t, y);
    if (!work.formResidual(t, a, aAt, residual)) {
      return false;
    }
    jacobian.decompose();
    jacobian.multipliers(rank, residual, multipliers);
    System.arraycopy(work.wrench, 0, loads, 0, loads.length);
    System.arraycopy(work.tau, 0, tau, 0, tau.length);
    work.loops.addForces(multipliers, -1, loads, tau);
    joints.evaluate(loads, tau);
    for (int i = 0; i < cuts.length; i++) {
      cuts[i].write(work.motion, multipliers, onCutJoints, 6 * i);
    }
    return true;
  }

  /** Returns why the last {@link #evaluate} had no value. */
  public Defect defect() {
    return work.forces.defect();
  }

  /**
   * Returns the force that moves a driven joint of the tree as prescribed, N·m or N.
   *
   * @param velocity the joint's velocity among the extended ones, which follow those of the state
   */
  public double drivingForce(int velocity) {
    return joints.drivingForce(velocity);
  }

  /**
   * Adds the power of what is prescribed in time, at the last {@link #evaluate}: the driving forces
   * of the tree's joints, and λ Φ_t of the loops' equations, which is zero where time does not
   * appear. It is unique even if multipliers are not, since Φ_t = −J v lies in the range of J.
   *
   * @param power sum and sum of the sizes, W, positive into the mechanism; added to
   */
  public void addPower(double[] power) {
    double[] v = work.motion.v;
    for (int i = work.nv; i < work.tree.velocityCount; i++) {
      add(drivingForce(i) * v[i], power);
    }
    LoopEquations loops = work.loops;
    for (int row = 0; row < multipliers.length; row++) {
      double byTime = loops.rate[row];
      for (int e = loops.jacobian.start[row]; e < loops.jacobian.start[row + 1]; e++) {
        byTime -= loops.jacobian.value[e] * v[loops.jacobian.column[e]];
      }
      add(multipliers[row] * byTime, power);
    }
  }

  private static void add(double term, double[] power) {
    power[0] += term;
    power[1] += Math.abs(term);
  }
}
