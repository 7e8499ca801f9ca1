package org.mechservice.solver.distance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A body that turns about z, a turn a second, beside one at rest. */
class ClearanceTest {
  private static final double TURN = 2 * Math.PI;

  private double[] times = {};
  private double[][] still = {};
  private double[][] turning = {};

  private void rows(int count, double begin) {
    times = new double[count + 1];
    still = new double[count + 1][];
    turning = new double[count + 1][];
    for (int i = 0; i <= count; i++) {
      times[i] = (double) i / count;
      still[i] = pose(0, 0);
      turning[i] = pose(begin + TURN * times[i], TURN);
    }
  }

  private static double[] pose(double angle, double speed) {
    return new double[] {
      0, 0, 0, Math.cos(angle / 2), 0, 0, Math.sin(angle / 2), 0, 0, 0, 0, 0, speed
    };
  }

  private static SolidPart pin(double radius) {
    return SolidPart.ball(new double[] {0.1, 0, 0}, radius);
  }

  private static double least(double[] distances) {
    return Arrays.stream(distances).min().orElseThrow();
  }

  /**
   * Of 12, 36 and 72 rows a turn none is near the passage. A Hermite curve misses a circle of
   * radius R by R h⁴/384 in the middle of an angle h.
   */
  @ParameterizedTest
  @ValueSource(ints = {12, 36, 72})
  void passageBetweenRowsIsFoundWithItsBound(int count) {
    rows(count, 0.02);
    double gap = 1.001464e-3;
    List<SolidPart> post = List.of(SolidPart.ball(new double[] {0, 0.11 + gap, 0}, 0.005));
    Clearance clearance = new Clearance(post, List.of(pin(0.005)));
    Clearance.Result result = clearance.along(times, still, turning, 1e-8);
    double curve = 0.1 * Math.pow(TURN / count, 4) / 384;
    assertThat(result.least()).isCloseTo(gap, within(1.1 * curve + 1e-8));
    assertThat(result.proved()).isBetween(result.least() - 1e-8, result.least());
    assertThat(result.time()).isCloseTo((Math.PI / 2 - 0.02) / TURN, within(1e-3));
    assertThat(least(clearance.atRows(times, still, turning))).isGreaterThan(result.least());
    assertThat(result.onA()[1]).isCloseTo(0.105 + gap, within(1e-5));
    assertThat(result.onB()[1]).isCloseTo(0.105, within(1e-4));
  }

  /** Whatever the accuracy: pieces of the time that were left out early have bounds, too. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 1e-4, 1e-5, 1e-6})
  void boundHoldsAtEveryAccuracy(double accuracy) {
    for (double begin = 0; begin < 0.2; begin += 0.013) {
      rows(36, begin);
      double gap = 1e-3;
      List<SolidPart> post = List.of(SolidPart.ball(new double[] {0, 0.11 + gap, 0}, 0.005));
      Clearance.Result result =
          new Clearance(post, List.of(pin(0.005))).along(times, still, turning, accuracy);
      double curve = 0.1 * Math.pow(TURN / 36, 4) / 384;
      assertThat(result.proved()).isLessThanOrEqualTo(gap + curve);
      assertThat(result.least()).isGreaterThanOrEqualTo(gap - curve);
      assertThat(result.least() - result.proved()).isLessThanOrEqualTo(accuracy * (1 + 1e-9));
    }
  }

  @Test
  void hitThatAllRowsStepOverIsFound() {
    rows(36, Math.PI / 36);
    List<SolidPart> pin = List.of(SolidPart.ball(new double[] {0, 0.1, 0}, 0.0006));
    List<SolidPart> blade =
        List.of(SolidPart.box(new double[] {0.1, 0, 0}, new double[] {0.02, 0.0005, 0.01}));
    Clearance clearance = new Clearance(pin, blade);
    assertThat(least(clearance.atRows(times, still, turning))).isGreaterThan(7e-3);
    Clearance.Result result = clearance.along(times, still, turning, 1e-6);
    assertThat(result.least()).isZero();
    assertThat(result.proved()).isZero();
    assertThat(result.time()).isCloseTo((Math.PI / 2 - Math.PI / 36) / TURN, within(2e-3));
  }

  /** The gap is the same at all times: no part of the time can be left out before it is bounded. */
  @Test
  void pinInABoreKeepsItsGapUpToFacets() {
    rows(72, 0);
    double[] from = {0, 0, -0.01};
    double[] to = {0, 0, 0.01};
    Clearance clearance =
        new Clearance(
            SolidPart.tube(from, to, 0.02, 0.02, 0.011, 1e-5),
            List.of(
                SolidPart.frustum(
                    new double[] {0, 0, -0.03}, new double[] {0, 0, 0.03}, 0.01, 0.01, 1e-5)));
    Clearance.Result result = clearance.along(times, still, turning, 1e-5);
    assertThat(result.band()).isBetween(1e-6, 2e-5);
    assertThat(result.least()).isCloseTo(1e-3, within(2e-5));
    assertThat(result.proved()).isBetween(1e-3 - 5e-5, 1e-3);
  }

