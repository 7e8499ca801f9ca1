package org.mechservice.solver.linear;

import java.util.Arrays;

/**
 * LU factors of a sparse matrix, column after column in an order of {@linkplain MinimumDegree least
 * degree}: each column is solved with the factors left of it, of which only those are looked at
 * that it is coupled with. Gilbert and Peierls, SIAM J. Sci. Stat. Comput. 9 (1988) 862.
 *
 * <p>The element on the diagonal is the pivot unless another in its column is a hundred times as
 * large; then the largest one is. As long as matrices lead to the same pivots, the pattern of the
 * factors is kept; the factors are those that would be found without.
 *
 * <p>Memory: 12 bytes for each element of the factors, and some 100 for each row. Room for the
 * factors is allocated when they turn out to need more.
 */
public final class SparsePivotedLu extends LuFactors {
  /** The diagonal is the pivot if it is at least this part of the largest in its column. */
  private static final double OF_LARGEST = 0.01;

  private final SparseLayout layout;
  private final int n;

  /** Column of each step. */
  private final int[] column;

  /** Row of each step, and step of each row, negative if it has none. */
  private final int[] row;

  private final int[] step;

  /**
   * L below its diagonal by columns: while pivots are chosen with rows of the matrix, later with
   * steps.
   */
  private final int[] lowerStart;

  private int[] lowerStep;
  private double[] lower;

  /** U above its diagonal by columns: steps in an order in which they can be eliminated. */
  private final int[] upperStart;

  private int[] upperStep;
  private double[] upper;

  private final double[] pivot;

  /** A column under way: by rows while pivots are chosen, later by steps; zero between. */
  private final double[] work;

  /** Rows that a column reaches, from the end of the array on. */
  private final int[] reached;

  private final int[] path;
  private final int[] nextOnPath;

  /** Last step, plus 1, in which each row was reached. */
  private final int[] reachedIn;

  /** Matrix to be factored, by its layout. */
  private double[] matrix = {};

  /** Whether pattern and pivots of an earlier matrix are known. */
  private boolean chosen;

  /**
   * @param layout pattern of the matrices
   */
  public SparsePivotedLu(SparseLayout layout) {
    this(layout, MinimumDegree.order(layout));
  }

  /**
   * @param layout pattern of the matrices
   * @param order columns in the order in which they are to be eliminated; not modified
   */
  public SparsePivotedLu(SparseLayout layout, int[] order) {
    super(layout);
    this.layout = layout;
    n = layout.dimension();
    column = order.clone();
    row = new int[n];
    step = new int[n];
    lowerStart = new int[n + 1];
    upperStart = new int[n + 1];
    int room = 2 * layout.length();
    lowerStep = new int[room];
    lower = new double[room];
    upperStep = new int[room];
    upper = new double[room];
    pivot = new double[n];
    work = new double[n];
    reached = new int[n];
    path = new int[n];
    nextOnPath = new int[n];
    reachedIn = new int[n];
  }

  @Override
  double load(double[] matrix) {
    this.matrix = matrix;
    double norm = 0;
    for (int j = 0; j < n; j++) {
      for (int place = layout.start(j); place < layout.start(j + 1); place++) {
        work[layout.rowAt(place)] += Math.abs(matrix[place]);
      }
    }
    for (int i = 0; i < n; i++) {
      norm = Math.max(norm, work[i]);
      work[i] = 0;
    }
    return norm;
  }

  @Override
  int eliminate() {
    return chosen && repeat() ? NONSINGULAR : choose();
  }

  /** Factors with pivots chosen anew; returns as {@link #factor}. */
  private int choose() {
    chosen = false;
    Arrays.fill(step, -1);
    Arrays.fill(reachedIn, 0);
    for (int k = 0; k < n; k++) {
      int top = reach(k);
      solveColumn(k, top);
      int p = choosePivot(k, top);
      if (!isPivot(work[p])) {
        Arrays.fill(work, 0);
        return column[k];
      }
      keepLower(k, top, p);
    }
    for (int e = 0; e < lowerStart[n]; e++) {
      lowerStep[e] = step[lowerStep[e]];
    }
    chosen = true;
    return NONSINGULAR;
  }

  /**
   * Finds the rows that differ from zero when a column is solved with the factors left of it.
   *
   * @return where they begin, in an order in which the steps they have can be eliminated
   */
  private int reach(int k) {
    int top = n;
    int j = column[k];
    for (int place = layout.start(j); place < layout.start(j + 1); place++) {
      if (reachedIn[layout.rowAt(place)] != k + 1) {
        top = reachFrom(layout.rowAt(place), k + 1, top);
      }
    }
    return top;
  }

  private int reachFrom(int first, int stamp, int top) {
    int depth = 0;
    int place = top;
    path[0] = first;
    open(first, stamp, 0);
    while (depth >= 0) {
      int i = path[depth];
      int end = step[i] < 0 ? 0 : lowerStart[step[i] + 1];
      int next = nextOnPath[depth];
      while (next < end && reachedIn[lowerStep[next]] == stamp) {
        next++;
      }
      if (next < end) {
        nextOnPath[depth] = next + 1;
        depth++;
        path[depth] = lowerStep[next];
        open(lowerStep[next], stamp, depth);
      } else {
        reached[--place] = i;
        depth--;
      }
    }
    return place;
  }

  private void open(int i, int stamp, int depth) {
    reachedIn[i] = stamp;
    nextOnPath[depth] = step[i] < 0 ? 0 : lowerStart[step[i]];
  }

