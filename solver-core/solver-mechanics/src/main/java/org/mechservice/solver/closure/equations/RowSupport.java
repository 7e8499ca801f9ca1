package org.mechservice.solver.closure.equations;

import java.util.BitSet;
import org.mechservice.solver.kinematics.TreeGeometry;

/**
 * The links and velocities that a loop equation depends on. Immutable; callers must not write to
 * the arrays.
 */
public final class RowSupport {
  private final int[] ways;
  private final int[] loaded;
  private final int[] velocities;

  RowSupport(BitSet ways, BitSet loaded, BitSet velocities) {
    this.ways = ways.stream().toArray();
    this.loaded = loaded.stream().toArray();
    this.velocities = velocities.stream().toArray();
  }

  /**
   * Returns the support of an equation between points of two links.
   *
   * @param one a link, or {@link TreeGeometry#ROOT}
   * @param other likewise
   */
  public static RowSupport between(int one, int other) {
    BitSet links = new BitSet();
    for (int link : new int[] {one, other}) {
      if (link != TreeGeometry.ROOT) {
        links.set(link);
      }
    }
    return new RowSupport(links, links, new BitSet());
  }

  /** Returns the links whose joints it depends on, ascending. */
  public int[] ways() {
    return ways;
  }

  /** Returns the links on which its multiplier exerts a wrench, ascending, without the root. */
  public int[] loaded() {
    return loaded;
  }

  /** Returns the extended velocities on which its multiplier exerts a force, ascending. */
  public int[] velocities() {
    return velocities;
  }
}
