package org.mechservice.solver.linear.front;

import java.util.Arrays;

/**
 * A dense symmetric matrix of which some rows are eliminated, with pivots of one or two rows.
 *
 * <p>The rows of unknowns that may be eliminated here, the candidates, come first. A pivot of one
 * row is taken if it is not much smaller than what is beside it in its column; one of two rows if
 * its inverse does not enlarge what is beside them more (Duff and Reid, ACM Trans. Math. Softw. 9
 * (1983) 302, §2). A candidate without either is left, with what the others have left of it.
 *
 * <p>Each diagonal element has its whole: the sum of the sizes of what it was summed and subtracted
 * from. What is below the rounding of that is taken as zero.
 *
 * <p>A workspace for one thread and many fronts, one after the other: {@link #begin}, {@link
 * #enter} for each unknown, {@link #clear}, {@code add} for what is in it, {@link #eliminate}, and
 * {@link #rest}.
 */
final class DenseFront {
  /** Smallest pivot as a part of the largest element beside it in its column. */
  private static final double PIVOT = 0.1;

  /** A pivot below this part of what it was subtracted from is rounding. */
  private static final double SINGULAR = 64 * Math.ulp(1.0);

  /** A row that is zero but for rounding. */
  private static final int ROUNDED = -1;

  /** Number of rows. */
  private int n;

  /** Unknown of each row. */
  private int[] member = new int[64];

  /** Largest element beside the diagonal of each candidate, at the present pivot. */
  private double[] largest = new double[64];

  private double[] whole = new double[64];

  /** Elements, row by row. */
  private double[] front = {};

  private int negative;
  private int rounded;

  /** Begins a front without rows. */
  void begin() {
    n = 0;
    negative = 0;
    rounded = 0;
  }

  /** Adds a row for an unknown that has none yet; returns its place. */
  int enter(int unknown) {
    if (n == member.length) {
      member = Arrays.copyOf(member, 2 * n);
      largest = new double[2 * n];
      whole = new double[2 * n];
    }
    member[n] = unknown;
    return n++;
  }

  /** Returns the number of rows. */
  int size() {
    return n;
  }

  /** Sets the elements of all rows to zero, once every unknown has its row. */
  void clear() {
    if (front.length < n * n) {
      front = new double[2 * n * n];
    }
    Arrays.fill(front, 0, n * n, 0);
    Arrays.fill(whole, 0, n, 0);
  }

  /** Adds to an element of a row and a column, and to the one that mirrors it. */
  void add(int r, int c, double value) {
    front[r * n + c] += value;
    if (r == c) {
      whole[r] += Math.abs(value);
    } else {
      front[c * n + r] += value;
    }
  }

  /**
   * Adds what an earlier front has left.
   *
   * @param rest whose unknowns all have rows here; not modified
   * @param place row of each unknown of the matrix; not modified
   */
  void add(FrontRest rest, int[] place) {
    int m = rest.rows.length;
    for (int i = 0; i < m; i++) {
      int r = place[rest.rows[i]];
      whole[r] += rest.whole[i];
      for (int j = 0; j < m; j++) {
        front[r * n + place[rest.rows[j]]] += rest.matrix[i * m + j];
      }
    }
  }

  /**
   * Eliminates the candidates that have pivots.
   *
   * @param given number of rows at the beginning that are pivots of two rows in their order, taken
   *     without a search unless they are singular or not coupled
   * @param candidates number of rows at the beginning that may be eliminated
   * @return the factor, with the number of pivots found
   */
  FrontFactor eliminate(int given, int candidates) {
    double[] d = new double[2 * candidates];
    int pivots = pivot(given, candidates, d);
    double[] l = new double[(n - 1) * pivots];
    int next = 0;
    for (int k = 0; k < pivots; k++) {
      boolean firstOfTwo = d[2 * k + 1] != 0;
      for (int r = k + 1; r < n; r++) {
        l[next++] = firstOfTwo && r == k + 1 ? 0 : front[r * n + k];
      }
    }
    return new FrontFactor(Arrays.copyOf(member, n), pivots, Arrays.copyOf(l, next), d);
  }

  /** Returns what is left behind a number of pivots, candidates without a pivot first. */
  FrontRest rest(int pivots, int candidates) {
    int m = n - pivots;
    double[] matrix = new double[m * m];
    for (int i = 0; i < m; i++) {
      System.arraycopy(front, (pivots + i) * n + pivots, matrix, i * m, m);
    }
    return new FrontRest(
        Arrays.copyOfRange(member, pivots, n),
        candidates - pivots,
        matrix,
        Arrays.copyOfRange(whole, pivots, n));
  }

  /** Returns the number of negative eigenvalues of the pivots of this front. */
  int negative() {
    return negative;
  }

  /** Returns the number of rows of this front that were zero but for rounding. */
  int rounded() {
    return rounded;
  }

  /** Returns whether rows k and k + 1 are coupled and a pivot that can be divided by. */
  private boolean isRegular(int k) {
    double cross = front[k * n + k + 1];
    return cross != 0 && front[k * n + k] * front[(k + 1) * n + k + 1] != cross * cross;
  }

