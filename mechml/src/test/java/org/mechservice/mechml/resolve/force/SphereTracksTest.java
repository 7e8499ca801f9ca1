package org.mechservice.mechml.resolve.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Table;
import org.mechservice.solver.expression.TableCurve;
import org.mechservice.solver.symbol.MathFunction;

/** The curves of a sphere's centre over a profile, against spheres that are set down on it. */
@Tag("slow")
class SphereTracksTest {
  private static final double RADIUS = 0.3;

  static LongStream seeds() {
    return LongStream.rangeClosed(1, 40);
  }

  /** A road of steps, ramps and hollows of all widths: smooth, Akima or of straight lines. */
  private static Expression road(Random random) {
    List<Double> x = new ArrayList<>();
    List<Double> y = new ArrayList<>();
    double at = 0;
    int points = 2 + random.nextInt(8);
    for (int i = 0; i < points; i++) {
      at += Math.exp(-4 * random.nextDouble());
      x.add(at);
      y.add(0.3 * random.nextGaussian() * random.nextDouble());
    }
    Table table =
        switch (random.nextInt(3)) {
          case 0 -> new Table("road", x, y, Table.Method.LINEAR, Table.Extrapolation.HOLD);
          case 1 -> new Table("road", x, y, Table.Method.AKIMA, Table.Extrapolation.HOLD);
          default ->
              Table.hermite(
                  "road", x, y, Collections.nCopies(points, 0.0), Table.Extrapolation.HOLD);
        };
    return new Expression.TableValue(table, List.of(new Expression.Argument()));
  }

  private static List<TableCurve> tracks(HeightPieces pieces) {
    return SphereTracks.of(pieces, RADIUS).stream()
        .map(track -> track.table("track").curve())
        .toList();
  }

  /** Returns how high the centre of the sphere is while it touches, from many places of touch. */
  private static double height(HeightPieces pieces, double x) {
    double highest = Double.NEGATIVE_INFINITY;
    int places = 20_000;
    for (int i = 0; i <= places; i++) {
      double way = RADIUS * (2.0 * i / places - 1);
      double up = Math.sqrt(Math.max(0, RADIUS * RADIUS - way * way));
      highest = Math.max(highest, pieces.value(x + way) + up);
    }
    for (double s : pieces.breaks()) {
      double way = s - x;
      if (Math.abs(way) <= RADIUS) {
        highest = Math.max(highest, pieces.value(s) + Math.sqrt(RADIUS * RADIUS - way * way));
      }
    }
    return highest;
  }

  /**
   * The highest track is where the sphere lies. Places of touch 3e-5 m apart miss the highest by
   * 3e-5 squared times the curvature of the surface, 2e-6 m for the sharpest roads; beside a wall
   * the height falls by the slope times the cubic's error across.
   */
  @MethodSource("seeds")
  @ParameterizedTest
  void highestTrackIsWhereTheSphereLies(long seed) {
    Random random = new Random(seed);
    HeightPieces pieces = HeightPieces.of(road(random)).orElseThrow();
    List<TableCurve> tracks = tracks(pieces);
    assertThat(tracks).isNotEmpty();
    double[] breaks = pieces.breaks();
    double from = breaks[0] - 1;
    double to = breaks[breaks.length - 1] + 1;
    for (int i = 0; i <= 200; i++) {
      double x = from + (to - from) * i / 200;
      double highest = tracks.stream().mapToDouble(track -> track.at(x)).max().orElseThrow();
      assertThat(highest).as("seed %d, x = %s", seed, x).isCloseTo(height(pieces, x), within(2e-5));
    }
  }

  /** Where two tracks cross at the height of the sphere it touches twice. */
  @Test
  void ditchHasTwoSides() {
    Table table =
        Table.hermite(
            "ditch",
            List.of(-0.051, -0.05, 0.05, 0.051),
            List.of(0.0, -0.2, -0.2, 0.0),
            Collections.nCopies(4, 0.0),
            Table.Extrapolation.HOLD);
    Expression road = new Expression.TableValue(table, List.of(new Expression.Argument()));
    List<TableCurve> tracks = tracks(HeightPieces.of(road).orElseThrow());
    double expected = Math.sqrt(RADIUS * RADIUS - 0.051 * 0.051);
    assertThat(tracks.stream().filter(track -> Math.abs(track.at(0) - expected) < 1e-6)).hasSize(2);
  }

  /**
   * A kerb of straight lines: on the floor, and on an arc of the sphere's radius about its edge.
   */
  @Test
  void kerbIsClimbedOnAnArc() {
    Table table =
        new Table(
            "kerb",
            List.of(0.0, 1.0, 1.001, 2.0),
            List.of(0.0, 0.0, 0.1, 0.1),
            Table.Method.LINEAR,
            Table.Extrapolation.HOLD);
    Expression road = new Expression.TableValue(table, List.of(new Expression.Argument()));
    List<TableCurve> tracks = tracks(HeightPieces.of(road).orElseThrow());
    for (double x = 0.8; x < 1; x += 0.013) {
      double place = x;
      double arc = 0.1 + Math.sqrt(RADIUS * RADIUS - (1.001 - x) * (1.001 - x));
      double expected = Math.max(RADIUS, arc);
      assertThat(tracks.stream().mapToDouble(track -> track.at(place)).max().orElseThrow())
          .isCloseTo(expected, within(1e-6));
    }
  }

  @Test
  void heightWithASineHasNoPieces() {
    Expression wave = Expression.call(MathFunction.SIN, List.of(new Expression.Argument()));
    assertThat(HeightPieces.of(wave)).isEmpty();
    assertThat(HeightPieces.of(new Expression.Sum(wave, road(new Random(1))))).isEmpty();
  }
}
