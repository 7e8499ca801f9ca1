package org.mechservice.solver.linear;

import java.util.Arrays;

/**
 * Factors P A Pᵀ = L D Lᵀ of a sparse symmetric matrix that need not be definite, with pivots of
 * one or two rows, and its inertia: the number of negative eigenvalues of A is that of D (Sylvester
 * 1852).
 *
 * <p>Unknowns are eliminated in groups, in a given order. Each group has a dense front: its own
 * rows and those that they are coupled with, with what earlier groups have left to them (Duff and
 * Reid, <i>The multifrontal solution of indefinite sparse symmetric linear equations</i>, ACM
 * Trans. Math. Softw. 9 (1983) 302). A pivot is taken if it is not much smaller than the rest of
 * its columns; a row without one is left to the front that takes what this one leaves. So the order
 * saves work, and does not cost digits.
 *
 * <p>A workspace for one thread; {@link #factor} allocates the factors.
 */
public final class SymmetricFronts {
  /** Smallest pivot as a part of the largest element beside it in its column. */
  private static final double PIVOT = 0.1;

  /** Number of rows without pivots in a front at which the matrix is taken as singular. */
  private static final int MOST_DELAYED = 100;

  /** A pivot below this part of what it was subtracted from is rounding. */
  private static final double SINGULAR = 64 * Math.ulp(1.0);

  /** A row that is zero but for rounding. */
  private static final int ROUNDED = -1;

  private final int size;
  private final int[][] groups;
  private final int[] groupOf;

  /** Elements by the group that is eliminated first of both of their unknowns. */
  private final int[] row;

  private final int[] column;
  private final int[] startOfGroup;
  private final int[] elementOfGroup;

  /** Factors of each group. */
  private final Factor[] factors;

  /** What each group leaves; empty once it is taken. */
  private final Rest[] rests;

  /** First group whose rest a group takes, and the next one that is taken with a group. */
  private final int[] firstChild;

  private final int[] nextChild;

  /** Place of each unknown in the present front, where it is marked by the present group. */
  private final int[] place;

  private final int[] mark;
  private int[] member = new int[64];
  private double[] largest = new double[64];
  private double[] whole = new double[64];
  private double[] front = {};
  private int negative;
  private int rounding;
  private boolean abandoned;

  /** Rows at the beginning of each group whose pivots are given: two for each. */
  private final int[] paired;

  /** Rows of L with the pivots first, its columns, and D: two numbers for each pivot. */
  private static final class Factor {
    static final Factor NONE = new Factor(new int[0], 0, new double[0], new double[0]);

    final int[] rows;
    final int pivots;
    final double[] l;
    final double[] d;

    Factor(int[] rows, int pivots, double[] l, double[] d) {
      this.rows = rows;
      this.pivots = pivots;
      this.l = l;
      this.d = d;
    }
  }

  /** Rows that are left, those without a pivot first, and their elements. */
  private static final class Rest {
    static final Rest NONE = new Rest(new int[0], 0, new double[0], new double[0]);

    final int[] rows;
    final int delayed;
    final double[] matrix;

    /** Size of what each diagonal element was summed and subtracted from. */
    final double[] whole;

    Rest(int[] rows, int delayed, double[] matrix, double[] whole) {
      this.rows = rows;
      this.delayed = delayed;
      this.matrix = matrix;
      this.whole = whole;
    }
  }

  /**
   * Makes a workspace.
   *
   * @param size number of unknowns
   * @param groups of unknowns in the order of elimination, each unknown in one of them; not
   *     modified
   * @param paired how many unknowns at the beginning of each group are pivots of two rows, in their
   *     order, that need not be searched; not modified
   * @param row of each element; one of the two that mirror each other; an element may come several
   *     times and is then summed; not modified
   * @param column of each element; not modified
   */
  public SymmetricFronts(int size, int[][] groups, int[] paired, int[] row, int[] column) {
    this.size = size;
    this.groups = groups.clone();
    this.paired = paired.clone();
    this.row = row.clone();
    this.column = column.clone();
    groupOf = new int[size];
    for (int g = 0; g < groups.length; g++) {
      for (int unknown : groups[g]) {
        groupOf[unknown] = g;
      }
    }
    startOfGroup = new int[groups.length + 1];
    for (int e = 0; e < row.length; e++) {
      startOfGroup[groupOfElement(e) + 1]++;
    }
    for (int g = 0; g < groups.length; g++) {
      startOfGroup[g + 1] += startOfGroup[g];
    }
    elementOfGroup = new int[row.length];
    int[] next = startOfGroup.clone();
    for (int e = 0; e < row.length; e++) {
      elementOfGroup[next[groupOfElement(e)]++] = e;
    }
    factors = new Factor[groups.length];
    rests = new Rest[groups.length];
    firstChild = new int[groups.length];
    nextChild = new int[groups.length];
    place = new int[size];
    mark = new int[size];
  }

