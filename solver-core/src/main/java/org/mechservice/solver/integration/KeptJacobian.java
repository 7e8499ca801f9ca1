package org.mechservice.solver.integration;

import java.util.Arrays;
import org.mechservice.solver.linear.MatrixLayout;

/**
 * A matrix of derivatives in use, and a second one where the next is formed: what turns out not to
 * be finite, or is stopped half way, does not replace the one in use.
 */
final class KeptJacobian {
  private final MatrixLayout layout;
  private double[] values;
  private double[] forming;
  private final double[] rowSums;

  KeptJacobian(MatrixLayout layout) {
    this.layout = layout;
    values = new double[layout.length()];
    forming = new double[layout.length()];
    rowSums = new double[layout.dimension()];
  }

  /** Returns the matrix in use, elements by layout; not to be modified. */
  double[] values() {
    return values;
  }

  /** Returns where to form the next, elements by layout. */
  double[] forming() {
    return forming;
  }

  /** Returns where to form the next after setting it to zero. */
  double[] formingFromZero() {
    Arrays.fill(forming, 0);
    return forming;
  }

  /** Returns the first row with an element that is not finite in the matrix formed; −1 if none. */
  int rowNotFinite() {
    for (int j = 0; j < layout.dimension(); j++) {
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i++) {
        if (!Double.isFinite(forming[layout.index(i, j)])) {
          return i;
        }
      }
    }
    return -1;
  }

  /** Takes the matrix that was formed into use. */
  void replace() {
    double[] freed = values;
    values = forming;
    forming = freed;
  }

  /** Adds the product of the matrix in use and x to a vector. */
  void addProduct(double[] x, double[] sum) {
    for (int j = 0; j < x.length; j++) {
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i++) {
        sum[i] += values[layout.index(i, j)] * x[j];
      }
    }
  }

  /** Adds the absolute values of the terms of that product. */
  void addMagnitudes(double[] x, double[] sum) {
    for (int j = 0; j < x.length; j++) {
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i++) {
        sum[i] += Math.abs(values[layout.index(i, j)] * x[j]);
      }
    }
  }

  /**
   * Returns the norm of the matrix in use that belongs to the maximum norm of weighted vectors: the
   * largest row sum of w_i |J_ij| / w_j.
   */
  double norm(ErrorNorm weights) {
    Arrays.fill(rowSums, 0);
    for (int j = 0; j < rowSums.length; j++) {
      double unit = weights.weight(j) == 0 ? 0 : 1 / weights.weight(j);
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i++) {
        rowSums[i] += Math.abs(values[layout.index(i, j)]) * unit;
      }
    }
    return weights.of(rowSums);
  }

  /** Returns whether a column of the matrix in use is zero. */
  boolean isZero(int column) {
    for (int i = layout.firstRow(column); i <= layout.lastRow(column); i++) {
      if (values[layout.index(i, column)] != 0) {
        return false;
      }
    }
    return true;
  }

  /** Carries the matrix in use over. */
  void transfer(StateTransfer state) {
    state.numbers(values);
  }
}
