package org.mechservice.solver.closure;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.mechservice.solver.closure.equations.RowSupport;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.linear.SparseSymmetric;

/**
 * Elimination order of the loop equations in the tree. An equation is open from the links that it
 * depends on inwards to its <i>home</i>, the outermost link that all its paths to the root share.
 * It is eliminated at its home, outermost homes first; equations at home on the root follow in
 * order of least degree.
 *
 * <p>The front of a link holds the equations that are open in a link outside it, those with their
 * home at this link first. Immutable.
 */
final class LoopFronts {
  /** Matrix of the multipliers, one row per equation, in the order of elimination. */
  final SparseSymmetric matrix;

  /** First entry of each link's front, and the first entry whose home is not this link. */
  final int[] start;

  final int[] open;

  /** Position of each entry's equation in the order of elimination. */
  final int[] place;

  /** Entry of the same equation in the front of the parent, or -1. */
  final int[] inParent;

  /** For each equation the extended velocities on which it exerts a force. */
  final int[][] velocities;

  /**
   * Velocities of the state among them, and the entries in the fronts of their links, counted from
   * the first that is open.
   */
  final int[][] pushed;

  final int[][] pushedEntry;

  private final int[] parent;
  private final int[] home;

  /**
   * @param parent of each link, with a lower index, or the root
   * @param linkOfVelocity the link that each velocity of the state moves
   * @param support what each equation depends on, with links as in {@code parent}
   */
  LoopFronts(int[] parent, int[] linkOfVelocity, RowSupport[] support) {
    this.parent = parent;
    int links = parent.length;
    int count = support.length;
    home = new int[count];
    Arrays.setAll(home, i -> home(support[i]));
    List<List<Integer>> through = new ArrayList<>();
    List<List<Integer>> atHome = new ArrayList<>();
    for (int link = 0; link < links; link++) {
      through.add(new ArrayList<>());
      atHome.add(new ArrayList<>());
    }
    for (int i = 0; i < count; i++) {
      if (home[i] != TreeGeometry.ROOT) {
        atHome.get(home[i]).add(i);
      }
      for (int link : linksThrough(support[i], home[i])) {
        through.get(link).add(i);
      }
    }
    List<int[]> cliques = new ArrayList<>();
    through.forEach(list -> cliques.add(list.stream().mapToInt(Integer::intValue).toArray()));
    int[] first =
        IntStream.range(0, count)
            .filter(i -> home[i] != TreeGeometry.ROOT)
            .boxed()
            .sorted(Comparator.comparing((Integer i) -> -home[i]))
            .mapToInt(Integer::intValue)
            .toArray();
    matrix = new SparseSymmetric(count, cliques, first);
    start = new int[links + 1];
    open = new int[links];
    int[][] front = new int[links][];
    for (int link = 0; link < links; link++) {
      int[] here = atHome.get(link).stream().mapToInt(Integer::intValue).toArray();
      front[link] =
          IntStream.concat(Arrays.stream(here), Arrays.stream(cliques.get(link)))
              .map(matrix::placeOf)
              .sorted()
              .toArray();
      start[link + 1] = start[link] + front[link].length;
      open[link] = start[link] + here.length;
    }
    place = Arrays.stream(front).flatMapToInt(Arrays::stream).toArray();
    inParent = new int[place.length];
    for (int link = 0; link < links; link++) {
      for (int e = start[link]; e < start[link + 1]; e++) {
        boolean ends = e < open[link] || parent[link] == TreeGeometry.ROOT;
        inParent[e] = ends ? -1 : entry(parent[link], place[e]);
      }
    }
    velocities = new int[count][];
    pushed = new int[count][];
    pushedEntry = new int[count][];
    for (int i = 0; i < count; i++) {
      int at = matrix.placeOf(i);
      velocities[i] = support[i].velocities();
      pushed[i] =
          Arrays.stream(support[i].velocities()).filter(k -> k < linkOfVelocity.length).toArray();
      pushedEntry[i] =
          Arrays.stream(pushed[i])
              .map(k -> entry(linkOfVelocity[k], at) - open[linkOfVelocity[k]])
              .toArray();
    }
  }

  /** Returns the entry of an equation in the front of a link on which it acts, or −1. */
  int loadedEntry(int equation, int link) {
    return link == TreeGeometry.ROOT ? -1 : entry(link, matrix.placeOf(equation));
  }

  /** Returns whether the home of the equation at a position of the order is the root. */
  boolean isAtHomeOnRoot(int ofPlace) {
    return home[matrix.rowAt(ofPlace)] == TreeGeometry.ROOT;
  }

  private int home(RowSupport support) {
    int home = Integer.MIN_VALUE;
    for (int link : support.ways()) {
      int inner = parent[link];
      home = home == Integer.MIN_VALUE ? inner : commonAncestor(home, inner);
    }
    return home == Integer.MIN_VALUE ? TreeGeometry.ROOT : home;
  }

  /** Parents have lower indices than their children, and the root the lowest. */
  private int commonAncestor(int one, int other) {
    int a = one;
    int b = other;
    while (a != b) {
      if (a > b) {
        a = parent[a];
      } else {
        b = parent[b];
      }
    }
    return a;
  }

  private int[] linksThrough(RowSupport support, int home) {
    BitSet links = new BitSet();
    for (int[] group : new int[][] {support.ways(), support.loaded()}) {
      for (int from : group) {
        for (int link = from; link > home && !links.get(link); link = parent[link]) {
          links.set(link);
        }
      }
    }
    return links.stream().toArray();
  }

  /** Returns the entry of an equation in a front, or -1 if it is not there. */
  private int entry(int link, int ofPlace) {
    for (int e = start[link]; e < start[link + 1]; e++) {
      if (place[e] == ofPlace) {
        return e;
      }
    }
    return -1;
  }
}
