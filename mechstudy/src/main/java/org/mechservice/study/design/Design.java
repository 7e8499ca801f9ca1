package org.mechservice.study.design;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntFunction;
import org.apache.commons.math3.random.SobolSequenceGenerator;

/** Chooses the points of a study. Thread-safe. */
public interface Design {
  /** Returns how many points there are. */
  int size();

  /**
   * Returns the values of the factors at a point, in their order.
   *
   * @param point its number from 0
   */
  double[] point(int point);

  /**
   * Every combination of the factors' levels; the last factor changes fastest.
   *
   * @throws IllegalArgumentException if there are more than 2^31 - 1
   */
  static Design grid(List<double[]> levels) {
    long size = 1;
    for (double[] each : levels) {
      size *= each.length;
      if (size > Integer.MAX_VALUE) {
        throw new IllegalArgumentException(
            "the grid has more than 2147483647 points; take fewer values, or a design such as"
                + " sobol with a number of points");
      }
    }
    return of((int) size, point -> combination(levels, point));
  }

  private static double[] combination(List<double[]> levels, int point) {
    double[] values = new double[levels.size()];
    int left = point;
    for (int j = values.length - 1; j >= 0; j--) {
      double[] each = levels.get(j);
      values[j] = each[left % each.length];
      left /= each.length;
    }
    return values;
  }

  /**
   * The lists side by side: a point for each place in them.
   *
   * @param lists of equal lengths, one for each factor
   */
  static Design list(List<double[]> lists) {
    return of(
        lists.isEmpty() ? 0 : lists.get(0).length,
        point -> lists.stream().mapToDouble(list -> list[point]).toArray());
  }

  /**
   * Sobol's sequence, from its second point on (the first is the corner of the cube), shifted
   * modulo 1 by the seed (Cranley and Patterson 1976); seed 0 does not shift.
   *
   * @param spreads 1 to 1000
   */
  static Design sobol(List<Spread> spreads, int points, long seed) {
    IntFunction<double[]> sequence = sequence(spreads.size(), seed);
    return of(points, point -> spread(spreads, sequence.apply(point)));
  }

  private static IntFunction<double[]> sequence(int dimension, long seed) {
    double[] shift = new double[dimension];
    for (int j = 0; j < shift.length && seed != 0; j++) {
      shift[j] = Uniform.at(seed, j);
    }
    ThreadLocal<SobolSequenceGenerator> sequence =
        ThreadLocal.withInitial(() -> new SobolSequenceGenerator(dimension));
    return point -> {
      double[] u = sequence.get().skipTo(point + 1);
      for (int j = 0; j < shift.length; j++) {
        double shifted = u[j] + shift[j];
        u[j] = Uniform.inside(shifted >= 1 ? shifted - 1 : shifted);
      }
      return u;
    };
  }

  /**
   * Points for indices of sensitivity: blocks of A, B and, for each factor, A with this factor's
   * value of B. A and B together are a point of Sobol's sequence of twice as many dimensions, as
   * {@link #sobol} takes it.
   *
   * @param spreads 1 to 500
   * @param blocks number of A; there are as many points for each as factors and two
   * @throws IllegalArgumentException if there are more than 2^31 - 1 points
   */
  static Design indices(List<Spread> spreads, int blocks, long seed) {
    int d = spreads.size();
    long size = (long) blocks * (d + 2);
    if (size > Integer.MAX_VALUE) {
      throw new IllegalArgumentException("there are more than 2147483647 points; take fewer");
    }
    IntFunction<double[]> sequence = sequence(2 * d, seed);
    return of(
        (int) size,
        point -> {
          double[] both = sequence.apply(point / (d + 2));
          int place = point % (d + 2);
          double[] u = Arrays.copyOfRange(both, place == 1 ? d : 0, place == 1 ? 2 * d : d);
          if (place >= 2) {
            u[place - 2] = both[d + place - 2];
          }
          return spread(spreads, u);
        });
  }

  /** Independent draws. */
  static Design monteCarlo(List<Spread> spreads, int points, long seed) {
    int d = spreads.size();
    return of(
        points,
        point -> {
          double[] u = new double[d];
          for (int j = 0; j < d; j++) {
            u[j] = Uniform.at(seed, (long) point * d + j);
          }
          return spread(spreads, u);
        });
  }

  /** A Latin hypercube, see {@link LatinHypercube}. */
  static Design latinHypercube(List<Spread> spreads, int points, long seed) {
    LatinHypercube cube = LatinHypercube.of(points, spreads.size(), seed);
    return of(points, point -> spread(spreads, cube.at(point)));
  }

  private static double[] spread(List<Spread> spreads, double[] u) {
    double[] values = new double[u.length];
    for (int j = 0; j < u.length; j++) {
      values[j] = spreads.get(j).at(u[j]);
    }
    return values;
  }

  private static Design of(int size, IntFunction<double[]> points) {
    return new Design() {
      @Override
      public int size() {
        return size;
      }

      @Override
      public double[] point(int point) {
        return points.apply(point);
      }
    };
  }
}
