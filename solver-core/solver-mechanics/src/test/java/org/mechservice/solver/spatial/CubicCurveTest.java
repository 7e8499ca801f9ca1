package org.mechservice.solver.spatial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.expression.Table;
import org.mechservice.solver.expression.TableCurve;

/** The closest point of a curve of cubics against minimisation by brute force. */
class CubicCurveTest {
  static LongStream seeds() {
    return LongStream.rangeClosed(1, 60);
  }

  private static TableCurve road(Random random) {
    List<Double> x = new ArrayList<>();
    List<Double> y = new ArrayList<>();
    double at = 0;
    int points = 2 + random.nextInt(12);
    for (int i = 0; i < points; i++) {
      at += Math.exp(-5 * random.nextDouble());
      x.add(at);
      y.add(0.4 * random.nextGaussian() * random.nextDouble());
    }
    Table table =
        switch (random.nextInt(4)) {
          case 0 -> new Table("road", x, y, Table.Method.LINEAR, Table.Extrapolation.HOLD);
          case 1 -> new Table("road", x, y, Table.Method.AKIMA, Table.Extrapolation.LINEAR);
          case 2 -> new Table("road", x, y, Table.Method.CUBIC, Table.Extrapolation.HOLD);
          default ->
              Table.hermite(
                  "road", x, y, Collections.nCopies(points, 0.0), Table.Extrapolation.HOLD);
        };
    return table.curve();
  }

  private static double distance(TableCurve curve, double s, double x, double z) {
    return Math.hypot(s - x, curve.at(s) - z);
  }

  /** Returns the least distance, of places that become denser about the best ones. */
  private static double least(TableCurve curve, double x, double z, double from, double to) {
    int places = 4000;
    double[] at = new double[places + 1];
    double[] d = new double[places + 1];
    double best = Double.POSITIVE_INFINITY;
    for (int i = 0; i <= places; i++) {
      at[i] = from + (to - from) * i / places;
      d[i] = distance(curve, at[i], x, z);
      best = Math.min(best, d[i]);
    }
    double step = (to - from) / places;
    for (int i = 0; i <= places; i++) {
      boolean valley = (i == 0 || d[i] <= d[i - 1]) && (i == places || d[i] <= d[i + 1]);
      if (valley && d[i] < best + 10 * step) {
        double low = Math.max(from, at[i] - step);
        double high = Math.min(to, at[i] + step);
        for (int k = 0; k < 100; k++) {
          double one = low + (high - low) * 0.382;
          double two = low + (high - low) * 0.618;
          if (distance(curve, one, x, z) < distance(curve, two, x, z)) {
            high = two;
          } else {
            low = one;
          }
        }
        best = Math.min(best, distance(curve, 0.5 * (low + high), x, z));
      }
    }
    for (double knot : curve.knots()) {
      if (knot >= from && knot <= to) {
        best = Math.min(best, distance(curve, knot, x, z));
      }
    }
    return best;
  }

  @MethodSource("seeds")
  @ParameterizedTest
  void distanceIsTheLeastOfAll(long seed) {
    Random random = new Random(seed);
    TableCurve curve = road(random);
    double[] row = curve.row();
    double[] knots = curve.knots();
    double end = knots[knots.length - 1];
    for (int i = 0; i < 60; i++) {
      double x = -0.5 + (end + 1) * random.nextDouble();
      double off = Math.exp(-8 * random.nextDouble()) * (random.nextBoolean() ? 1 : -1);
      double z = curve.at(x) + off;
      double width = Math.abs(off);
      double s = CubicCurve.closest(row, 0, row.length, x, z);
      double expected = least(curve, x, z, x - width, x + width);
      assertThat(Math.abs(s - x)).isLessThanOrEqualTo(width * (1 + 1e-12));
      assertThat(distance(curve, s, x, z))
          .as("seed %d, (%s, %s)", seed, x, z)
          .isLessThan(expected + 1e-12);
    }
  }

  /** Along a straight flight over a road the distance changes by no more than the way. */
  @MethodSource("seeds")
  @ParameterizedTest
  void distanceIsContinuous(long seed) {
    Random random = new Random(seed);
    TableCurve curve = road(random);
    double[] row = curve.row();
    double[] knots = curve.knots();
    double x = -0.5;
    double z = 0.6 * random.nextDouble();
    double step = (knots[knots.length - 1] + 1) / 20_000;
    double before = Double.NaN;
    for (int i = 0; i < 20_000; i++) {
      double s = CubicCurve.closest(row, 0, row.length, x, z);
      double d = distance(curve, s, x, z);
      if (i > 0) {
        assertThat(Math.abs(d - before)).isLessThanOrEqualTo(step * (1 + 1e-9) + 1e-15);
      }
      before = d;
      x += step;
    }
  }

  @Test
  void cornersAreClosestToWhatIsBeforeThem() {
    Table roof =
        new Table(
            "roof",
            List.of(0.0, 1.0, 2.0),
            List.of(0.0, 1.0, 0.0),
            Table.Method.LINEAR,
            Table.Extrapolation.LINEAR);
    double[] row = roof.curve().row();
    assertThat(CubicCurve.closest(row, 0, row.length, 1.1, 1.5)).isEqualTo(1);
    assertThat(CubicCurve.closest(row, 0, row.length, 2.0, 1.0)).isCloseTo(1.5, within(1e-15));
  }

  /** Where a table has no values there is nothing to touch. */
  @Test
  void boundedTableEndsAtItsEnds() {
    Table shelf =
        new Table(
            "shelf",
            List.of(0.0, 1.0),
            List.of(0.0, 0.0),
            Table.Method.LINEAR,
            Table.Extrapolation.ERROR);
    double[] row = shelf.curve().row();
    assertThat(CubicCurve.closest(row, 0, row.length, 0.9, 3)).isEqualTo(0.9);
    assertThat(CubicCurve.closest(row, 0, row.length, 1.5, 0.1)).isEqualTo(1.5);
  }
}
