package org.mechservice.solver.dynamics.derivative;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;

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
  private final LinkCouplings couplings;

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
    couplings = new LinkCouplings(links.tree, far, rows);
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
      int[] touched = couplings.touched(unknown - firstMultiplier);
      return touched.length == 0 ? 0 : links.first(touched[0]);
    }
    int found = Arrays.binarySearch(at, unknown);
    int link = found >= 0 ? found : -found - 2;
    return Math.min(links.first(link), Math.max(0, links.tree.stateVelocityCount - 1));
  }

  /**
   * Returns the unknowns in an order of least degree of the links; a loop follows its last link.
   */
  int[] order() {
    int[] ofLinks = couplings.byLeastDegree();
    IntStream.Builder[] unknowns = new IntStream.Builder[ofLinks.length];
    for (int link : ofLinks) {
      unknowns[link] = IntStream.builder();
      IntStream.range(at[link], at[link + 1]).forEach(unknowns[link]::add);
    }
    int[] last = couplings.lastOfRows(ofLinks);
    for (int row = 0; row < last.length; row++) {
      unknowns[last[row]].add(firstMultiplier + row);
    }
    return IntStream.of(ofLinks).flatMap(link -> unknowns[link].build()).toArray();
  }
}
