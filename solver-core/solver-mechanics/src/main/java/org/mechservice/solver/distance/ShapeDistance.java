package org.mechservice.solver.distance;

/**
 * The distance of two convex shapes, both in the same axes, by the method of Gilbert, Johnson and
 * Keerthi (1988): the point of the difference of the cores that is nearest to the origin, as a
 * combination of at most four of its points (Montanari and Petrinic 2018). Workspace of one thread;
 * nothing allocates after construction.
 *
 * <p>Each direction v of the search proves a lower bound: no point of the difference is nearer than
 * its support v·w / |v|. Distances of polytopes are right to rounding, those of round shapes as far
 * as the two bounds meet.
 */
public final class ShapeDistance {
  private static final int MOST_ITERATIONS = 200;

  /** Relative difference of the bounds at which the search ends. */
  private static final double CLOSE = 4 * 0x1p-52;

  /** Distance over the size of the numbers below which cores touch: rounding of their points. */
  private static final double TOUCHING = 16 * 0x1p-52;

  /** Points of the simplex: on A minus on B; on A; on B. */
  private final double[][] w = new double[4][3];

  private final double[][] a = new double[4][3];
  private final double[][] b = new double[4][3];
  private int count;

  /** Weights of the points, and those of a part of them that has been tried. */
  private final double[] weight = new double[4];

  private final double[] tried = new double[4];
  private final double[] best = new double[4];
  private final double[] v = new double[3];
  private final double[] next = new double[3];
  private final double[] onA = new double[3];
  private final double[] onB = new double[3];
  private double distance;
  private double lower;

  /**
   * Finds the distance.
   *
   * @return the distance, m; 0 if the shapes touch or overlap
   */
  public double between(ConvexShape shapeA, ConvexShape shapeB) {
    double margins = shapeA.margin() + shapeB.margin();
    search(shapeA, shapeB);
    double core = Math.sqrt(dot(v, v));
    if (count == 4 || core == 0) {
      core = 0;
      lower = 0;
    }
    points();
    if (core > 0) {
      for (int i = 0; i < 3; i++) {
        onA[i] -= v[i] / core * shapeA.margin();
        onB[i] += v[i] / core * shapeB.margin();
      }
    }
    distance = Math.max(0, core - margins);
    lower = Math.max(0, lower - margins);
    return distance;
  }

  private void search(ConvexShape shapeA, ConvexShape shapeB) {
    count = 0;
    lower = 0;
    double size = 0;
    // any direction begins
    shapeA.support(1, 0, 0, a[0]);
    shapeB.support(-1, 0, 0, b[0]);
    for (int i = 0; i < 3; i++) {
      w[0][i] = a[0][i] - b[0][i];
      v[i] = w[0][i];
    }
    weight[0] = 1;
    count = 1;
    for (int iteration = 0; iteration < MOST_ITERATIONS; iteration++) {
      double square = dot(v, v);
      for (int i = 0; i < count; i++) {
        size = Math.max(size, Math.max(dot(a[i], a[i]), dot(b[i], b[i])));
      }
      if (square <= TOUCHING * TOUCHING * size) {
        v[0] = 0;
        v[1] = 0;
        v[2] = 0;
        return;
      }
      shapeA.support(-v[0], -v[1], -v[2], a[count]);
      shapeB.support(v[0], v[1], v[2], b[count]);
      for (int i = 0; i < 3; i++) {
        w[count][i] = a[count][i] - b[count][i];
      }
      double reached = dot(v, w[count]);
      lower = Math.max(lower, reached / Math.sqrt(square));
      if (square - reached <= CLOSE * square || isKnown()) {
        return;
      }
      count++;
      if (count == 4 && containsOrigin()) {
        return;
      }
      nearest();
      combine(best, next);
      if (!(dot(next, next) < square)) {
        count--; // rounding lets it come no nearer: the former combination stays
        return;
      }
      keep();
    }
  }

  /** Returns whether the new point is one of the simplex already. */
  private boolean isKnown() {
    for (int i = 0; i < count; i++) {
      if (w[i][0] == w[count][0] && w[i][1] == w[count][1] && w[i][2] == w[count][2]) {
        return true;
      }
    }
    return false;
  }

  /** Takes over the best weights, and drops points without any. */
  private void keep() {
    int kept = 0;
    for (int i = 0; i < count; i++) {
      if (best[i] > 0) {
        swap(w, kept, i);
        swap(a, kept, i);
        swap(b, kept, i);
        weight[kept] = best[i];
        kept++;
      }
    }
    count = kept;
    System.arraycopy(next, 0, v, 0, 3);
  }

  private static void swap(double[][] points, int i, int j) {
    double[] point = points[i];
    points[i] = points[j];
    points[j] = point;
  }

