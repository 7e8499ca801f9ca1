package org.mechservice.solver.dynamics;

import java.util.Arrays;
import java.util.BitSet;
import org.mechservice.solver.kinematics.TreeGeometry;

/**
 * Which elements of a matrix over the velocities of the state may differ from zero, and the order
 * they are eliminated in. Immutable.
 *
 * <p>The elements of a tree's mass matrix couple a velocity with those on its way to the root
 * alone. Numbered outwards (<i>places</i>) and eliminated from the last to the first, such a matrix
 * has factors LᵀDL with the same pattern (Featherstone 2008, §6.5). A rod or a force between two
 * bodies couples the velocities on the ways to both; what elimination then fills is found here
 * once.
 */
public final class TreePattern {
  final int size;

  /** Velocity at each place, and place of each velocity of the state. */
  final int[] velocityAt;

  final int[] placeOf;

  /** Where the row of each place begins in {@link #column}; one more at the end. */
  final int[] rowStart;

  /** Smaller places coupled with the place of the row, ascending. */
  final int[] column;

  /** Whether every row begins with the rows of its columns, as it does on a bare tree. */
  final boolean bareTree;

  /**
   * Finds the pattern of a tree.
   *
   * @param pairs links coupled by rods or forces, two numbers per pair; {@link TreeGeometry#ROOT}
   *     couples nothing
   */
  public TreePattern(TreeGeometry tree, int[] pairs) {
    size = tree.stateVelocityCount;
    velocityAt = outwards(tree);
    placeOf = new int[size];
    for (int place = 0; place < size; place++) {
      placeOf[velocityAt[place]] = place;
    }
    BitSet[] rows = rows(tree);
    int onTree = count(rows);
    for (int i = 0; i < pairs.length; i += 2) {
      couple(tree, rows, pairs[i], pairs[i + 1]);
    }
    fill(rows);
    rowStart = new int[size + 1];
    column = new int[count(rows)];
    int next = 0;
    for (int place = 0; place < size; place++) {
      rowStart[place] = next;
      for (int c = rows[place].nextSetBit(0); c >= 0; c = rows[place].nextSetBit(c + 1)) {
        column[next++] = c;
      }
    }
    rowStart[size] = next;
    bareTree = next == onTree;
  }

  /** Links are numbered outwards already; within a ball the velocities keep their order. */
  private static int[] outwards(TreeGeometry tree) {
    int[] order = new int[tree.stateVelocityCount];
    int place = 0;
    for (int link = 0; link < tree.linkCount; link++) {
      if (!tree.driven[link]) {
        for (int k = 0; k < tree.kind[link].velocityCount(); k++) {
          order[place++] = tree.velocityAt[link] + k;
        }
      }
    }
    return order;
  }

  private BitSet[] rows(TreeGeometry tree) {
    BitSet[] rows = new BitSet[size];
    for (int place = 0; place < size; place++) {
      rows[place] = new BitSet(size);
      addWay(tree, tree.linkOfVelocity[velocityAt[place]], rows[place]);
      rows[place].clear(place, size);
    }
    return rows;
  }

  /** Adds the places on the way from a link to the root. */
  private void addWay(TreeGeometry tree, int link, BitSet row) {
    for (int i = link; i != TreeGeometry.ROOT; i = tree.parent[i]) {
      for (int k = 0; !tree.driven[i] && k < tree.kind[i].velocityCount(); k++) {
        row.set(placeOf[tree.velocityAt[i] + k]);
      }
    }
  }

  private void couple(TreeGeometry tree, BitSet[] rows, int first, int second) {
    if (first == TreeGeometry.ROOT || second == TreeGeometry.ROOT) {
      return;
    }
    BitSet both = new BitSet(size);
    addWay(tree, first, both);
    addWay(tree, second, both);
    for (int place = both.nextSetBit(0); place >= 0; place = both.nextSetBit(place + 1)) {
      addBefore(rows[place], both, place);
    }
  }

  /** Eliminating a place couples all that it is coupled with. */
  private static void fill(BitSet[] rows) {
    for (int place = rows.length - 1; place >= 0; place--) {
      for (int i = rows[place].nextSetBit(0); i >= 0; i = rows[place].nextSetBit(i + 1)) {
        addBefore(rows[i], rows[place], i);
      }
    }
  }

  private static void addBefore(BitSet row, BitSet other, int place) {
    row.or(other.get(0, place));
  }

  private static int count(BitSet[] rows) {
    return Arrays.stream(rows).mapToInt(BitSet::cardinality).sum();
  }

  /** Returns the number of velocities. */
  public int size() {
    return size;
  }

  /** Returns how many elements below the diagonal may differ from zero. */
  public int elementCount() {
    return column.length;
  }

  /**
   * Returns where an element stands in its row.
   *
   * @param row place, greater than {@code col}
   * @param col place
   * @return index into {@link #column}; negative if the element is zero
   */
  int find(int row, int col) {
    return Arrays.binarySearch(column, rowStart[row], rowStart[row + 1], col);
  }
}