  private int groupOfElement(int e) {
    return Math.min(groupOf[row[e]], groupOf[column[e]]);
  }

  /** Returns the number of unknowns. */
  public int size() {
    return size;
  }

  /**
   * Factors.
   *
   * @param value of each element; not modified
   * @return whether A is regular
   */
  public boolean factor(double[] value) {
    return factor(value, size);
  }

  /**
   * Factors unless more eigenvalues are negative than may be.
   *
   * @param value of each element; not modified
   * @param most number of negative eigenvalues that each group may add to those before
   * @return whether A is regular, with that many at most
   */
  public boolean factor(double[] value, int most) {
    negative = 0;
    rounding = 0;
    abandoned = false;
    Arrays.fill(firstChild, -1);
    Arrays.fill(mark, -1);
    Arrays.fill(rests, Rest.NONE);
    Arrays.fill(factors, Factor.NONE);
    for (int g = 0; g < groups.length && !abandoned; g++) {
      eliminate(g, value);
      abandoned |= negative > (long) most * (g + 1);
    }
    return rounding == 0 && !abandoned;
  }

  /** Returns the number of negative eigenvalues of the matrix factored last. */
  public int negative() {
    return negative;
  }

  /** Returns whether so many rows were without pivots that the others were not eliminated. */
  public boolean isAbandoned() {
    return abandoned;
  }

  /** Returns the number of eigenvalues that are zero up to rounding. */
  public int rounding() {
    return rounding;
  }

  private void eliminate(int g, double[] value) {
    int count = 0;
    for (int unknown : groups[g]) {
      count = enter(g, unknown, count);
    }
    for (int child = firstChild[g]; child >= 0; child = nextChild[child]) {
      for (int i = 0; i < rests[child].delayed; i++) {
        count = enter(g, rests[child].rows[i], count);
      }
    }
    int candidates = count;
    for (int i = startOfGroup[g]; i < startOfGroup[g + 1]; i++) {
      int e = elementOfGroup[i];
      count = enter(g, row[e], count);
      count = enter(g, column[e], count);
    }
    for (int child = firstChild[g]; child >= 0; child = nextChild[child]) {
      for (int unknown : rests[child].rows) {
        count = enter(g, unknown, count);
      }
    }
    assemble(g, count, value);
    if (candidates > groups[g].length + MOST_DELAYED) {
      abandoned = true;
      return;
    }
    double[] d = new double[2 * candidates];
    int pivots = pivot(count, paired[g], candidates, d);
    factors[g] = factorOf(count, pivots, d);
    leave(g, count, candidates, pivots);
  }

  /** Gives an unknown a place in a group's front; returns the number of those that have one. */
  private int enter(int g, int unknown, int count) {
    if (mark[unknown] == g) {
      return count;
    }
    mark[unknown] = g;
    place[unknown] = count;
    if (count == member.length) {
      member = Arrays.copyOf(member, 2 * count);
      largest = new double[2 * count];
      whole = new double[2 * count];
    }
    member[count] = unknown;
    return count + 1;
  }

  private void assemble(int g, int n, double[] value) {
    if (front.length < n * n) {
      front = new double[2 * n * n];
    }
    Arrays.fill(front, 0, n * n, 0);
    Arrays.fill(whole, 0, n, 0);
    for (int i = startOfGroup[g]; i < startOfGroup[g + 1]; i++) {
      int e = elementOfGroup[i];
      int r = place[row[e]];
      int c = place[column[e]];
      front[r * n + c] += value[e];
      if (r == c) {
        whole[r] += Math.abs(value[e]);
      } else {
        front[c * n + r] += value[e];
      }
    }
    for (int child = firstChild[g]; child >= 0; child = nextChild[child]) {
      Rest rest = rests[child];
      int m = rest.rows.length;
      for (int i = 0; i < m; i++) {
        int r = place[rest.rows[i]];
        whole[r] += rest.whole[i];
        for (int j = 0; j < m; j++) {
          front[r * n + place[rest.rows[j]]] += rest.matrix[i * m + j];
        }
      }
      rests[child] = Rest.NONE;
    }
  }

  /** Eliminates what has pivots among the candidates; returns how many rows have. */
  private int pivot(int n, int given, int candidates, double[] d) {
    int k = 0;
    while (k < given && front[k * n + k + 1] != 0) {
      eliminateTwo(n, k, d);
      k += 2;
    }
    while (k < candidates) {
      int taken = choose(n, k, candidates);
      if (taken == 0) {
        return k;
      }
      if (taken == ROUNDED) {
        rounding++;
        d[2 * k] = 1;
        taken = 1;
      } else if (taken == 1) {
        eliminateOne(n, k, d);
      } else {
        eliminateTwo(n, k, d);
      }
      k += taken;
    }
    return k;
  }

