package org.mechservice.sim.scene;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.ForceElement;

/**
 * The reach of the forces of a mechanism through its tree. A force between two bodies needs the way
 * from each to their nearest common ancestor.
 *
 * @param steps links on all ways, those of several ways counted several times
 * @param places pairs of an ancestor and a link on a way from it, each counted once; not more than
 *     {@link #MOST_PLACES}
 * @param links links of the tree
 */
public record ForceReach(long steps, int places, int links) {
  /** Number of places beyond which they are not counted. */
  private static final int MOST_PLACES = 1_000_000;

  /**
   * Number of steps up to which vectors are transformed from link to link. It takes some 25
   * operations for each step, a place 45: below, no mechanism gets so much code that it matters.
   */
  private static final int FEW_STEPS = 2000;

  /** Places for each link that code may compute; data are faster with more. */
  private static final int PLACES_PER_LINK = 4;

  /** Returns those of a mechanism. */
  public static ForceReach of(Mechanism mechanism) {
    TreeGeometry tree = new TreeGeometry(mechanism);
    Set<Long> places = new HashSet<>();
    long steps = 0;
    for (ForceElement force : mechanism.forces()) {
      List<Integer> bodies = force.bodies();
      for (int i = 0; i < bodies.size(); i++) {
        int link = tree.linkOf(bodies.get(i));
        int other =
            bodies.size() == 1 ? TreeGeometry.ROOT : tree.linkOf(bodies.get(i == 0 ? 1 : i - 1));
        int ancestor = tree.commonAncestor(link, other);
        for (int k = link; k != ancestor; k = tree.parent[k]) {
          steps++;
          if (places.size() < MOST_PLACES) {
            places.add((long) (ancestor + 1) * tree.linkCount + k);
          }
        }
      }
    }
    return new ForceReach(steps, places.size(), tree.linkCount);
  }

  /**
   * Returns whether vectors are transformed by places that forces share, which is shorter than to
   * transform each of them from link to link.
   */
  public boolean areShared() {
    return steps > FEW_STEPS && steps > 2L * places;
  }

  /** Returns whether the forces take so many operations as code that data evaluate them sooner. */
  public boolean areTooMany() {
    return Math.min(steps, places) > FEW_STEPS + (long) PLACES_PER_LINK * links;
  }
}
