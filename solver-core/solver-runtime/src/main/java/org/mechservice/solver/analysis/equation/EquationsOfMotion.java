package org.mechservice.solver.analysis.equation;

import java.util.Arrays;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.closure.assembly.ScaledJacobian;
import org.mechservice.solver.closure.equations.CoordinateUnits;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.dynamics.recursion.LinkInertias;
import org.mechservice.solver.dynamics.recursion.MassiveRods;
import org.mechservice.solver.dynamics.recursion.NewtonEuler;
import org.mechservice.solver.force.ForceSet;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * M v' + b − τ + Jᵀ λ = 0 and Φ(q, t) = 0 of a mechanism with or without loops, at one state at a
 * time, independent of the formulation of the integration. Workspace of one thread.
 *
 * <p>If loop equations are redundant, the multipliers are those of least norm, with forces
 * multiplied by the mechanism's length.
 */
public final class EquationsOfMotion {
  /** Relative residual at which loops are closed, and the residual that rounding may leave. */
  private static final double CLOSED = 1e-14;

  private static final double ROUNDED = 1e-11;
  private static final int ITERATIONS = 40;

  public final TreeGeometry tree;
  public final TreeMotion motion;
  public final LoopEquations loops;
  public final StateCoordinates coordinates;
  public final ForceSet forces;
  public final int nq;
  public final int nv;

  /** Applied wrenches, 6 per link, and joint forces, one per extended velocity. */
  public final double[] wrench;

  public final double[] tau;

  /** M v' + b − τ, with the forces of multipliers or without, one per extended velocity. */
  public final double[] residual;

  /** λ, one per equation of the loops, N or N·m. */
  public final double[] lambda;

  /** Unit of each velocity of the state, 1 or the mechanism's length in m, per second. */
  public final double[] unit;

  /** Applied wrenches and joint forces with those of the multipliers. */
  public final double[] loadedWrench;

  public final double[] loadedTau;

  /** J by its singular values, as decomposed last. */
  public final ScaledJacobian jacobian;

  /** Solution of {@link #solveLeast}, one number per velocity of the state. */
  public final double[] step;

  private final NewtonEuler newtonEuler;
  private final MassiveRods rods;
  private final double[] withRods;

  public EquationsOfMotion(Mechanism mechanism, UserForceSource userForces) {
    tree = new TreeGeometry(mechanism);
    motion = new TreeMotion(tree);
    loops = new LoopEquations(tree);
    coordinates = new StateCoordinates(mechanism);
    newtonEuler = new NewtonEuler(motion, new LinkInertias(tree));
    rods = new MassiveRods(tree);
    forces = new ForceSet(motion, userForces);
    nq = tree.statePositionCount;
    nv = tree.stateVelocityCount;
    wrench = new double[6 * tree.linkCount];
    tau = new double[tree.velocityCount];
    residual = new double[tree.velocityCount];
    lambda = new double[loops.count()];
    loadedWrench = new double[wrench.length];
    loadedTau = new double[tau.length];
    unit = new CoordinateUnits(mechanism, loops.length()).velocities;
    jacobian = new ScaledJacobian(loops, unit);
    step = new double[nv];
    withRods = new double[rods.isEmpty() ? 0 : wrench.length];
  }

  /** Sweeps places and velocities; evaluates Φ, J and Φ'. */
  public void place(double t, double[] y) {
    motion.sweep(t, y);
    loops.place(motion, t);
    loops.differentiate(motion);
    loops.move(motion, t);
  }

  /** Evaluates the applied forces at the last place; returns whether all have values. */
  public boolean applyForces(double t) {
    Arrays.fill(wrench, 0);
    Arrays.fill(tau, 0);
    return forces.apply(t, wrench, tau) == ForceSet.REGULAR;
  }

  /** Returns why {@link #applyForces} failed. */
  public Defect defect() {
    return forces.defect();
  }

  /**
   * Evaluates M v' + b − τ without multipliers.
   *
   * @param a v' from {@code aAt}; not modified
   */
  public void formResidual(double[] a, int aAt) {
    motion.accelerationSweep(a, aAt);
    sweepInward(wrench, tau);
  }

  private void sweepInward(double[] wrenches, double[] forces) {
    if (rods.isEmpty()) {
      newtonEuler.evaluate(wrenches, forces, residual);
      return;
    }
    System.arraycopy(wrenches, 0, withRods, 0, wrenches.length);
    rods.addForces(motion, withRods);
    newtonEuler.evaluate(withRods, forces, residual);
  }

  /**
   * Finds the least-squares multipliers of M v' + b − τ + Jᵀ λ = 0 after {@link #formResidual}, and
   * adds their forces to the residual and the transmitted wrenches.
   */
  public void balance() {
    System.arraycopy(wrench, 0, loadedWrench, 0, wrench.length);
    System.arraycopy(tau, 0, loadedTau, 0, tau.length);
    if (lambda.length == 0) {
      return;
    }
    jacobian.decompose();
    jacobian.multipliers(lambda.length, residual, lambda);
    addMultipliers(lambda);
  }

  /**
   * Adds the forces of further multipliers to the balanced residual and the transmitted wrenches.
   *
   * @param further one number per equation of the loops; not modified
   */
  void addMultipliers(double[] further) {
    loops.addForces(further, -1, loadedWrench, loadedTau);
    sweepInward(loadedWrench, loadedTau);
  }

  /** Returns the number of independent equations at the last decomposition of J. */
  public int rank() {
    return jacobian.rank(lambda.length);
  }

  /**
   * Closes the loops by the least change of the positions.
   *
   * @param y state; its positions are overwritten
   * @return whether they are closed; if not, y is the last iterate
   */
  public boolean closePositions(double t, double[] y) {
    for (int i = 0; i < ITERATIONS; i++) {
      place(t, y);
      double before = loops.largestResidual();
      if (before <= CLOSED) {
        return true;
      }
      solveLeast(loops.value);
      coordinates.move(y, 0, step, 0, 1);
      place(t, y);
      // Rounding may keep the residual just above the bound; further corrections do not reduce it.
      if (loops.largestResidual() <= ROUNDED && !(loops.largestResidual() < 0.5 * before)) {
        return true;
      }
    }
    return loops.largestResidual() <= ROUNDED;
  }

  /** Writes the smallest x with J x = −rows to {@code step}. */
  public void solveLeast(double[] rows) {
    jacobian.decompose();
    solveLeastAsDecomposed(rows);
  }

  /** As {@link #solveLeast}, with J as decomposed last. */
  void solveLeastAsDecomposed(double[] rows) {
    jacobian.change(lambda.length, rows, step);
  }
}
