package org.mechservice.solver.linear;

import java.util.Arrays;
import java.util.List;

/**
 * A sparse symmetric positive definite matrix that is summed up from small dense parts and factored
 * in place, L D Lᵀ, without interchanges (Davis 2006, ch. 4). The order of elimination and the
 * elements that are new in L are found once, by least degree.
 *
 * <p>Elements are addressed by their <i>place</i> in the order of elimination. A workspace for one
 * thread; nothing allocates after construction.
 */
public final class SparseSymmetric {
  /** Result of {@link #factor} if the matrix is positive definite. */
  public static final int POSITIVE_DEFINITE = -1;

  /** A pivot below this part of its diagonal element is rounding. */
  private static final double SINGULAR = 64 * Math.ulp(1.0);

  private final int size;
  private final int[] memberAt;
  private final int[] placeOf;

  /** For each place, the later places it is coupled with, ascending. */
  private final int[] start;

  private final int[] later;

  /** Elements as they are summed up; those of places that are eliminated are of D and L. */
  private final double[] diagonal;

  private final double[] element;

  /** Diagonal elements before anything was eliminated. */
  private final double[] whole;

  private final double[] work;

  /**
   * Makes a matrix of zeros.
   *
   * @param size number of rows
   * @param cliques rows that are coupled, each with each of its clique; not modified
   * @param first rows that are eliminated first, in this order; the others follow by least degree
   */
  public SparseSymmetric(int size, List<int[]> cliques, int[] first) {
    this.size = size;
    LeastDegree order = new LeastDegree(size, cliques, first);
    memberAt = order.memberAt();
    placeOf = new int[size];
    for (int k = 0; k < size; k++) {
      placeOf[memberAt[k]] = k;
    }
    start = new int[size + 1];
    int[][] lists = new int[size][];
    for (int k = 0; k < size; k++) {
      lists[k] = Arrays.stream(order.coupledAfter(k)).map(i -> placeOf[i]).sorted().toArray();
      start[k + 1] = start[k] + lists[k].length;
    }
    later = Arrays.stream(lists).flatMapToInt(Arrays::stream).toArray();
    diagonal = new double[size];
    whole = new double[size];
    element = new double[later.length];
    work = new double[size];
  }

  /** Returns the number of rows. */
  public int size() {
    return size;
  }

  /** Returns the place of a row in the order of elimination. */
  public int placeOf(int row) {
    return placeOf[row];
  }

  /** Returns the row that is eliminated at a place. */
  public int rowAt(int place) {
    return memberAt[place];
  }

  /** Sets all elements to zero. */
  public void clear() {
    Arrays.fill(diagonal, 0);
    Arrays.fill(whole, 0);
    Arrays.fill(element, 0);
  }

  /** Adds to a diagonal element. */
  public void addDiagonal(int place, double value) {
    diagonal[place] += value;
    whole[place] += value;
  }

  /** Returns the largest sum of the sizes of a row's elements, before anything is eliminated. */
  public double norm() {
    Arrays.fill(work, 0);
    double norm = 0;
    for (int k = 0; k < size; k++) {
      work[k] += Math.abs(diagonal[k]);
      for (int e = start[k]; e < start[k + 1]; e++) {
        work[k] += Math.abs(element[e]);
        work[later[e]] += Math.abs(element[e]);
      }
    }
    for (double sum : work) {
      norm = Math.max(norm, sum);
    }
    return norm;
  }

  /**
   * Adds factor · x xᵀ.
   *
   * @param places of the numbers of x, ascending, of one clique; from {@code placesAt}
   * @param x its numbers that are not zero, from {@code at}; not modified
   * @param count how many
   */
  public void addSquare(int[] places, int placesAt, double[] x, int at, int count, double factor) {
    for (int i = 0; i < count; i++) {
      double scaled = factor * x[at + i];
      int k = places[placesAt + i];
      diagonal[k] += scaled * x[at + i];
      whole[k] += scaled * x[at + i];
      int e = start[k];
      for (int j = i + 1; j < count; j++) {
        while (later[e] != places[placesAt + j]) {
          e++;
        }
        element[e] += scaled * x[at + j];
      }
    }
  }

  /** Returns where the couplings of a place with later ones begin. */
  public int start(int place) {
    return start[place];
  }

  /** Returns a later place that a place is coupled with. */
  public int later(int index) {
    return later[index];
  }

  /** Returns the element of L below the pivot of its place, after it has been eliminated. */
  public double lower(int index) {
    return element[index];
  }

  /** Returns the pivot at a place, after it has been eliminated. */
  public double pivot(int place) {
    return diagonal[place];
  }

  /**
   * Eliminates a place; those before have been.
   *
   * @return whether its pivot is more than rounding
   */
  public boolean eliminate(int k) {
    double pivot = diagonal[k];
    if (!(pivot > SINGULAR * whole[k]) || pivot == Double.POSITIVE_INFINITY) {
      return false;
    }
    double perPivot = 1 / pivot;
    int end = start[k + 1];
    for (int e = start[k]; e < end; e++) {
      int i = later[e];
      double factor = element[e] * perPivot;
      if (factor != 0) {
        diagonal[i] -= factor * element[e];
        int target = start[i];
        for (int other = e + 1; other < end; other++) {
          while (later[target] != later[other]) {
            target++;
          }
          element[target] -= factor * element[other];
        }
      }
    }
    for (int e = start[k]; e < end; e++) {
      element[e] *= perPivot;
    }
    return true;
  }

  /** Eliminates all places; returns {@link #POSITIVE_DEFINITE} or the row without a pivot. */
  public int factor() {
    for (int k = 0; k < size; k++) {
      if (!eliminate(k)) {
        return memberAt[k];
      }
    }
    return POSITIVE_DEFINITE;
  }

  /** Solves with all places eliminated; {@code b} in the order of the rows, overwritten. */
  public void solve(double[] b) {
    for (int k = 0; k < size; k++) {
      work[k] = b[memberAt[k]];
    }
    for (int k = 0; k < size; k++) {
      for (int e = start[k]; e < start[k + 1]; e++) {
        work[later[e]] -= element[e] * work[k];
      }
    }
    for (int k = size - 1; k >= 0; k--) {
      double sum = work[k] / diagonal[k];
      for (int e = start[k]; e < start[k + 1]; e++) {
        sum -= element[e] * work[later[e]];
      }
      work[k] = sum;
      b[memberAt[k]] = sum;
    }
  }
}
