package org.mechservice.solver.ode.newton;

import java.util.Arrays;
import org.mechservice.solver.linear.MatrixLayout;
import org.mechservice.solver.ode.SparseSystem;
import org.mechservice.solver.ode.SystemParts;

/**
 * The columns of a matrix of derivatives in groups whose columns share no row. One evaluation with
 * all columns of a group moved yields all their elements. The columns of a group of a band are one
 * bandwidth apart. With the pattern of a {@link SparseSystem} each column, in their order, joins
 * the first group that shares no row with it (Curtis, Powell and Reid, J. Inst. Maths Applics 13
 * (1974) 117).
 */
public final class ColumnGroups {
  private static final int NONE = -1;

  /** First column of each group. */
  private final int[] first;

  /** Column that follows a column in its group, or none; length n. */
  private final int[] next;

  /** Ascending rows of each column; of length 0 if all of the layout may differ from zero. */
  private final int[][] rows;

  private ColumnGroups(int[] first, int[] next, int[][] rows) {
    this.first = first;
    this.next = next;
    this.rows = rows;
  }

  /**
   * Returns the groups of a problem's columns.
   *
   * @param system the problem, asked for its pattern
   * @param layout of its matrix
   */
  public static ColumnGroups of(SystemParts system, MatrixLayout layout) {
    return system
        .part(SparseSystem.class)
        .map(sparse -> ofPattern(sparse, layout.dimension()))
        .orElseGet(() -> ofLayout(layout));
  }

  private static ColumnGroups ofLayout(MatrixLayout layout) {
    int n = layout.dimension();
    int[] first = new int[Math.min(layout.columnDistance(), n)];
    for (int group = 0; group < first.length; group++) {
      first[group] = group;
    }
    int[] next = new int[n];
    for (int j = 0; j < n; j++) {
      int after = j + layout.columnDistance();
      next[j] = after < n ? after : NONE;
    }
    return new ColumnGroups(first, next, new int[0][]);
  }

  /** Returns the ascending rows of each column of a pattern. */
  static int[][] rows(SparseSystem pattern, int n) {
    int[][] rows = new int[n][];
    for (int j = 0; j < n; j++) {
      rows[j] = pattern.equations(j, n);
    }
    return rows;
  }

  private static ColumnGroups ofPattern(SparseSystem pattern, int n) {
    int[][] rows = rows(pattern, n);
    int[] degree = new int[n];
    for (int j = 0; j < n; j++) {
      for (int i : rows[j]) {
        degree[i]++;
      }
    }
    int[][] groupsOfRow = new int[n][];
    for (int i = 0; i < n; i++) {
      groupsOfRow[i] = new int[degree[i]];
    }
    return firstFit(rows, groupsOfRow);
  }

  /**
   * Puts each column, in their order, into the first group that has none of its rows. The time is
   * the sum over the rows of the number of their elements squared.
   *
   * @param groupsOfRow a workspace: for each row as many places as it has elements
   */
  private static ColumnGroups firstFit(int[][] rows, int[][] groupsOfRow) {
    int n = rows.length;
    int[] filled = new int[n]; // groups known of each row
    int[] first = new int[n];
    int[] last = new int[n];
    int[] next = new int[n];
    int[] excludedFor = new int[n]; // the last column, plus 1, that a group is excluded for
    int count = 0;
    for (int j = 0; j < n; j++) {
      for (int i : rows[j]) {
        for (int k = 0; k < filled[i]; k++) {
          excludedFor[groupsOfRow[i][k]] = j + 1;
        }
      }
      int group = 0;
      while (excludedFor[group] == j + 1) {
        group++;
      }
      for (int i : rows[j]) {
        groupsOfRow[i][filled[i]++] = group;
      }
      if (group == count) {
        first[count++] = j;
      } else {
        next[last[group]] = j;
      }
      last[group] = j;
      next[j] = NONE;
    }
    return new ColumnGroups(Arrays.copyOf(first, count), next, rows);
  }

  /** Returns the number of groups. */
  public int count() {
    return first.length;
  }

  /** Returns the first column of a group. */
  public int first(int group) {
    return first[group];
  }

  /** Returns the column that follows in the group; negative if it is the last. */
  public int next(int column) {
    return next[column];
  }

  /** Returns whether an element that the layout has may differ from zero. */
  public boolean couples(int row, int column) {
    return rows.length == 0 || Arrays.binarySearch(rows[column], row) >= 0;
  }
}