  /** Solves a column with the factors left of it, and keeps what belongs to U. */
  private void solveColumn(int k, int top) {
    int j = column[k];
    for (int place = layout.start(j); place < layout.start(j + 1); place++) {
      work[layout.rowAt(place)] = matrix[place];
    }
    int count = upperStart[k];
    if (upperStep.length < count + n - top) {
      int room = grown(upperStep.length, count + n - top);
      upperStep = Arrays.copyOf(upperStep, room);
      upper = Arrays.copyOf(upper, room);
    }
    for (int r = top; r < n; r++) {
      int i = reached[r];
      int s = step[i];
      if (s < 0) {
        continue;
      }
      double factor = work[i];
      upperStep[count] = s;
      upper[count++] = factor;
      for (int e = lowerStart[s]; e < lowerStart[s + 1]; e++) {
        work[lowerStep[e]] -= lower[e] * factor;
      }
    }
    upperStart[k + 1] = count;
  }

  private static int grown(int length, int needed) {
    return (int) Math.min(Integer.MAX_VALUE - 8, Math.max(needed, length + (length >> 1) + 16L));
  }

  private int choosePivot(int k, int top) {
    int largest = -1;
    for (int r = top; r < n; r++) {
      int i = reached[r];
      boolean free = step[i] < 0;
      if (free && (largest < 0 || Math.abs(work[i]) > Math.abs(work[largest]))) {
        largest = i;
      }
    }
    int diagonal = column[k];
    if (largest < 0) {
      // each row reached has its step already: the column depends on those before
      return diagonal;
    }
    boolean usable =
        step[diagonal] < 0 && Math.abs(work[diagonal]) >= OF_LARGEST * Math.abs(work[largest]);
    return usable ? diagonal : largest;
  }

  private void keepLower(int k, int top, int p) {
    row[k] = p;
    step[p] = k;
    pivot[k] = work[p];
    int count = lowerStart[k];
    if (lowerStep.length < count + n - top) {
      int room = grown(lowerStep.length, count + n - top);
      lowerStep = Arrays.copyOf(lowerStep, room);
      lower = Arrays.copyOf(lower, room);
    }
    for (int r = top; r < n; r++) {
      int i = reached[r];
      if (step[i] < 0) {
        lowerStep[count] = i;
        lower[count++] = work[i] / pivot[k];
      }
      work[i] = 0;
    }
    lowerStart[k + 1] = count;
  }

  /** Factors with the pivots of the last matrix; returns whether they are those of this one. */
  private boolean repeat() {
    for (int k = 0; k < n; k++) {
      int j = column[k];
      for (int place = layout.start(j); place < layout.start(j + 1); place++) {
        work[step[layout.rowAt(place)]] = matrix[place];
      }
      for (int e = upperStart[k]; e < upperStart[k + 1]; e++) {
        int s = upperStep[e];
        double factor = work[s];
        work[s] = 0;
        upper[e] = factor;
        for (int i = lowerStart[s]; factor != 0 && i < lowerStart[s + 1]; i++) {
          work[lowerStep[i]] -= lower[i] * factor;
        }
      }
      if (!isChoice(k)) {
        Arrays.fill(work, 0);
        return false;
      }
      pivot[k] = work[k];
      work[k] = 0;
      for (int e = lowerStart[k]; e < lowerStart[k + 1]; e++) {
        lower[e] = work[lowerStep[e]] / pivot[k];
        work[lowerStep[e]] = 0;
      }
    }
    return true;
  }

  /** Returns whether the pivot of a step would be chosen for the column solved, too. */
  private boolean isChoice(int k) {
    double candidate = Math.abs(work[k]);
    double largest = 0;
    for (int e = lowerStart[k]; e < lowerStart[k + 1]; e++) {
      largest = Math.max(largest, Math.abs(work[lowerStep[e]]));
    }
    if (!isPivot(candidate)) {
      return false;
    }
    if (row[k] == column[k]) {
      return candidate >= OF_LARGEST * largest;
    }
    int ofDiagonal = step[column[k]];
    boolean diagonalUsable = ofDiagonal > k && Math.abs(work[ofDiagonal]) >= OF_LARGEST * candidate;
    return candidate > largest && !diagonalUsable;
  }

  /** Returns how many elements of L and U are kept, their diagonals counted once. */
  int elements() {
    return lowerStart[n] + upperStart[n] + n;
  }

  @Override
  void substitute(double[] b) {
    for (int k = 0; k < n; k++) {
      work[k] = b[row[k]];
    }
    for (int k = 0; k < n; k++) {
      double known = work[k];
      for (int e = lowerStart[k]; known != 0 && e < lowerStart[k + 1]; e++) {
        work[lowerStep[e]] -= lower[e] * known;
      }
    }
    for (int k = n - 1; k >= 0; k--) {
      double known = work[k] / pivot[k];
      for (int e = upperStart[k]; e < upperStart[k + 1]; e++) {
        work[upperStep[e]] -= upper[e] * known;
      }
      b[column[k]] = known;
      work[k] = 0;
    }
  }

  @Override
  void substituteTransposed(double[] b) {
    for (int k = 0; k < n; k++) {
      double sum = b[column[k]];
      for (int e = upperStart[k]; e < upperStart[k + 1]; e++) {
        sum -= upper[e] * work[upperStep[e]];
      }
      work[k] = sum / pivot[k];
    }
    for (int k = n - 1; k >= 0; k--) {
      double sum = work[k];
      for (int e = lowerStart[k]; e < lowerStart[k + 1]; e++) {
        sum -= lower[e] * work[lowerStep[e]];
      }
      work[k] = sum;
    }
    for (int k = 0; k < n; k++) {
      b[row[k]] = work[k];
      work[k] = 0;
    }
  }
}
