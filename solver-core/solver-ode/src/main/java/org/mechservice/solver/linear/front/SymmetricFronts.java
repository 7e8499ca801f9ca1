package org.mechservice.solver.linear.front;

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
  /** Number of rows without pivots in a front at which the matrix is taken as singular. */
  private static final int MOST_DELAYED = 100;

  private final int size;
  private final int[][] groups;
  private final int[] groupOf;

  /** Elements by the group that is eliminated first of both of their unknowns. */
  private final int[] row;

  private final int[] column;
  private final int[] startOfGroup;
  private final int[] elementOfGroup;

  /** Factors of each group. */
  private final FrontFactor[] factors;

  /** What each group leaves; empty once it is taken. */
  private final FrontRest[] rests;

  /** First group whose rest a group takes, and the next one that is taken with a group. */
  private final int[] firstChild;

  private final int[] nextChild;

  /** Place of each unknown in the present front, where it is marked by the present group. */
  private final int[] place;

  private final int[] mark;

  /** Rows at the beginning of each group whose pivots are given: two for each. */
  private final int[] paired;

  private final DenseFront front = new DenseFront();
  private int negative;
  private int rounding;
  private boolean abandoned;

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
    factors = new FrontFactor[groups.length];
    rests = new FrontRest[groups.length];
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
    Arrays.fill(rests, FrontRest.NONE);
    Arrays.fill(factors, FrontFactor.NONE);
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

  /**
   * Returns whether so many rows were without pivots, or so many eigenvalues negative, that the
   * others were not eliminated.
   */
  public boolean isAbandoned() {
    return abandoned;
  }

  /** Returns the number of eigenvalues that are zero up to rounding. */
  public int rounding() {
    return rounding;
  }

  private void eliminate(int g, double[] value) {
    front.begin();
    for (int unknown : groups[g]) {
      enter(g, unknown);
    }
    for (int child = firstChild[g]; child >= 0; child = nextChild[child]) {
      for (int i = 0; i < rests[child].delayed; i++) {
        enter(g, rests[child].rows[i]);
      }
    }
    int candidates = front.size();
    for (int i = startOfGroup[g]; i < startOfGroup[g + 1]; i++) {
      int e = elementOfGroup[i];
      enter(g, row[e]);
      enter(g, column[e]);
    }
    for (int child = firstChild[g]; child >= 0; child = nextChild[child]) {
      for (int unknown : rests[child].rows) {
        enter(g, unknown);
      }
    }
    if (candidates > groups[g].length + MOST_DELAYED) {
      abandoned = true;
      return;
    }
    assemble(g, value);
    factors[g] = front.eliminate(paired[g], candidates);
    negative += front.negative();
    rounding += front.rounded();
    leave(g, factors[g].pivots(), candidates);
  }

  /** Gives an unknown a row in a group's front unless it has one. */
  private void enter(int g, int unknown) {
    if (mark[unknown] != g) {
      mark[unknown] = g;
      place[unknown] = front.enter(unknown);
    }
  }

  private void assemble(int g, double[] value) {
    front.clear();
    for (int i = startOfGroup[g]; i < startOfGroup[g + 1]; i++) {
      int e = elementOfGroup[i];
      front.add(place[row[e]], place[column[e]], value[e]);
    }
    for (int child = firstChild[g]; child >= 0; child = nextChild[child]) {
      front.add(rests[child], place);
      rests[child] = FrontRest.NONE;
    }
  }

  /** Leaves the rows without pivots to the group that is eliminated first among those coupled. */
  private void leave(int g, int pivots, int candidates) {
    if (candidates == front.size()) {
      rounding += candidates - pivots;
      return;
    }
    FrontRest rest = front.rest(pivots, candidates);
    int taker = groups.length;
    for (int i = rest.delayed; i < rest.rows.length; i++) {
      taker = Math.min(taker, groupOf[rest.rows[i]]);
    }
    rests[g] = rest;
    nextChild[g] = firstChild[taker];
    firstChild[taker] = g;
  }

  /**
   * Solves A x = b with the factors of a regular matrix.
   *
   * @param b right-hand side; overwritten with x
   */
  public void solve(double[] b) {
    for (FrontFactor factor : factors) {
      factor.forward(b);
    }
    for (int g = factors.length - 1; g >= 0; g--) {
      factors[g].divide(b);
      factors[g].backward(b);
    }
  }
}
