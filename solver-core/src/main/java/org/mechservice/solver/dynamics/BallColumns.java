package org.mechservice.solver.dynamics;

import java.util.stream.IntStream;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * What the derivatives of balls need beyond those of other links, because their velocities are
 * given in axes that do not turn with the link. Immutable.
 *
 * <p>If F holds for columns in the axes of the link, with ω' and M in the axes of the parent, then
 * turning the ball by δ changes the velocities in link axes by Rᵀ (ω × δ), the accelerations by Rᵀ
 * (ω' × δ), and the forces of the ball itself, seen from the parent, by δ × F: so the columns get
 * ∂F/∂v [ω]× + M [ω']×, and the rows of the ball −[F]×.
 */
final class BallColumns {
  private final TreePattern pattern;

  /** First velocity of each ball that turns its link relative to the parent. */
  private final int[] velocity;

  /** For each of them the rows of other places that hold its columns, as index of the first. */
  private final int[][] rows;

  BallColumns(TreeGeometry tree, TreePattern pattern) {
    this.pattern = pattern;
    velocity =
        IntStream.range(0, tree.linkCount)
            .filter(link -> tree.kind[link] == LinkKind.BALL && !tree.inverse[link])
            .map(link -> tree.velocityAt[link])
            .toArray();
    rows = new int[velocity.length][];
    for (int b = 0; b < velocity.length; b++) {
      int place = pattern.placeOf[velocity[b]];
      rows[b] =
          IntStream.range(place + 3, pattern.size)
              .map(row -> pattern.find(row, place))
              .filter(element -> element >= 0)
              .toArray();
    }
  }

  /**
   * Completes ∂F/∂q.
   *
   * @param force F without applied joint forces, one per extended velocity; not modified
   */
  void finish(
      TreeMotion motion,
      double[] force,
      TreeMatrix mass,
      TreeSquare byVelocity,
      TreeSquare byPosition) {
    for (int b = 0; b < velocity.length; b++) {
      int k = velocity[b];
      for (int e : rows[b]) {
        addTurned(byPosition.lower, e, byVelocity.lower, e, motion.v, k);
        addTurned(byPosition.lower, e, mass.lower(), e, motion.a, k);
      }
      finishAncestors(motion, k, mass, byVelocity, byPosition);
      finishBlock(motion, k, force, mass, byVelocity, byPosition);
    }
  }

  /** row += other row · [x]×, of three numbers each. */
  private static void addTurned(
      double[] row, int at, double[] other, int otherAt, double[] x, int ix) {
    double a = other[otherAt];
    double b = other[otherAt + 1];
    double c = other[otherAt + 2];
    row[at] += b * x[ix + 2] - c * x[ix + 1];
    row[at + 1] += c * x[ix] - a * x[ix + 2];
    row[at + 2] += a * x[ix + 1] - b * x[ix];
  }

  /** The columns of the ball in the rows of smaller places stand in three rows of the pattern. */
  private void finishAncestors(
      TreeMotion motion, int k, TreeMatrix mass, TreeSquare byVelocity, TreeSquare byPosition) {
    int place = pattern.placeOf[k];
    int first = pattern.rowStart[place];
    int count = pattern.rowStart[place + 1] - first;
    int second = pattern.rowStart[place + 1];
    int third = pattern.rowStart[place + 2];
    for (int i = 0; i < count; i++) {
      addTurned(byPosition.upper, byVelocity.upper, motion.v, k, first + i, second + i, third + i);
      addTurned(byPosition.upper, mass.lower(), motion.a, k, first + i, second + i, third + i);
    }
  }

  private static void addTurned(
      double[] row, double[] other, double[] x, int ix, int at0, int at1, int at2) {
    double a = other[at0];
    double b = other[at1];
    double c = other[at2];
    row[at0] += b * x[ix + 2] - c * x[ix + 1];
    row[at1] += c * x[ix] - a * x[ix + 2];
    row[at2] += a * x[ix + 1] - b * x[ix];
  }

  private void finishBlock(
      TreeMotion motion,
      int k,
      double[] force,
      TreeMatrix mass,
      TreeSquare byVelocity,
      TreeSquare byPosition) {
    for (int r = 0; r < 3; r++) {
      for (int c = 0; c < 3; c++) {
        int c1 = (c + 1) % 3;
        int c2 = (c + 2) % 3;
        // (row · [x]×)_c = row_(c+1) x_(c+2) − row_(c+2) x_(c+1)
        double turned =
            byVelocity.get(k + r, k + c1) * motion.v[k + c2]
                - byVelocity.get(k + r, k + c2) * motion.v[k + c1]
                + mass.get(k + r, k + c1) * motion.a[k + c2]
                - mass.get(k + r, k + c2) * motion.a[k + c1];
        byPosition.add(k + r, k + c, turned);
      }
    }
    for (int c = 0; c < 3; c++) {
      // −[F]×: element (c+1, c+2) of [F]× is −F_c
      int c1 = (c + 1) % 3;
      int c2 = (c + 2) % 3;
      byPosition.add(k + c1, k + c2, force[k + c]);
      byPosition.add(k + c2, k + c1, -force[k + c]);
    }
  }
}