  /** Sets a row and its column of what is left to zero. */
  private void clear(int n, int k, int c) {
    for (int r = k; r < n; r++) {
      front[c * n + r] = 0;
      front[r * n + c] = 0;
    }
  }

  /**
   * Brings the best pivot to row k; returns its number of rows, 0 if there is none, or {@link
   * #ROUNDED} for a row that is zero but for rounding.
   */
  private int choose(int n, int k, int candidates) {
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
        clear(n, k, c);
        swap(n, k, c);
        return ROUNDED;
      }
      double part = beside == 0 ? Double.MAX_VALUE : pivot / beside;
      if (pivot > SINGULAR * whole[c] && part > bestPart) {
        best = c;
        bestPart = part;
      }
    }
    if (best >= 0) {
      swap(n, k, best);
      return 1;
    }
    return chooseTwo(n, k, candidates);
  }

  /** Takes two rows whose inverse does not enlarge what is beside them. */
  private int chooseTwo(int n, int k, int candidates) {
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
        double besideC = besides(n, k, c, e);
        double besideE = besides(n, k, e, c);
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
    swap(n, k, first);
    swap(n, k + 1, second);
    return 2;
  }

  /** Returns the largest element of a row beside two columns. */
  private double besides(int n, int k, int c, int e) {
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

  private void swap(int n, int i, int j) {
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
  private void eliminateOne(int n, int k, double[] d) {
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

  private void eliminateTwo(int n, int k, double[] d) {
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

  private Factor factorOf(int n, int pivots, double[] d) {
    double[] l = new double[(n - 1) * pivots];
    int next = 0;
    for (int k = 0; k < pivots; k++) {
      boolean firstOfTwo = d[2 * k + 1] != 0;
      for (int r = k + 1; r < n; r++) {
        l[next++] = firstOfTwo && r == k + 1 ? 0 : front[r * n + k];
      }
    }
    return new Factor(
        Arrays.copyOf(member, n), pivots, Arrays.copyOf(l, next), Arrays.copyOf(d, 2 * pivots));
  }

  /** Leaves the rows without pivots to the group that is eliminated first among those coupled. */
  private void leave(int g, int n, int candidates, int pivots) {
    if (candidates == n) {
      rounding += n - pivots;
      return;
    }
    int taker = groups.length;
    for (int i = candidates; i < n; i++) {
      taker = Math.min(taker, groupOf[member[i]]);
    }
    int m = n - pivots;
    double[] matrix = new double[m * m];
    for (int i = 0; i < m; i++) {
      System.arraycopy(front, (pivots + i) * n + pivots, matrix, i * m, m);
    }
    rests[g] =
        new Rest(
            Arrays.copyOfRange(member, pivots, n),
            candidates - pivots,
            matrix,
            Arrays.copyOfRange(whole, pivots, n));
    nextChild[g] = firstChild[taker];
    firstChild[taker] = g;
  }

  /**
   * Solves A x = b with the factors of a regular matrix.
   *
   * @param b right-hand side; overwritten with x
   */
  public void solve(double[] b) {
    for (Factor factor : factors) {
      int n = factor.rows.length;
      int at = 0;
      for (int k = 0; k < factor.pivots; k++) {
        double x = b[factor.rows[k]];
        for (int r = k + 1; r < n; r++) {
          b[factor.rows[r]] -= factor.l[at++] * x;
        }
      }
    }
    for (int g = factors.length - 1; g >= 0; g--) {
      divide(factors[g], b);
      Factor factor = factors[g];
      int n = factor.rows.length;
      int at = factor.l.length;
      for (int k = factor.pivots - 1; k >= 0; k--) {
        double sum = b[factor.rows[k]];
        for (int r = n - 1; r > k; r--) {
          sum -= factor.l[--at] * b[factor.rows[r]];
        }
        b[factor.rows[k]] = sum;
      }
    }
  }

  private static void divide(Factor factor, double[] b) {
    int k = 0;
    while (k < factor.pivots) {
      int row = factor.rows[k];
      double a = factor.d[2 * k];
      double cross = factor.d[2 * k + 1];
      if (cross == 0) {
        b[row] /= a;
        k++;
      } else {
        int next = factor.rows[k + 1];
        double other = factor.d[2 * k + 2];
        double det = a * other - cross * cross;
        double x = (other * b[row] - cross * b[next]) / det;
        b[next] = (a * b[next] - cross * b[row]) / det;
        b[row] = x;
        k += 2;
      }
    }
  }
}
