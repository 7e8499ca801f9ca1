package org.mechservice.solver.closure.equations;

import java.util.Arrays;
import java.util.BitSet;
import java.util.function.IntUnaryOperator;
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

  /**
   * Returns the same for links of another numbering.
   *
   * @param way the link whose joint is that of a link, or {@link TreeGeometry#ROOT} for none
   * @param carrier the link that carries a link, or {@link TreeGeometry#ROOT}
   */
  public RowSupport of(IntUnaryOperator way, IntUnaryOperator carrier) {
    return new RowSupport(
        among(ways, way),
        among(loaded, carrier),
        Arrays.stream(velocities).collect(BitSet::new, BitSet::set, BitSet::or));
  }

  private static BitSet among(int[] links, IntUnaryOperator other) {
    BitSet found = new BitSet();
    for (int link : links) {
      int is = other.applyAsInt(link);
      if (is != TreeGeometry.ROOT) {
        found.set(is);
      }
    }
    return found;
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
