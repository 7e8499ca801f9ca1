package org.mechservice.solver.dynamics.tree;

import java.util.stream.IntStream;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;

/**
 * The three columns of each ball joint in matrices over the velocities. For each row x of these
 * columns the class adds a multiple of x and of x [ω]×. Immutable but for scratch; one per thread.
 */
public final class BallColumns {
  private final TreePattern pattern;

  /** First velocity of each ball. */
  private final int[] velocity;

  /**
   * For each ball the descendant rows that hold its columns, as index of the first of the three.
   */
  private final int[][] rows;

  private final double[] from = new double[3];
  private final double[] to = new double[3];

  private BallColumns(TreePattern pattern, int[] velocity) {
    this.pattern = pattern;
    this.velocity = velocity;
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

  /** Returns the columns of all balls. */
  public static BallColumns all(StateCoordinates coordinates, TreePattern pattern) {
    return new BallColumns(
        pattern,
        IntStream.range(0, coordinates.ballCount()).map(coordinates::ballVelocity).toArray());
  }

  /**
   * Returns the columns of the balls whose velocities are in axes that do not turn with the link.
   */
  public static BallColumns inParentAxes(TreeGeometry tree, TreePattern pattern) {
    return new BallColumns(
        pattern,
        links(tree)
            .filter(link -> !tree.inverse[link])
            .map(link -> tree.velocityAt[link])
            .toArray());
  }

  private static IntStream links(TreeGeometry tree) {
    return IntStream.range(0, tree.linkCount)
        .filter(link -> tree.kind[link] == LinkKind.BALL && !tree.driven[link]);
  }

  public int count() {
    return velocity.length;
  }

  public int velocity(int ball) {
    return velocity[ball];
  }

  /**
   * Adds same · x + turned · x [ω]× to the columns of a ball, for x the same columns of a source.
   *
   * @param omega three numbers from {@code at}
   */
  public void add(
      int ball,
      TreeElements target,
      TreeElements source,
      double same,
      double turned,
      double[] omega,
      int at) {
    for (int e : rows[ball]) {
      load(source.lower(), e, e + 1, e + 2);
      combine(same, turned, omega, at);
      store(target.lower(), e, e + 1, e + 2);
    }
    addBefore(ball, target, source, same, turned, omega, at);
    addBlock(ball, target, source, same, turned, omega, at);
  }

  /**
   * Adds in the rows before the ball, where its columns are the upper halves of its own three rows.
   */
  private void addBefore(
      int ball,
      TreeElements target,
      TreeElements source,
      double same,
      double turned,
      double[] omega,
      int at) {
    int place = pattern.placeOf[velocity[ball]];
    int first = pattern.rowStart[place];
    int second = pattern.rowStart[place + 1] - first;
    int third = pattern.rowStart[place + 2] - first;
    for (int e = first; e < first + second; e++) {
      load(source.upper(), e, e + second, e + third);
      combine(same, turned, omega, at);
      store(target.upper(), e, e + second, e + third);
    }
  }

  private void addBlock(
      int ball,
      TreeElements target,
      TreeElements source,
      double same,
      double turned,
      double[] omega,
      int at) {
    int place = pattern.placeOf[velocity[ball]];
    // elements (1, 0), (2, 0), (2, 1) stand last in their rows
    int e10 = pattern.rowStart[place + 2] - 1;
    int e20 = pattern.rowStart[place + 3] - 2;
    int e21 = e20 + 1;
    double[] d = source.diagonal();
    double[] l = source.lower();
    double[] u = source.upper();
    set(d[place], u[e10], u[e20]);
    combine(same, turned, omega, at);
    target.diagonal()[place] += to[0];
    target.upper()[e10] += to[1];
    target.upper()[e20] += to[2];
    set(l[e10], d[place + 1], u[e21]);
    combine(same, turned, omega, at);
    target.lower()[e10] += to[0];
    target.diagonal()[place + 1] += to[1];
    target.upper()[e21] += to[2];
    set(l[e20], l[e21], d[place + 2]);
    combine(same, turned, omega, at);
    target.lower()[e20] += to[0];
    target.lower()[e21] += to[1];
    target.diagonal()[place + 2] += to[2];
  }

  private void load(double[] x, int i0, int i1, int i2) {
    set(x[i0], x[i1], x[i2]);
  }

  private void set(double x0, double x1, double x2) {
    from[0] = x0;
    from[1] = x1;
    from[2] = x2;
  }

  private void store(double[] x, int i0, int i1, int i2) {
    x[i0] += to[0];
    x[i1] += to[1];
    x[i2] += to[2];
  }

  /** (x [ω]×)_c = x_(c+1) ω_(c+2) − x_(c+2) ω_(c+1). */
  private void combine(double same, double turned, double[] omega, int at) {
    double a = omega[at];
    double b = omega[at + 1];
    double c = omega[at + 2];
    to[0] = same * from[0] + turned * (from[1] * c - from[2] * b);
    to[1] = same * from[1] + turned * (from[2] * a - from[0] * c);
    to[2] = same * from[2] + turned * (from[0] * b - from[1] * a);
  }
}
