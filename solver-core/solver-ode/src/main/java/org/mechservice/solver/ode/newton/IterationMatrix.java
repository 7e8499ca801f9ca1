package org.mechservice.solver.ode.newton;

import java.util.Optional;
import org.mechservice.solver.linear.BandLayout;
import org.mechservice.solver.linear.BandLu;
import org.mechservice.solver.linear.BlockLayout;
import org.mechservice.solver.linear.BlockLu;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.linear.MatrixLayout;
import org.mechservice.solver.linear.SparseLayout;
import org.mechservice.solver.linear.SparsePivotedLu;
import org.mechservice.solver.ode.BandedSystem;
import org.mechservice.solver.ode.BlockSystem;
import org.mechservice.solver.ode.JacobianSystem;
import org.mechservice.solver.ode.ResidualJacobianSystem;
import org.mechservice.solver.ode.SparseSystem;
import org.mechservice.solver.ode.SystemParts;
import org.mechservice.solver.ode.step.Manifold;

/**
 * The matrix of the Newton iteration and its factors: I − hγ J for y' = f, with hγ = h / ((1 − κ_k)
 * γ_k), and hγ ∂F/∂y + ∂F/∂y' for F(t, y, y') = 0. Rows and columns of passive components are those
 * of the unit matrix.
 *
 * <p>In residual form the columns of algebraic components are divided by hγ, which stands for
 * unknowns multiplied by it: however short the step, the matrix stays regular, and for hγ = 0 it is
 * that of the consistent initial values, [∂F/∂y'_d, ∂F/∂y_a].
 */
final class IterationMatrix {
  /** Unknowns, and part of the elements that may differ from zero, for which sparse factors pay. */
  private static final int SPARSE_FROM = 100;

  private static final double MOST_SPARSE = 0.25;

  private final LinearSolver solver;
  private final MatrixLayout layout;
  private final Manifold manifold;

  /** Elements by the solver's layout. */
  private final double[] matrix;

  private int singularColumn;

  IterationMatrix(LinearSolver solver, Manifold manifold) {
    this.solver = solver;
    this.layout = solver.layout();
    this.manifold = manifold;
    matrix = new double[layout.length()];
  }

  /**
   * Returns a solver for what a problem declares its matrix to be.
   *
   * @param system the problem, asked for its band, else for its blocks, else for its pattern
   * @param dimension n
   * @throws IllegalArgumentException if the band is wider than the matrix
   */
  static LinearSolver solverFor(SystemParts system, int dimension) {
    Optional<BandedSystem> band = system.part(BandedSystem.class);
    if (band.isPresent()) {
      return new BandLu(
          new BandLayout(dimension, band.get().lowerBandwidth(), band.get().upperBandwidth()));
    }
    Optional<BlockLayout> blocks = blocks(system, dimension);
    if (blocks.isPresent()) {
      return new BlockLu(blocks.get(), DenseLu::new);
    }
    return sparse(system, dimension)
        .<LinearSolver>map(SparsePivotedLu::new)
        .orElseGet(() -> new DenseLu(dimension));
  }

  /** Returns the blocks of a problem, if it says so and there are several. */
  static Optional<BlockLayout> blocks(SystemParts system, int dimension) {
    return system
        .part(BlockSystem.class)
        .map(blocks -> new BlockLayout(dimension, blocks.blockSize()))
        .filter(layout -> layout.blocks() > 1);
  }

  /** Returns the pattern of a problem if it is worth while and not formed by the problem itself. */
  static Optional<SparseLayout> sparse(SystemParts system, int dimension) {
    boolean formed =
        system.part(JacobianSystem.class).isPresent()
            || system.part(ResidualJacobianSystem.class).isPresent();
    return formed || dimension < SPARSE_FROM
        ? Optional.empty()
        : system
            .part(SparseSystem.class)
            .map(pattern -> SparseLayout.of(ColumnGroups.rows(pattern, dimension)))
            .filter(layout -> layout.length() <= MOST_SPARSE * dimension * dimension);
  }

  /** Returns how matrices are stored. */
  MatrixLayout layout() {
    return layout;
  }

  /** Factors I − hγ J; returns whether it is regular. */
  boolean factorExplicit(double hGamma, double[] jacobian) {
    for (int i = 0; i < matrix.length; i++) {
      matrix[i] = -hGamma * jacobian[i];
    }
    for (int i = 0; i < layout.dimension(); i++) {
      matrix[layout.index(i, i)] += 1;
    }
    return factor();
  }

  /**
   * Factors hγ ∂F/∂y + ∂F/∂y' with the columns of algebraic components over hγ; returns whether it
   * is regular.
   *
   * @param algebraic which columns those are
   */
  boolean factorResidual(double hGamma, double[] fy, double[] fyDot, boolean[] algebraic) {
    for (int j = 0; j < layout.dimension(); j++) {
      double ofState = algebraic[j] ? 1 : hGamma;
      double ofDerivative = algebraic[j] ? (hGamma == 0 ? 0 : 1 / hGamma) : 1;
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
        int ij = layout.index(i, j);
        matrix[ij] = ofState * fy[ij] + ofDerivative * fyDot[ij];
      }
    }
    return factor();
  }

  private boolean factor() {
    if (manifold.completes()) {
      uncouplePassive();
    }
    singularColumn = solver.factor(matrix);
    return singularColumn == LinearSolver.NONSINGULAR;
  }

  private void uncouplePassive() {
    for (int j = 0; j < layout.dimension(); j++) {
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
        if (!manifold.independent(i) || !manifold.independent(j)) {
          matrix[layout.index(i, j)] = i == j ? 1 : 0;
        }
      }
    }
  }

  /** Solves in place. */
  void solve(double[] b) {
    solver.solve(b);
  }

  /** Returns the column, and so the component, that left no pivot. */
  int singularColumn() {
    return singularColumn;
  }

  /** Returns an estimate of the reciprocal condition. */
  double reciprocalCondition() {
    return solver.reciprocalCondition();
  }
}
