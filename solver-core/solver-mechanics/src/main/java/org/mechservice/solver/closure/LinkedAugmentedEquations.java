package org.mechservice.solver.closure;

import java.util.Arrays;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.closure.equations.RowSupport;
import org.mechservice.solver.dynamics.derivative.ArticulatedIteration;
import org.mechservice.solver.dynamics.derivative.LoopWrenches;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * Corrections by one sparse system in motions of links, wrenches in joints and multipliers, in
 * which a loop touches its two bodies alone: for long trees with many loops, or with forces or
 * loops between links far from each other. Workspace of one thread.
 */
public final class LinkedAugmentedEquations extends AugmentedEquations {
  private final LoopEquations loops;
  private final ArticulatedIteration iteration;
  private final LoopWrenches ofLinks;
  private final double[] wrench;
  private final double[] tau;
  private final double[] product;

  /**
   * Makes equations.
   *
   * @param rows J, to be written before each linearisation; rows of zeros are permitted
   * @param units of the unknowns
   * @param loops placed at the state of each linearisation
   * @param ofLinks of {@link #rowsOf}
   * @param iteration keeps A, for the same rows
   */
  public LinkedAugmentedEquations(
      SparseMatrix rows,
      double[] units,
      LoopEquations loops,
      TreeGeometry tree,
      LoopWrenches ofLinks,
      ArticulatedIteration iteration) {
    super(rows, units);
    this.loops = loops;
    this.iteration = iteration;
    this.ofLinks = ofLinks;
    wrench = new double[6 * tree.linkCount];
    tau = new double[tree.velocityCount];
    product = new double[n];
  }

  /** Returns rows of zeros of the equations of loops by the motions of links. */
  public static LoopWrenches rowsOf(LoopEquations loops, TreeGeometry tree) {
    int[][] links = new int[loops.count()][];
    int[][] velocities = new int[loops.count()][];
    for (int row = 0; row < links.length; row++) {
      RowSupport support = loops.support(row);
      links[row] = support.loaded();
      velocities[row] =
          Arrays.stream(support.velocities()).filter(k -> k < tree.stateVelocityCount).toArray();
    }
    return new LoopWrenches(links, velocities);
  }

  @Override
  public void linearise() {
    for (int row = 0; row < m; row++) {
      if (isZero(row)) {
        ofLinks.clear(row);
      } else {
        loops.addForces(row, 1 / loops.size(row), wrench, tau);
        ofLinks.take(row, wrench, tau);
      }
    }
    Arrays.fill(tau, n, tau.length, 0); // forces of drives are no equations
  }

  private boolean isZero(int row) {
    for (int e = rows.start[row]; e < rows.start[row + 1]; e++) {
      if (rows.value[e] != 0) {
        return false;
      }
    }
    return true;
  }

  /**
   * Factors the equations of the corrections, with A and J as last linearised.
   *
   * @param hGamma step of A, s
   * @param stiffness α of a row of unit length, as a multiple of the largest inertia of A
   * @return a negative number, or the unknown without a pivot
   */
  public int factor(double hGamma, double stiffness) {
    setPenalties(stiffness * iteration.largestInertia(hGamma, units));
    return iteration.factorWithRows(hGamma, penalties)
        ? LinearSolver.NONSINGULAR
        : iteration.singularVelocity();
  }

  @Override
  void correct(double[] force, double[] gap) {
    iteration.solveWithRows(force, gap);
  }

  @Override
  void subtractProduct(double[] x, int at, double[] force) {
    System.arraycopy(x, at, product, 0, n);
    iteration.addMatrixProduct(-1, product, force);
  }
}