  /** A plate slides along another at a distance of 1 mm. */
  @Test
  void platesThatSlideAlongEachOtherAreBounded() {
    rows(20, 0);
    for (int i = 0; i < times.length; i++) {
      turning[i] = pose(0, 0);
      turning[i][0] = times[i];
      turning[i][7] = 1;
    }
    List<SolidPart> low =
        List.of(SolidPart.box(new double[] {0, 0, -0.005}, new double[] {3, 1, 0.01}));
    List<SolidPart> high =
        List.of(SolidPart.box(new double[] {0, 0, 0.006}, new double[] {0.2, 0.2, 0.01}));
    Clearance.Result result = new Clearance(low, high).along(times, still, turning, 1e-7);
    assertThat(result.least()).isCloseTo(1e-3, within(1e-15));
    assertThat(result.proved()).isCloseTo(1e-3, within(1e-7));
    assertThat(result.examined()).isLessThan(200);
  }

  /** Triangles of a wall, one of which a pin passes. */
  @Test
  void surfaceIsSearchedBySubdivision() {
    rows(36, 0.01);
    List<SolidPart> wall = new ArrayList<>();
    for (int i = -50; i < 50; i++) {
      for (int k = -50; k < 50; k++) {
        double x = 0.01 * i;
        double z = 0.01 * k;
        wall.add(SolidPart.hull(x, 0.12, z, x + 0.01, 0.12, z, x, 0.12, z + 0.01));
        wall.add(SolidPart.hull(x + 0.01, 0.12, z, x + 0.01, 0.12, z + 0.01, x, 0.12, z + 0.01));
      }
    }
    Clearance.Result result =
        new Clearance(wall, List.of(pin(0.004))).along(times, still, turning, 1e-7);
    // the curve leaves the circle by 0.1 h⁴/384 = 2.4e-7
    assertThat(result.least()).isCloseTo(0.016, within(4e-7));
    assertThat(result.examined()).isLessThan(20_000);
  }

  @Test
  void rowsTellHowWellTheyKnowWhatLiesBetween() {
    rows(36, 0);
    // every second row: R h⁴/384 with h = 2π/18
    double expected = 0.1 * Math.pow(TURN / 18, 4) / 384;
    List<SolidPart> point = List.of(SolidPart.ball(new double[] {0.1, 0, 0}, 0));
    assertThat(RowPaths.missed(times, still, turning, point))
        .isCloseTo(expected, within(0.05 * expected));
    rows(72, 0);
    assertThat(RowPaths.missed(times, still, turning, point))
        .isCloseTo(expected / 16, within(0.05 * expected / 16));
  }

