package org.mechservice.solver.dynamics.tree;

import java.util.Arrays;
import java.util.BitSet;
import java.util.stream.IntStream;
import org.mechservice.solver.kinematics.TreeGeometry;

/**
 * Sparsity pattern and elimination order of a matrix over the velocities of the state. Immutable.
 *
 * <p>The elements of a tree's mass matrix couple a velocity only with those of its ancestors.
 * Numbered outwards (<i>places</i>) and eliminated from the last to the first, such a matrix has
 * factors LᵀDL with the same pattern (Featherstone 2008, §6.5). A rod or a force between two bodies
 * couples the velocities of the ancestors of both; the constructor determines the resulting
 * fill-in.
 */
public final class TreePattern {
  public final int size;

  /** Velocity at each place, and place of each velocity of the state. */
  public final int[] velocityAt;

  public final int[] placeOf;

  /** Start of the row of each place in {@link #column}, and the end of the last row. */
  public final int[] rowStart;

  /** Smaller places coupled with the place of the row, ascending. */
  public final int[] column;

  /**
   * Whether every row begins with the rows of its columns, as for a tree without further couplings.
   */
  final boolean bareTree;

  /**
   * Determines the pattern of a tree.
   *
   * @param pairs links coupled by rods or forces, two numbers per pair; pairs with {@link
   *     TreeGeometry#ROOT} have no effect
   */
  public TreePattern(TreeGeometry tree, int[] pairs) {
    this(outwards(tree), parents(tree), ways(tree, pairs));
  }

  /**
   * Determines the pattern of a tree given by places.
   *
   * @param velocityAt velocity of the state at each place, outwards; not modified
   * @param parent parent of each place, −1 for none; not modified
   * @param coupled further elements, two places for each; not modified
   */
  public TreePattern(int[] velocityAt, int[] parent, int[] coupled) {
    size = velocityAt.length;
    this.velocityAt = velocityAt.clone();
    placeOf = new int[size];
    BitSet[] rows = new BitSet[size];
    for (int place = 0; place < size; place++) {
      placeOf[velocityAt[place]] = place;
      rows[place] = new BitSet(size);
      for (int i = parent[place]; i >= 0; i = parent[i]) {
        rows[place].set(i);
      }
    }
    int onTree = count(rows);
    for (int i = 0; i < coupled.length; i += 2) {
      if (coupled[i] != coupled[i + 1]) {
        rows[Math.max(coupled[i], coupled[i + 1])].set(Math.min(coupled[i], coupled[i + 1]));
      }
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
      for (int k = 0; k < count(tree, link); k++) {
        order[place++] = tree.velocityAt[link] + k;
      }
    }
    return order;
  }

  /**
   * Returns the parent of each place: the previous one in its link, or the last place of an
   * ancestor.
   */
  private static int[] parents(TreeGeometry tree) {
    int[] last = lastPlaces(tree);
    int[] parents = new int[tree.stateVelocityCount];
    for (int link = 0; link < tree.linkCount; link++) {
      int count = count(tree, link);
      int above = tree.parent[link] == TreeGeometry.ROOT ? -1 : last[tree.parent[link]];
      for (int k = 0; k < count; k++) {
        int place = last[link] - count + 1 + k;
        parents[place] = k == 0 ? above : place - 1;
      }
    }
    return parents;
  }

  private static int count(TreeGeometry tree, int link) {
    return tree.driven[link] ? 0 : tree.kind[link].velocityCount();
  }

  /** Returns for each link its last place, or that of the nearest ancestor with one. */
  private static int[] lastPlaces(TreeGeometry tree) {
    int[] last = new int[tree.linkCount];
    int places = 0;
    for (int link = 0; link < tree.linkCount; link++) {
      if (count(tree, link) == 0) {
        last[link] = tree.parent[link] == TreeGeometry.ROOT ? -1 : last[tree.parent[link]];
      } else {
        places += count(tree, link);
        last[link] = places - 1;
      }
    }
    return last;
  }

  /** Returns the elements by which pairs of links couple their ancestors. */
  private static int[] ways(TreeGeometry tree, int[] pairs) {
    int[] last = lastPlaces(tree);
    int[] parents = parents(tree);
    IntStream.Builder elements = IntStream.builder();
    for (int p = 0; p < pairs.length; p += 2) {
      if (pairs[p] != TreeGeometry.ROOT && pairs[p + 1] != TreeGeometry.ROOT) {
        for (int i = last[pairs[p]]; i >= 0; i = parents[i]) {
          for (int j = last[pairs[p + 1]]; j >= 0; j = parents[j]) {
            elements.add(i).add(j);
          }
        }
      }
    }
    return elements.build().toArray();
  }

  /** Adds the fill-in: elimination of a place couples all places coupled with it. */
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

  /** Returns the union with another pattern, in the places of this one. */
  public TreePattern joined(TreePattern other) {
    IntStream.Builder elements = IntStream.builder();
    addElements(this, elements);
    addElements(other, elements);
    int[] none = new int[size];
    Arrays.fill(none, -1);
    return new TreePattern(velocityAt, none, elements.build().toArray());
  }

  private void addElements(TreePattern from, IntStream.Builder elements) {
    for (int row = 0; row < size; row++) {
      for (int e = from.rowStart[row]; e < from.rowStart[row + 1]; e++) {
        elements.add(placeOf[from.velocityAt[row]]);
        elements.add(placeOf[from.velocityAt[from.column[e]]]);
      }
    }
  }

  /** Returns the number of velocities. */
  public int size() {
    return size;
  }

  /** Returns the number of elements below the diagonal that may differ from zero. */
  public int elementCount() {
    return column.length;
  }

  /**
   * Returns the index of an element.
   *
   * @param row place, greater than {@code col}
   * @param col place
   * @return index into {@link #column}; negative if the element is zero
   */
  public int find(int row, int col) {
    return Arrays.binarySearch(column, rowStart[row], rowStart[row + 1], col);
  }
}
