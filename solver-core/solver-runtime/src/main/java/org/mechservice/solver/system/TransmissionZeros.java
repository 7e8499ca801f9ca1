package org.mechservice.solver.system;

import java.util.Arrays;
import org.mechservice.solver.linear.spectrum.Eigenvalues;

/**
 * The transmission zeros of a linear system: the s at which the matrix [A − s, B; C, D] loses rank.
 * Motions e^(st) then exist in which inputs and states move and the outputs stand still.
 *
 * <p>Orthogonal transformations reduce the system, without changing its finite zeros, until D is
 * regular; they are then the eigenvalues of A − B D⁻¹ C (Emami-Naeini and Van Dooren, Automatica 18
 * (1982) 415). States, inputs and outputs are scaled by powers of two first.
 */
public final class TransmissionZeros {
  /**
   * Size of an element, relative to the largest of the scaled matrices, that is zero: C comes from
   * differences with errors of 1e-11.
   */
  private static final double NEGLIGIBLE = 1e-9;

  private static final int SCALINGS = 20;

  /** The compound matrix [A B; C D], n + p rows of n + m. */
  private double[][] all;

  private int n;
  private int m;
  private int p;
  private final double negligible;
  private final double[] real;
  private final double[] imaginary;

  /**
   * Finds the zeros.
   *
   * @throws ArithmeticException if the eigenvalues of the reduced system do not converge
   */
  public TransmissionZeros(LinearSystem system) {
    n = system.states().size();
    m = system.inputs().size();
    p = system.outputs().size();
    all = new double[n + p][n + m];
    for (int i = 0; i < n + p; i++) {
      for (int j = 0; j < n + m; j++) {
        all[i][j] =
            i < n
                ? j < n ? system.a(i, j) : system.b(i, j - n)
                : j < n ? system.c(i - n, j) : system.d(i - n, j - n);
      }
    }
    scale();
    negligible = NEGLIGIBLE * largest();
    reduce();
    transpose();
    reduce();
    double[] matrix = zeroDynamics();
    Eigenvalues found = new Eigenvalues(n, matrix);
    if (!found.converged()) {
      throw new ArithmeticException("the eigenvalues of the zeros were not found");
    }
    Integer[] order = new Integer[n];
    Arrays.setAll(order, i -> i);
    Arrays.sort(
        order,
        (i, j) -> {
          int bySize =
              Double.compare(
                  StrictMath.hypot(found.real(i), found.imaginary(i)),
                  StrictMath.hypot(found.real(j), found.imaginary(j)));
          return bySize != 0 ? bySize : Double.compare(found.imaginary(i), found.imaginary(j));
        });
    real = new double[n];
    imaginary = new double[n];
    for (int i = 0; i < n; i++) {
      real[i] = found.real(order[i]);
      imaginary[i] = found.imaginary(order[i]);
    }
  }

  /** Returns the number of finite zeros. */
  public int count() {
    return real.length;
  }

  /** Returns the real part of a zero, 1/s; the smallest zero comes first. */
  public double real(int zero) {
    return real[zero];
  }

  /** Returns the imaginary part of a zero, rad/s. */
  public double imaginary(int zero) {
    return imaginary[zero];
  }

  /** Scales states, inputs and outputs so that rows and columns have similar sizes. */
  private void scale() {
    for (int pass = 0; pass < SCALINGS; pass++) {
      for (int k = 0; k < n; k++) {
        double row = 0;
        double column = 0;
        for (int j = 0; j < n + m; j++) {
          row += j == k ? 0 : Math.abs(all[k][j]);
        }
        for (int i = 0; i < n + p; i++) {
          column += i == k ? 0 : Math.abs(all[i][k]);
        }
        if (row > 0 && column > 0) {
          double factor = power(Math.sqrt(column / row));
          multiplyRow(k, factor);
          multiplyColumn(k, 1 / factor);
        }
      }
      for (int i = n; i < n + p; i++) {
        double largest = Arrays.stream(all[i]).map(Math::abs).max().orElse(0);
        multiplyRow(i, largest > 0 ? power(1 / largest) : 1);
      }
      for (int j = n; j < n + m; j++) {
        double largest = 0;
        for (double[] row : all) {
          largest = Math.max(largest, Math.abs(row[j]));
        }
        multiplyColumn(j, largest > 0 ? power(1 / largest) : 1);
      }
    }
  }

  private static double power(double factor) {
    return Math.scalb(1.0, Math.getExponent(factor * Math.sqrt(2)));
  }

  private void multiplyRow(int i, double factor) {
    for (int j = 0; j < all[i].length; j++) {
      all[i][j] *= factor;
    }
  }

  private void multiplyColumn(int j, double factor) {
    for (double[] row : all) {
      row[j] *= factor;
    }
  }

  private double largest() {
    double largest = 0;
    for (double[] row : all) {
      for (double element : row) {
        largest = Math.max(largest, Math.abs(element));
      }
    }
    return largest;
  }

  /** Reduces the system until D has full row rank. */
  private void reduce() {
    while (p > 0) {
      int rank = compressRows();
      int rest = p - rank;
      if (rest == 0) {
        return;
      }
      int lost = compressColumns(rank);
      // [C; D] has rank rows; the last states are zero, and their equations become outputs
      double[][] next = new double[n - lost + rank + lost][];
      for (int i = 0; i < n - lost; i++) {
        next[i] = without(all[i], n - lost, n);
      }
      for (int i = 0; i < rank; i++) {
        next[n - lost + i] = without(all[n + i], n - lost, n);
      }
      for (int i = 0; i < lost; i++) {
        next[n - lost + rank + i] = without(all[n - lost + i], n - lost, n);
      }
      all = next;
      n -= lost;
      p = rank + lost;
      if (lost == 0) {
        return;
      }
    }
  }

