package org.mechservice.solver.analysis.equation;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.mechservice.solver.closure.LinkedAugmentedEquations;
import org.mechservice.solver.dynamics.derivative.LinksAtRest;
import org.mechservice.solver.dynamics.derivative.LoopWrenches;
import org.mechservice.solver.dynamics.recursion.MassiveRods;
import org.mechservice.solver.force.ForceSet;
import org.mechservice.solver.linear.SparseElimination;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * Small motions of a large mechanism about a state at rest, whose matrices are kept by links and
 * not formed: the sparse counterpart of {@link Linearisation}, in displacements ξ of all joints
 * with J ξ = 0. Workspace of one thread.
 */
public final class RestingLinks {
  private final EquationsOfMotion equations;
  private final LoopWrenches rows;
  private final LinksAtRest links;
  private double[] state = {};
  private final double[] rest;
  private final double[] wrench;
  private final double[] tau;

  /**
   * @param equations of a mechanism that {@linkplain #fits fits}
   */
  public RestingLinks(EquationsOfMotion equations) {
    this.equations = equations;
    rows = LinkedAugmentedEquations.rowsOf(equations.loops, equations.tree);
    links = new LinksAtRest(equations.motion, couplings(), rows);
    rest = new double[equations.nv];
    wrench = new double[equations.wrench.length];
    tau = new double[equations.tau.length];
  }

  /** Returns whether a mechanism has no rods with mass, whose stiffness is not kept by links. */
  public static boolean fits(EquationsOfMotion equations) {
    return new MassiveRods(equations.tree).isEmpty();
  }

  private int[] couplings() {
    IntStream.Builder pairs = IntStream.builder();
    equations.forces.couplings((on, by) -> pairs.add(on).add(by));
    equations.loops.couplings((on, by) -> pairs.add(on).add(by));
    return pairs.build().toArray();
  }

  /**
   * Places the equations at a state at rest and finds the multipliers there; the residual is that
   * with their forces.
   *
   * @param t time, s
   * @param y state that closes the loops, with velocities of zero; not modified
   * @throws Linearisation.NotLinearised if a force has no derivative there
   */
  public void evaluate(double t, double[] y) throws Linearisation.NotLinearised {
    state = y.clone();
    equations.place(t, y);
    require(equations.applyForces(t));
    equations.formResidual(rest, 0);
    equations.balance();
    links.evaluate(equations.loadedWrench);
    require(equations.forces.linearise(t, links.forces()) == ForceSet.REGULAR);
    equations.loops.linearise(equations.lambda, -1, links.forces());
    takeRows();
    links.weigh(equations.residual, equations.unit);
  }

  private void require(boolean fine) throws Linearisation.NotLinearised {
    if (!fine) {
      throw new Linearisation.NotLinearised(equations.defect());
    }
  }

  /** Takes the rows of J that are independent, with zeros in place of the others. */
  private void takeRows() {
    if (rows.count() == 0) {
      return;
    }
    int rank = equations.rank();
    SparseMatrix scaled = equations.jacobian.scaled();
    SparseElimination elimination = new SparseElimination(scaled.rows(), equations.nv);
    int found = elimination.eliminate(scaled, rank, 0);
    for (int row = 0; row < rows.count(); row++) {
      rows.clear(row);
    }
    for (int i = 0; i < found; i++) {
      int row = elimination.row(i);
      equations.loops.addForces(row, 1 / equations.loops.size(row), wrench, tau);
      rows.take(row, wrench, tau);
    }
    Arrays.fill(tau, 0); // forces of drives are no equations
  }

  /** Returns the state that was evaluated last. */
  public double[] state() {
    return state.clone();
  }

  /** Returns the number of velocities. */
  public int size() {
    return equations.nv;
  }

  /** Returns whether the stiffness is symmetric at an equilibrium. */
  public boolean isStiffnessSymmetric() {
    return links.isStiffnessSymmetric();
  }

  /** Returns whether there is any damping. */
  public boolean isDamped() {
    return links.isDamped();
  }

  /** Returns whether the damping is symmetric. */
  public boolean isDampingSymmetric() {
    return links.isDampingSymmetric();
  }

  /**
   * Factors m M + c C + k K + s D along the loops, with the weights D of {@link LinksAtRest}, if it
   * is positive definite there.
   *
   * @return whether it is
   */
  public boolean factor(double mass, double damping, double stiffness, double shift) {
    return links.factor(mass, damping, stiffness, shift);
  }

  /**
   * Factors m M + c C + k K.
   *
   * @return the number of its negative eigenvalues along the loops, or -1 if it is not known
   *     because very many are zero
   */
  public int negative(double mass, double damping, double stiffness) {
    return links.negative(mass, damping, stiffness);
  }

  /**
   * Solves A ξ + Jᵀ λ = b, J ξ = 0 with the last factors.
   *
   * @param b one number for each velocity; overwritten with ξ
   */
  public void solve(double[] b) {
    links.solve(b);
  }

  /**
   * Writes (m M + c C + k K) ξ.
   *
   * @param xi one number for each velocity; not modified
   * @param out the same; overwritten
   */
  public void multiply(double mass, double damping, double stiffness, double[] xi, double[] out) {
    links.multiply(mass, damping, stiffness, xi, out);
  }
}
