package org.mechservice.solver.ode.solve;

import java.util.Optional;
import org.mechservice.solver.linear.BandLayout;
import org.mechservice.solver.linear.BandLu;
import org.mechservice.solver.linear.DenseLayout;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.EquilibratedSolver;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.linear.MatrixLayout;

/**
 * The constant matrix M of M y' = f(t, y): full, banded or diagonal, regular or singular.
 * Immutable. A mass matrix that changes with t or y belongs into a {@link DaeProblem}, F = M(t, y)
 * y' − f(t, y).
 */
public final class MassMatrix {
  private final MatrixLayout layout;
  private final double[] elements;

  private MassMatrix(MatrixLayout layout, double[] elements) {
    this.layout = layout;
    this.elements = elements;
    for (int j = 0; j < layout.dimension(); j++) {
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
        requireFinite(i, j, elements[layout.index(i, j)]);
      }
    }
  }

  private static void requireFinite(int i, int j, double element) {
    if (!Double.isFinite(element)) {
      throw new IllegalArgumentException(
          "element ("
              + i
              + ", "
              + j
              + ") of the mass matrix is "
              + element
              + "; it must be finite");
    }
  }

  /**
   * Returns a matrix given by its rows.
   *
   * @param rows M_ij at [i][j]; not modified
   * @throws IllegalArgumentException if they are not square or an element is not finite
   */
  public static MassMatrix full(double[][] rows) {
    int n = rows.length;
    DenseLayout layout = new DenseLayout(n);
    double[] elements = new double[layout.length()];
    for (int i = 0; i < n; i++) {
      if (rows[i].length != n) {
        throw new IllegalArgumentException(
            "row "
                + i
                + " of the mass matrix has "
                + rows[i].length
                + " elements; it must have "
                + n
                + ", as many as there are rows");
      }
      System.arraycopy(rows[i], 0, elements, i * n, n);
    }
    return new MassMatrix(layout, elements);
  }

  /**
   * Returns a diagonal matrix; a zero makes its component algebraic.
   *
   * @throws IllegalArgumentException if an element is not finite
   */
  public static MassMatrix diagonal(double... elements) {
    return new MassMatrix(new BandLayout(elements.length, 0, 0), elements.clone());
  }

  /**
   * Returns a banded matrix.
   *
   * @param lower l, diagonals below the main one, from 0 to n − 1
   * @param upper u, diagonals above the main one, from 0 to n − 1
   * @param elements M_ij at i (l + u + 1) + j − i + l, length n (l + u + 1); places outside of the
   *     matrix are not read
   * @throws IllegalArgumentException if the length does not fit or an element is not finite
   */
  public static MassMatrix banded(int dimension, int lower, int upper, double... elements) {
    BandLayout layout = new BandLayout(dimension, lower, upper);
    if (elements.length != layout.length()) {
      throw new IllegalArgumentException(
          "the band of the mass matrix has "
              + elements.length
              + " elements; it must have "
              + layout.length()
              + ", n (l + u + 1) with n = "
              + dimension
              + ", l = "
              + lower
              + ", u = "
              + upper);
    }
    return new MassMatrix(layout, elements.clone());
  }

  /** Returns n. */
  public int dimension() {
    return layout.dimension();
  }

  MatrixLayout layout() {
    return layout;
  }

  /** Returns M_ij. */
  double element(int i, int j) {
    boolean inside = layout.firstRow(j) <= i && i <= layout.lastRow(j);
    return inside ? elements[layout.index(i, j)] : 0;
  }

  boolean isDiagonal() {
    return layout instanceof BandLayout band && band.lower() == 0 && band.upper() == 0;
  }

  /** Returns whether no equation contains the derivative of a component. */
  boolean columnIsZero(int j) {
    for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
      if (elements[layout.index(i, j)] != 0) {
        return false;
      }
    }
    return true;
  }

  /** Adds M x to a vector. */
  void addProduct(double[] x, double[] sum) {
    layout.addProduct(elements, x, sum);
  }

  /** Returns a solver with M factored; empty if M is singular to working precision. */
  Optional<LinearSolver> factored() {
    LinearSolver solver =
        new EquilibratedSolver(
            layout instanceof BandLayout band ? new BandLu(band) : new DenseLu(dimension()));
    boolean regular =
        solver.factor(elements) == LinearSolver.NONSINGULAR
            && (dimension() == 0 || solver.reciprocalCondition() > Math.ulp(1.0));
    return regular ? Optional.of(solver) : Optional.empty();
  }
}