  /**
   * A small body that spins sees a post that is far away turn around it: the rows know that less.
   */
  @Test
  void rowsOfAPairAreJudgedByTheirRelativeMotion() {
    rows(18, 0.05);
    List<SolidPart> spinner =
        List.of(SolidPart.box(new double[3], new double[] {0.02, 0.02, 0.02}));
    List<SolidPart> post = List.of(SolidPart.ball(new double[] {1, 0, 0}, 0.1));
    double truth = 1 - 0.1 - 0.01 * Math.sqrt(2);
    Clearance.Result found = new Clearance(spinner, post).along(times, turning, still, 1e-7);
    double missed = RowPaths.missed(times, turning, still, post);
    assertThat(found.least()).isCloseTo(truth, within(missed));
    assertThat(found.proved() - missed).isLessThanOrEqualTo(truth);
    Clearance.Result other = new Clearance(post, spinner).along(times, still, turning, 1e-7);
    double less = RowPaths.missed(times, still, turning, spinner);
    assertThat(less).isLessThan(0.1 * missed);
    assertThat(other.least()).isCloseTo(truth, within(less + 1e-7));
  }

  /** Few rows: curves between them stretch the body, and balls around its parts with it. */
  @Test
  void boundsOfBallsHoldWhereCurvesStretchABody() {
    Random random = new Random(6);
    for (int i = 0; i < 300; i++) {
      int count = 1 + i % 4;
      rows(count, random.nextDouble());
      List<SolidPart> rod = new ArrayList<>();
      for (int k = 0; k < 8; k++) {
        double[] centre = {0.1 * k + 0.05, 0.1 * random.nextGaussian(), 0};
        rod.add(SolidPart.box(centre, new double[] {0.1, 0.02, 0.02}));
      }
      double[] at = {random.nextGaussian(), random.nextGaussian(), 0.1 * random.nextGaussian()};
      Clearance clearance = new Clearance(List.of(SolidPart.ball(at, 0.05)), rod);
      Clearance.Result coarse = clearance.along(times, still, turning, 1e-2);
      Clearance.Result fine = clearance.along(times, still, turning, 1e-6);
      assertThat(coarse.proved()).as("case %d", i).isLessThanOrEqualTo(fine.least() + 1e-12);
      assertThat(fine.least() - fine.proved()).isLessThanOrEqualTo(1.001e-6);
    }
  }

  /** A ball in a closed cube of triangles, and the cube about the ball. */
  @Test
  void bodyInsideASurfaceOverlapsIt() {
    rows(4, 0);
    List<SolidPart> cube = new ArrayList<>();
    for (int axis = 0; axis < 3; axis++) {
      for (int side = -1; side <= 1; side += 2) {
        double[][] corner = new double[4][3];
        for (int c = 0; c < 4; c++) {
          corner[c][axis] = side;
          corner[c][(axis + 1) % 3] = c == 0 || c == 3 ? -1 : 1;
          corner[c][(axis + 2) % 3] = c < 2 ? -1 : 1;
        }
        cube.add(triangle(corner[0], corner[1], corner[2]));
        cube.add(triangle(corner[0], corner[2], corner[3]));
      }
    }
    List<SolidPart> inside = List.of(SolidPart.ball(new double[] {0.3, 0.2, 0.1}, 0.1));
    List<SolidPart> outside = List.of(SolidPart.ball(new double[] {0.3, 0.2, 2.1}, 0.1));
    assertThat(new Clearance(cube, inside).along(times, still, turning, 1e-6).least()).isZero();
    assertThat(new Clearance(inside, cube).along(times, still, turning, 1e-6).least()).isZero();
    assertThat(new Clearance(cube, outside).along(times, still, turning, 1e-6).least())
        .isCloseTo(1, within(1e-12));
    assertThat(new Clearance(outside, cube).along(times, still, turning, 1e-6).least())
        .isCloseTo(1, within(1e-12));
  }

  private static SolidPart triangle(double[] a, double[] b, double[] c) {
    return SolidPart.hull(a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]);
  }
}
