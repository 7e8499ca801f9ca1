package org.mechservice.solver.dynamics.derivative;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.linear.MinimumDegree;
import org.mechservice.solver.linear.SparseLayout;

/**
 * Indices of the unknowns of {@link LinkSystem} and the order of their elimination. The unknowns of
 * a link are z, w, u where the system has velocities of links, and x of its joint; the multipliers
 * follow those of all links. Immutable.
 */
final class LinkUnknowns {
  /** Where w and, if there is one, u of a link begin among its unknowns, and ξ in z. */
  static final int WRENCH = PlacedLinks.WIDTH;

  static final int SPEED = WRENCH + 6;
  static final int PLACE = 12;

  private final PlacedLinks links;
  private final FarBlocks far;
  private final LoopWrenches rows;

  /** Whether u are unknowns: where loops are, and ξ / hγ² is not u because of balls. */
  final boolean hasSpeeds;

  /** Number of unknowns of a link besides its velocities. */
  final int ofLink;

  /** Index of the first unknown of each link, and of the first multiplier. */
  final int[] at;

  final int firstMultiplier;

  /** Number of all unknowns. */
  final int count;

  LinkUnknowns(PlacedLinks links, FarBlocks far, LoopWrenches rows) {
    this.links = links;
    this.far = far;
    this.rows = rows;
    hasSpeeds = rows.count() > 0 && hasBalls(links.tree);
    ofLink = hasSpeeds ? SPEED + 6 : SPEED;
    at = new int[links.tree.linkCount + 1];
    for (int link = 0; link < links.tree.linkCount; link++) {
      at[link + 1] = at[link] + ofLink + links.end(link) - links.first(link);
    }
    firstMultiplier = at[links.tree.linkCount];
    count = firstMultiplier + rows.count();
  }

  private static boolean hasBalls(TreeGeometry tree) {
    return IntStream.range(0, tree.linkCount)
        .anyMatch(link -> tree.kind[link] == LinkKind.BALL && !tree.driven[link]);
  }

  /** Returns the index of a velocity. */
  int x(int link, int velocity) {
    return at[link] + ofLink + velocity - links.first(link);
  }

  /** Returns the velocity nearest to an unknown. */
  int velocityOf(int unknown) {
    if (unknown >= firstMultiplier) {
      int[] touched = touched(unknown - firstMultiplier);
      return touched.length == 0 ? 0 : links.first(touched[0]);
    }
    int found = Arrays.binarySearch(at, unknown);
    int link = found >= 0 ? found : -found - 2;
    return Math.min(links.first(link), Math.max(0, links.tree.stateVelocityCount - 1));
  }

  /** Returns the links of a row, with those of its velocities. */
  private int[] touched(int row) {
    return IntStream.concat(
            IntStream.of(rows.links[row]),
            IntStream.of(rows.velocities[row]).map(k -> links.tree.linkOfVelocity[k]))
        .toArray();
  }

  /**
   * Returns the unknowns in an order of least degree of the links; a loop follows its last link.
   */
  int[] order() {
    int[] ofLinks = MinimumDegree.order(SparseLayout.of(neighbours()));
    int[] turn = new int[ofLinks.length];
    for (int i = 0; i < ofLinks.length; i++) {
      turn[ofLinks[i]] = i;
    }
    IntStream.Builder[] unknowns = new IntStream.Builder[ofLinks.length];
    for (int i = 0; i < unknowns.length; i++) {
      unknowns[i] = IntStream.builder();
      IntStream.range(at[ofLinks[i]], at[ofLinks[i] + 1]).forEach(unknowns[i]::add);
    }
    for (int row = 0; row < rows.count(); row++) {
      int last = IntStream.of(touched(row)).map(link -> turn[link]).max().orElse(0);
      unknowns[last].add(firstMultiplier + row);
    }
    return Arrays.stream(unknowns).flatMapToInt(IntStream.Builder::build).toArray();
  }

  /** Returns the links that each link is coupled with by its joint, by forces and by loops. */
  private int[][] neighbours() {
    TreeGeometry tree = links.tree;
    List<SortedSet<Integer>> neighbours = new ArrayList<>();
    for (int link = 0; link < tree.linkCount; link++) {
      neighbours.add(new TreeSet<>());
    }
    for (int link = 0; link < tree.linkCount; link++) {
      if (tree.parent[link] != TreeGeometry.ROOT) {
        neighbours.get(link).add(tree.parent[link]);
      }
    }
    for (int pair = 0; pair < far.count(); pair++) {
      neighbours.get(far.on[pair]).add(far.by[pair]);
    }
    for (int row = 0; row < rows.count(); row++) {
      int[] touched = touched(row);
      for (int link : touched) {
        neighbours.get(link).add(touched[0]);
      }
    }
    return neighbours.stream()
        .map(each -> each.stream().mapToInt(Integer::intValue).toArray())
        .toArray(int[][]::new);
  }
}