  private static double[] without(double[] row, int from, int to) {
    double[] kept = new double[row.length - (to - from)];
    System.arraycopy(row, 0, kept, 0, from);
    System.arraycopy(row, to, kept, from, row.length - to);
    return kept;
  }

  /** Turns the outputs so that the rows of D beyond its rank are zero; returns the rank. */
  private int compressRows() {
    int rank = 0;
    boolean[] used = new boolean[m];
    while (rank < Math.min(p, m)) {
      int pivot = -1;
      double best = negligible;
      for (int j = 0; j < m; j++) {
        double norm = used[j] ? 0 : columnNorm(n + j, n + rank, n + p);
        if (norm > best) {
          best = norm;
          pivot = j;
        }
      }
      if (pivot < 0) {
        break;
      }
      used[pivot] = true;
      double[] mirror = new double[p - rank];
      for (int i = 0; i < mirror.length; i++) {
        mirror[i] = all[n + rank + i][n + pivot];
      }
      reflectRows(mirror, n + rank);
      rank++;
    }
    for (int i = rank; i < p; i++) {
      Arrays.fill(all[n + i], n, n + m, 0);
    }
    return rank;
  }

  /**
   * Turns the states so that the rows of C beyond {@code rank} depend on the last states alone;
   * returns their number.
   */
  private int compressColumns(int rank) {
    int lost = 0;
    boolean[] used = new boolean[p];
    while (lost < Math.min(n, p - rank)) {
      int pivot = -1;
      double best = negligible;
      for (int i = rank; i < p; i++) {
        double norm = used[i] ? 0 : rowNorm(n + i, 0, n - lost);
        if (norm > best) {
          best = norm;
          pivot = i;
        }
      }
      if (pivot < 0) {
        break;
      }
      used[pivot] = true;
      // the mirror moves the row to its last column
      double[] mirror = new double[n - lost];
      for (int j = 0; j < mirror.length; j++) {
        mirror[j] = all[n + pivot][mirror.length - 1 - j];
      }
      double[] turned = householder(mirror);
      double[] normal = new double[turned.length];
      for (int j = 0; j < normal.length; j++) {
        normal[j] = turned[turned.length - 1 - j];
      }
      mirrorColumns(normal, 0);
      mirrorRows(normal, 0);
      lost++;
    }
    return lost;
  }

  private double columnNorm(int column, int from, int to) {
    double sum = 0;
    for (int i = from; i < to; i++) {
      sum = StrictMath.hypot(sum, all[i][column]);
    }
    return sum;
  }

  private double rowNorm(int row, int from, int to) {
    double sum = 0;
    for (int j = from; j < to; j++) {
      sum = StrictMath.hypot(sum, all[row][j]);
    }
    return sum;
  }

  /** Returns the unit normal of the mirror that takes x to its first axis; empty if x is zero. */
  private static double[] householder(double[] x) {
    double norm = 0;
    for (double element : x) {
      norm = StrictMath.hypot(norm, element);
    }
    double[] normal = x.clone();
    normal[0] += x[0] >= 0 ? norm : -norm;
    double length = 0;
    for (double element : normal) {
      length = StrictMath.hypot(length, element);
    }
    for (int i = 0; i < normal.length; i++) {
      normal[i] /= length;
    }
    return normal;
  }

  private void reflectRows(double[] x, int from) {
    mirrorRows(householder(x), from);
  }

  /** Applies 1 − 2 w wᵀ to rows. */
  private void mirrorRows(double[] w, int from) {
    for (int j = 0; j < n + m; j++) {
      double product = 0;
      for (int i = 0; i < w.length; i++) {
        product += w[i] * all[from + i][j];
      }
      for (int i = 0; i < w.length; i++) {
        all[from + i][j] -= 2 * w[i] * product;
      }
    }
  }

  /** Applies 1 − 2 w wᵀ to columns. */
  private void mirrorColumns(double[] w, int from) {
    for (double[] row : all) {
      double product = 0;
      for (int j = 0; j < w.length; j++) {
        product += w[j] * row[from + j];
      }
      for (int j = 0; j < w.length; j++) {
        row[from + j] -= 2 * w[j] * product;
      }
    }
  }

  /** Goes over to [Aᵀ Cᵀ; Bᵀ Dᵀ], which has the same zeros. */
  private void transpose() {
    double[][] other = new double[n + m][n + p];
    for (int i = 0; i < n + p; i++) {
      for (int j = 0; j < n + m; j++) {
        other[j][i] = all[i][j];
      }
    }
    all = other;
    int outputs = p;
    p = m;
    m = outputs;
  }

  /** Returns A − B D⁻¹ C, by elimination with D of full row rank, and thus square. */
  private double[] zeroDynamics() {
    int pivots = Math.min(p, m);
    for (int k = 0; k < pivots; k++) {
      int best = n + k;
      for (int i = n + k; i < n + p; i++) {
        best = Math.abs(all[i][n + k]) > Math.abs(all[best][n + k]) ? i : best;
      }
      double[] swapped = all[best];
      all[best] = all[n + k];
      all[n + k] = swapped;
      for (int i = 0; i < n + p; i++) {
        if (i < n || i > n + k) {
          double factor = all[i][n + k] / swapped[n + k];
          for (int j = 0; j < n + m; j++) {
            all[i][j] -= factor * swapped[j];
          }
        }
      }
    }
    double[] matrix = new double[n * n];
    for (int i = 0; i < n; i++) {
      System.arraycopy(all[i], 0, matrix, i * n, n);
    }
    return matrix;
  }
}
