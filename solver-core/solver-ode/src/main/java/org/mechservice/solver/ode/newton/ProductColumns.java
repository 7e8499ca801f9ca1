package org.mechservice.solver.ode.newton;

import java.util.Arrays;
import org.mechservice.solver.linear.MatrixLayout;
import org.mechservice.solver.ode.SystemParts;

/** The columns of a matrix of which only products with vectors are known, by groups of columns. */
public final class ProductColumns {
  private final MatrixLayout layout;
  private final ColumnGroups groups;
  private final double[] direction;

  /** The product with {@link #direction}, length n; to be written before {@link #store}. */
  public final double[] product;

  /** A vector of zeros, length n. */
  public final double[] zero;

  /**
   * @param parts band and pattern of the matrix
   * @param layout where the matrix wants its elements
   */
  public ProductColumns(SystemParts parts, MatrixLayout layout) {
    int dimension = layout.dimension();
    this.layout = layout;
    groups = ColumnGroups.of(parts, layout);
    direction = new double[dimension];
    product = new double[dimension];
    zero = new double[dimension];
  }

  /** Returns how many products give all columns. */
  public int groupCount() {
    return groups.count();
  }

  /** Returns the sum of the unit vectors of a group; not to be modified. */
  public double[] direction(int group) {
    Arrays.fill(direction, 0);
    for (int j = groups.first(group); j >= 0; j = groups.next(j)) {
      direction[j] = 1;
    }
    return direction;
  }

  /** Writes the columns of a group, by the layout of the matrix. */
  public void store(int group, double[] matrix) {
    for (int j = groups.first(group); j >= 0; j = groups.next(j)) {
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
        if (groups.couples(i, j)) {
          matrix[layout.index(i, j)] = product[i];
        }
      }
    }
  }
}