  /** Returns whether the origin is in the tetrahedron; its weights are then taken. */
  private boolean containsOrigin() {
    double whole = 0;
    for (int i = 0; i < 4; i++) {
      int j = (i + 1) % 4;
      int k = (i + 2) % 4;
      int l = (i + 3) % 4;
      // volume of the origin and the face opposite to i; neighbours in the cycle change its sign
      double volume = volume(w[j], w[k], w[l]);
      tried[i] = i % 2 == 0 ? volume : -volume;
      whole += tried[i];
    }
    for (int i = 0; i < 4; i++) {
      if (!(tried[i] * whole > 0)) {
        return false;
      }
    }
    for (int i = 0; i < 4; i++) {
      weight[i] = tried[i] / whole;
    }
    return true;
  }

  private static double volume(double[] p, double[] q, double[] r) {
    return p[0] * (q[1] * r[2] - q[2] * r[1])
        + p[1] * (q[2] * r[0] - q[0] * r[2])
        + p[2] * (q[0] * r[1] - q[1] * r[0]);
  }

  /** Finds the combination nearest to the origin among those of the faces and edges. */
  private void nearest() {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < count; i++) {
      clear();
      tried[i] = 1;
      least = better(least);
      for (int j = i + 1; j < count; j++) {
        if (edge(i, j)) {
          least = better(least);
        }
        for (int k = j + 1; k < count; k++) {
          if (face(i, j, k)) {
            least = better(least);
          }
        }
      }
    }
  }

  private void clear() {
    for (int i = 0; i < 4; i++) {
      tried[i] = 0;
    }
  }

  private double better(double least) {
    combine(tried, next);
    double square = dot(next, next);
    if (square < least) {
      System.arraycopy(tried, 0, best, 0, 4);
      return square;
    }
    return least;
  }

  /** Weights of the foot of the origin on an edge; returns whether it is inside. */
  private boolean edge(int i, int j) {
    double along = 0;
    double square = 0;
    for (int c = 0; c < 3; c++) {
      double side = w[j][c] - w[i][c];
      along -= w[i][c] * side;
      square += side * side;
    }
    clear();
    if (!(along > 0) || !(along < square)) {
      return false;
    }
    tried[j] = along / square;
    tried[i] = 1 - tried[j];
    return true;
  }

  /**
   * Weights of the foot of the origin on a triangle: areas of its projection on the coordinate
   * plane in which it is largest. Returns whether the foot is inside.
   */
  private boolean face(int i, int j, int k) {
    double[] p = w[i];
    double[] q = w[j];
    double[] r = w[k];
    double nx = (q[1] - p[1]) * (r[2] - p[2]) - (q[2] - p[2]) * (r[1] - p[1]);
    double ny = (q[2] - p[2]) * (r[0] - p[0]) - (q[0] - p[0]) * (r[2] - p[2]);
    double nz = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    double square = nx * nx + ny * ny + nz * nz;
    if (!(square > 0)) {
      return false;
    }
    double height = (p[0] * nx + p[1] * ny + p[2] * nz) / square;
    double ax = Math.abs(nx);
    double ay = Math.abs(ny);
    double az = Math.abs(nz);
    int c = ax >= ay && ax >= az ? 1 : ay >= az ? 2 : 0;
    int d = (c + 1) % 3;
    double fc = height * (c == 0 ? nx : c == 1 ? ny : nz);
    double fd = height * (d == 0 ? nx : d == 1 ? ny : nz);
    clear();
    double ofI = area(q, r, c, d, fc, fd);
    double ofJ = area(r, p, c, d, fc, fd);
    double ofK = area(p, q, c, d, fc, fd);
    // not the whole area, which slivers know badly: the weights must add up to one
    double sum = ofI + ofJ + ofK;
    tried[i] = ofI / sum;
    tried[j] = ofJ / sum;
    tried[k] = ofK / sum;
    return tried[i] > 0 && tried[j] > 0 && tried[k] > 0;
  }

  private static double area(double[] p, double[] q, int c, int d, double fc, double fd) {
    return (p[c] - fc) * (q[d] - fd) - (p[d] - fd) * (q[c] - fc);
  }

  private void combine(double[] weights, double[] sum) {
    sum[0] = 0;
    sum[1] = 0;
    sum[2] = 0;
    for (int i = 0; i < count; i++) {
      for (int c = 0; c < 3; c++) {
        sum[c] += weights[i] * w[i][c];
      }
    }
  }

  private void points() {
    for (int c = 0; c < 3; c++) {
      onA[c] = 0;
      onB[c] = 0;
      for (int i = 0; i < count; i++) {
        onA[c] += weight[i] * a[i][c];
        onB[c] += weight[i] * b[i][c];
      }
    }
  }

  private static double dot(double[] p, double[] q) {
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  }

  /** Returns a proved lower bound of the distance found last, m, up to rounding. */
  public double lowerBound() {
    return lower;
  }

  /**
   * Writes the points nearest to each other, which are the same up to rounding where shapes touch.
   */
  public void nearestPoints(double[] pointA, double[] pointB) {
    System.arraycopy(onA, 0, pointA, 0, 3);
    System.arraycopy(onB, 0, pointB, 0, 3);
  }
}
