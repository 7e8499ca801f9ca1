package org.mechservice.study.design;

/**
 * A Latin hypercube: each factor's interval is cut into as many strips as there are points, and
 * each strip holds one point, at a random place in it. Up to {@value #MOST_COMPARED} points the one
 * of {@value #TRIES} hypercubes whose nearest points are farthest apart (maximin) is taken.
 */
final class LatinHypercube {
  private static final int MOST_COMPARED = 1000;
  private static final int TRIES = 20;

  private final int[][] strips;
  private final long seed;

  private LatinHypercube(int points, int factors, long seed) {
    this.seed = seed;
    strips = new int[factors][points];
    for (int j = 0; j < factors; j++) {
      for (int i = 0; i < points; i++) {
        int other = (int) (Uniform.at(seed, place(points, j, i)) * (i + 1));
        strips[j][i] = strips[j][other];
        strips[j][other] = i;
      }
    }
  }

  private static long place(int points, int factor, int point) {
    return (long) factor * points + point;
  }

  static LatinHypercube of(int points, int factors, long seed) {
    LatinHypercube best = new LatinHypercube(points, factors, seed);
    if (points > MOST_COMPARED || factors < 2) {
      return best;
    }
    double widest = best.nearest();
    for (int i = 1; i < TRIES; i++) {
      LatinHypercube other = new LatinHypercube(points, factors, seed + i * 0x632be59bd9b4e019L);
      double distance = other.nearest();
      if (distance > widest) {
        widest = distance;
        best = other;
      }
    }
    return best;
  }

  /** Returns the square of the distance of its nearest points, in strips. */
  private double nearest() {
    double nearest = Double.POSITIVE_INFINITY;
    for (int a = 0; a < strips[0].length; a++) {
      for (int b = 0; b < a; b++) {
        double square = 0;
        for (int[] factor : strips) {
          double apart = factor[a] - factor[b];
          square += apart * apart;
        }
        nearest = Math.min(nearest, square);
      }
    }
    return nearest;
  }

  /** Returns a point of the unit cube. */
  double[] at(int point) {
    double[] u = new double[strips.length];
    int points = strips[0].length;
    for (int j = 0; j < u.length; j++) {
      double within = Uniform.at(~seed, place(points, j, point));
      u[j] = Uniform.inside((strips[j][point] + within) / points);
    }
    return u;
  }
}