  /** Eliminates what has pivots among the candidates; returns how many rows have. */
  private int pivot(int given, int candidates, double[] d) {
    int k = 0;
    while (k < given && isRegular(k)) {
      eliminateTwo(k, d);
      k += 2;
    }
    while (k < candidates) {
      int taken = choose(k, candidates);
      if (taken == 0) {
        return k;
      }
      if (taken == ROUNDED) {
        rounded++;
        d[2 * k] = 1;
        taken = 1;
      } else if (taken == 1) {
        eliminateOne(k, d);
      } else {
        eliminateTwo(k, d);
      }
      k += taken;
    }
    return k;
  }

  /** Sets a row and its column of what is left to zero. */
  private void zero(int k, int c) {
    for (int r = k; r < n; r++) {
      front[c * n + r] = 0;
      front[r * n + c] = 0;
    }
  }

  /**
   * Brings the best pivot to row k; returns its number of rows, 0 if there is none, or {@link
   * #ROUNDED} for a row that is zero but for rounding.
   */
  private int choose(int k, int candidates) {
    int best = -1;
    double bestPart = PIVOT;
    for (int c = k; c < candidates; c++) {
      double beside = 0;
      for (int r = k; r < n; r++) {
        if (r != c) {
          beside = Math.max(beside, Math.abs(front[c * n + r]));
        }
      }
      largest[c] = beside;
      double pivot = Math.abs(front[c * n + c]);
      if (Math.max(pivot, beside) <= SINGULAR * whole[c]) {
        zero(k, c);
        swap(k, c);
        return ROUNDED;
      }
      double part = beside == 0 ? Double.MAX_VALUE : pivot / beside;
      if (pivot > SINGULAR * whole[c] && part > bestPart) {
        best = c;
        bestPart = part;
      }
    }
    if (best >= 0) {
      swap(k, best);
      return 1;
    }
    return chooseTwo(k, candidates);
  }

  /** Takes two rows whose inverse does not enlarge what is beside them. */
  private int chooseTwo(int k, int candidates) {
    int first = -1;
    int second = -1;
    double bestPart = PIVOT;
    for (int c = k; c < candidates; c++) {
      for (int e = c + 1; e < candidates; e++) {
        double cross = Math.abs(front[c * n + e]);
        double a = front[c * n + c];
        double b = front[e * n + e];
        double det = Math.abs(a * b - cross * cross);
        if (cross <= SINGULAR * Math.sqrt(whole[c] * whole[e])
            || !(det > SINGULAR * (Math.abs(a * b) + cross * cross))) {
          continue;
        }
        double besideC = besides(k, c, e);
        double besideE = besides(k, e, c);
        double grown =
            Math.max(
                Math.abs(b) * besideC + cross * besideE, cross * besideC + Math.abs(a) * besideE);
        double part = grown == 0 ? Double.MAX_VALUE : det / grown;
        if (part > bestPart) {
          first = c;
          second = e;
          bestPart = part;
        }
      }
    }
    if (first < 0) {
      return 0;
    }
    swap(k, first);
    swap(k + 1, second);
    return 2;
  }

  /** Returns the largest element of a row beside two columns. */
  private double besides(int k, int c, int e) {
    if (Math.abs(front[c * n + e]) < largest[c]) {
      return largest[c];
    }
    double beside = 0;
    for (int r = k; r < n; r++) {
      if (r != c && r != e) {
        beside = Math.max(beside, Math.abs(front[c * n + r]));
      }
    }
    return beside;
  }

  private void swap(int i, int j) {
    if (i == j) {
      return;
    }
    int unknown = member[i];
    member[i] = member[j];
    member[j] = unknown;
    double size = whole[i];
    whole[i] = whole[j];
    whole[j] = size;
    for (int c = 0; c < n; c++) {
      double element = front[i * n + c];
      front[i * n + c] = front[j * n + c];
      front[j * n + c] = element;
    }
    for (int r = 0; r < n; r++) {
      double element = front[r * n + i];
      front[r * n + i] = front[r * n + j];
      front[r * n + j] = element;
    }
  }

  /** Row k keeps the pivot's row; column k becomes that of L. */
  private void eliminateOne(int k, double[] d) {
    double pivot = front[k * n + k];
    negative += pivot < 0 ? 1 : 0;
    d[2 * k] = pivot;
    for (int r = k + 1; r < n; r++) {
      double factor = front[k * n + r] / pivot;
      front[r * n + k] = factor;
      if (factor != 0) {
        for (int c = k + 1; c < n; c++) {
          front[r * n + c] -= factor * front[k * n + c];
        }
        whole[r] += Math.abs(factor * front[k * n + r]);
      }
    }
  }

  private void eliminateTwo(int k, double[] d) {
    double a = front[k * n + k];
    double b = front[(k + 1) * n + k + 1];
    double cross = front[k * n + k + 1];
    double det = a * b - cross * cross;
    negative += det < 0 ? 1 : a < 0 ? 2 : 0;
    d[2 * k] = a;
    d[2 * k + 1] = cross;
    d[2 * k + 2] = b;
    for (int r = k + 2; r < n; r++) {
      double x = front[k * n + r];
      double y = front[(k + 1) * n + r];
      double first = (b * x - cross * y) / det;
      double second = (a * y - cross * x) / det;
      front[r * n + k] = first;
      front[r * n + k + 1] = second;
      if (first != 0 || second != 0) {
        for (int c = k + 2; c < n; c++) {
          front[r * n + c] -= first * front[k * n + c] + second * front[(k + 1) * n + c];
        }
        whole[r] += Math.abs(first * x) + Math.abs(second * y);
      }
    }
  }
}
