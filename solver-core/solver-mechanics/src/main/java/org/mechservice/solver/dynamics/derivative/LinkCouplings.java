package org.mechservice.solver.dynamics.derivative;

import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.linear.MinimumDegree;
import org.mechservice.solver.linear.SparseLayout;

/**
 * The graph of a mechanism: its links, coupled by joints, by forces and by loops. Orders in which
 * the unknowns of links are eliminated from a sparse system. Immutable.
 */
final class LinkCouplings {
  private final TreeGeometry tree;
  private final FarBlocks far;
  private final LoopWrenches rows;

  LinkCouplings(TreeGeometry tree, FarBlocks far, LoopWrenches rows) {
    this.tree = tree;
    this.far = far;
    this.rows = rows;
  }

  /** Returns the links of a row of loops, with those of its velocities. */
  int[] touched(int row) {
    return IntStream.concat(
            IntStream.of(rows.links[row]),
            IntStream.of(rows.velocities[row]).map(k -> tree.linkOfVelocity[k]))
        .toArray();
  }

  /**
   * Returns the links whose unknowns are eliminated last of those that a row of loops touches: a
   * row follows them at once. The first link of the order for a row that touches none.
   *
   * @param order of the links
   */
  int[] lastOfRows(int[] order) {
    int[] turn = new int[order.length];
    for (int i = 0; i < order.length; i++) {
      turn[order[i]] = i;
    }
    return IntStream.range(0, rows.count())
        .map(row -> IntStream.of(touched(row)).map(link -> turn[link]).max().orElse(0))
        .map(last -> order[last])
        .toArray();
  }

  /** Returns the links in an order of least degree. */
  int[] byLeastDegree() {
    List<SortedSet<Integer>> coupled = none();
    visit((a, b) -> coupled.get(a).add(b));
    int[][] neighbours =
        coupled.stream()
            .map(each -> each.stream().mapToInt(Integer::intValue).toArray())
            .toArray(int[][]::new);
    return MinimumDegree.order(SparseLayout.of(neighbours));
  }

  /**
   * Returns the links, each behind those on it: always one that is coupled with the fewest others.
   */
  int[] fromTips() {
    List<SortedSet<Integer>> coupled = none();
    visit(
        (a, b) -> {
          if (a != b) {
            coupled.get(a).add(b);
            coupled.get(b).add(a);
          }
        });
    int[] onIt = new int[tree.linkCount];
    for (int parent : tree.parent) {
      if (parent != TreeGeometry.ROOT) {
        onIt[parent]++;
      }
    }
    // by degree, and the outermost first
    SortedSet<long[]> ready =
        new TreeSet<>((a, b) -> a[0] != b[0] ? Long.compare(a[0], b[0]) : Long.compare(b[1], a[1]));
    for (int link = 0; link < tree.linkCount; link++) {
      if (onIt[link] == 0) {
        ready.add(new long[] {coupled.get(link).size(), link});
      }
    }
    int[] order = new int[tree.linkCount];
    for (int i = 0; i < order.length; i++) {
      int link = (int) ready.first()[1];
      ready.remove(ready.first());
      order[i] = link;
      SortedSet<Integer> left = coupled.get(link);
      for (int other : left) {
        boolean isReady = onIt[other] == 0;
        if (isReady) {
          ready.remove(new long[] {coupled.get(other).size(), other});
        }
        coupled.get(other).addAll(left);
        coupled.get(other).remove(other);
        coupled.get(other).remove(link);
        boolean wasOnIt = tree.parent[link] == other;
        onIt[other] -= wasOnIt ? 1 : 0;
        if (isReady || (wasOnIt && onIt[other] == 0)) {
          ready.add(new long[] {coupled.get(other).size(), other});
        }
      }
    }
    return order;
  }

  private List<SortedSet<Integer>> none() {
    return Stream.<SortedSet<Integer>>generate(TreeSet::new).limit(tree.linkCount).toList();
  }

  /** Takes two links that are coupled, which may be the same. */
  private interface Coupling {
    void take(int a, int b);
  }

  /** Shows all couplings, each at least in one order. */
  private void visit(Coupling each) {
    for (int link = 0; link < tree.linkCount; link++) {
      if (tree.parent[link] != TreeGeometry.ROOT) {
        each.take(link, tree.parent[link]);
      }
    }
    for (int pair = 0; pair < far.count(); pair++) {
      each.take(far.on[pair], far.by[pair]);
    }
    for (int row = 0; row < rows.count(); row++) {
      int[] touched = touched(row);
      for (int link : touched) {
        each.take(link, touched[0]);
      }
    }
  }
}
