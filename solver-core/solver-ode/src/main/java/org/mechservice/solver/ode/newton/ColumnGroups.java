package org.mechservice.solver.ode.newton;

import java.util.BitSet;
import org.mechservice.solver.linear.MatrixLayout;
import org.mechservice.solver.ode.SparseSystem;
import org.mechservice.solver.ode.SystemParts;

/**
 * The columns of a matrix of derivatives in groups that share no row: one evaluation with all
 * columns of a group moved tells what each of them does. Of a band these are columns as far apart
 * as it is wide. Where a {@link SparseSystem} tells its pattern, each group takes from the columns
 * left, in their order, every one that shares no row with those it has (Curtis, Powell and Reid, J.
 * Inst. Maths Applics 13 (1974) 117).
 */
public final class ColumnGroups {
  private static final int NONE = -1;

  /** First column of each group. */
  private final int[] first;

  /** Column that follows a column in its group, or none; length n. */
  private final int[] next;

  /** Rows of each column, length n; of length 0 if all of the layout may differ from zero. */
  private final BitSet[] rows;

  private ColumnGroups(int[] first, int[] next, BitSet[] rows) {
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
    return new ColumnGroups(first, next, new BitSet[0]);
  }

  private static ColumnGroups ofPattern(SparseSystem pattern, int n) {
    BitSet[] rows = new BitSet[n];
    for (int j = 0; j < n; j++) {
      rows[j] = new BitSet(n);
      for (int i = 0; i < n; i++) {
        rows[j].set(i, pattern.couples(i, j));
      }
    }
    BitSet first = new BitSet(n);
    int[] next = new int[n];
    BitSet left = new BitSet(n);
    left.set(0, n);
    while (!left.isEmpty()) {
      first.set(left.nextSetBit(0));
      collect(left, rows, next);
    }
    return new ColumnGroups(first.stream().toArray(), next, rows);
  }

  /** Takes the columns of one group out of those that are left. */
  private static void collect(BitSet left, BitSet[] rows, int[] next) {
    BitSet taken = new BitSet(rows.length);
    int last = NONE;
    for (int j = left.nextSetBit(0); j >= 0; j = left.nextSetBit(j + 1)) {
      if (rows[j].intersects(taken)) {
        continue;
      }
      taken.or(rows[j]);
      left.clear(j);
      next[j] = NONE;
      if (last != NONE) {
        next[last] = j;
      }
      last = j;
    }
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
    return rows.length == 0 || rows[column].get(row);
  }
}
