package org.mechservice.solver.dynamics;

import java.util.Arrays;
import java.util.Random;
import org.mechservice.solver.dynamics.derivative.ResidualJacobian;
import org.mechservice.solver.dynamics.derivative.TreeIteration;
import org.mechservice.solver.dynamics.recursion.MassiveRods;
import org.mechservice.solver.dynamics.recursion.TreeSteps;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;

/** A mechanism in a state, with joint forces and wrenches, and the questions laws ask of it. */
public final class Evaluation {
  final Mechanism mechanism;
  public final TreeGeometry tree;
  public final TreeMotion motion;
  public final StateCoordinates coordinates;
  public final int nq;
  public final int nv;
  public final double[] y;
  final double[] tau;
  public final double[] wrench;

  public Evaluation(Mechanism mechanism) {
    this.mechanism = mechanism;
    tree = new TreeGeometry(mechanism);
    motion = new TreeMotion(tree);
    coordinates = new StateCoordinates(mechanism);
    nq = mechanism.positionCount();
    nv = mechanism.velocityCount();
    y = new double[nq + nv];
    mechanism.initialState(y);
    tau = new double[tree.velocityCount];
    wrench = new double[6 * tree.linkCount];
    motion.sweep(0, y);
  }

  /** Adds joint forces and wrenches on all bodies of size 1 to 5. */
  public Evaluation loaded(long seed) {
    Random random = new Random(seed);
    for (int i = 0; i < tau.length; i++) {
      tau[i] = 10 * random.nextDouble() - 5;
    }
    for (int link : tree.linkOfBody) {
      for (int i = 0; i < 6; i++) {
        wrench[6 * link + i] = 2 * random.nextDouble() - 1;
      }
    }
    return this;
  }

  double[] velocities() {
    double[] v = new double[nv];
    System.arraycopy(y, nq, v, 0, nv);
    return v;
  }

  public SemiRecursive semiRecursive() {
    SemiRecursive w = new SemiRecursive(motion);
    w.formMassMatrix();
    w.formBias(wrench, tau);
    return w;
  }

  double[] byArticulatedBodies() {
    double[] a = new double[nv];
    require(new TreeSteps(motion).accelerations(wrench, tau, a, 0));
    return a;
  }

  double[] bySemiRecursion() {
    double[] a = new double[nv];
    require(new SemiRecursive(motion).accelerations(wrench, tau, a, 0));
    return a;
  }

  /** Solves for a zero of the residual of RR, with its mass matrix by recursion. */
  double[] byResidual() {
    int[] noPairs = {};
    TreePattern pattern = new TreePattern(tree, noPairs);
    ResidualJacobian jacobian = new ResidualJacobian(motion, pattern);
    motion.accelerationSweep(new double[nv]);
    jacobian.evaluate(wrench);
    jacobian.finish();
    TreeIteration iteration = new TreeIteration(tree, pattern, jacobian);
    iteration.setState(y);
    if (!iteration.factor(0)) {
      throw new IllegalStateException("singular in unknown " + iteration.singularUnknown());
    }
    double[] a = new double[nv];
    double[] change = new double[nq + nv];
    for (int i = 0; i < 2; i++) {
      System.arraycopy(residual(a), 0, change, nq, nv);
      Arrays.fill(change, 0, nq, 0);
      iteration.solve(change);
      for (int k = 0; k < nv; k++) {
        a[k] -= change[nq + k];
      }
    }
    return a;
  }

  private static void require(int singular) {
    if (singular >= 0) {
      throw new IllegalStateException("singular at velocity " + singular);
    }
  }

  /** Returns M a + b − τ of the state's velocities by one Newton-Euler sweep. */
  public double[] residual(double[] a) {
    return Arrays.copyOf(extendedResidual(a), nv);
  }

  double[] extendedResidual(double[] a) {
    double[] residual = new double[tree.velocityCount];
    new SemiRecursive(motion).formResidual(wrench, tau, a, 0, residual);
    return residual;
  }

  double kineticEnergy() {
    return new WorldMotion(motion).kineticEnergy() + new MassiveRods(tree).kineticEnergy(motion);
  }

  double potentialEnergy() {
    return new WorldMotion(motion).potentialEnergy()
        + new MassiveRods(tree).potentialEnergy(motion);
  }

  /** Returns the state after a small step along q' = N v and v' = a. */
  double[] along(double[] a, double h) {
    double[] moved = y.clone();
    coordinates.move(moved, 0, y, nq, h);
    for (int i = 0; i < nv; i++) {
      moved[nq + i] += h * a[i];
    }
    return moved;
  }

  public static double norm(double[] x) {
    double sum = 0;
    for (double xi : x) {
      sum += xi * xi;
    }
    return Math.sqrt(sum);
  }

  static double largest(double[] values) {
    double largest = 0;
    for (double value : values) {
      largest = Math.max(largest, Math.abs(value));
    }
    return largest;
  }
}
