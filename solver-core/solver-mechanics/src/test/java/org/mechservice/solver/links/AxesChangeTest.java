package org.mechservice.solver.links;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

class AxesChangeTest {
  @Test
  void axesThatChangePlacesNeedNoTurn() {
    assertThat(Axes.permutations()).hasSize(24);
    for (Rotation permutation : Axes.permutations()) {
      AxesChange change = AxesChange.of(permutation);
      assertThat(change.isPermutation()).isTrue();
      assertThat(change.rotation()).isEqualTo(permutation);
    }
  }

  @Test
  void aRotationAboutACoordinateAxisNeedsOneTurn() {
    for (Vector3 axis : new Vector3[] {v(1, 0, 0), v(0, -1, 0), v(0, 0, 1)}) {
      for (double angle : new double[] {0.7, -2.5, 3, 1e-7}) {
        Rotation rotation = Rotation.about(axis, angle);
        AxesChange change = AxesChange.of(rotation);
        assertThat(change.turn()).isPresent();
        assertSame(change.rotation(), rotation);
      }
    }
  }

  @Test
  void anyRotationIsReproduced() {
    Random random = new Random(3);
    for (int trial = 0; trial < 500; trial++) {
      Vector3 axis =
          v(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalized();
      double angle = trial % 5 == 0 ? 1e-8 * random.nextDouble() : 6 * random.nextDouble();
      Rotation rotation = Rotation.about(axis, angle);
      AxesChange change = AxesChange.of(rotation);
      assertSame(change.rotation(), rotation);
    }
  }

  @Test
  void anyDirectionIsTakenToZ() {
    Random random = new Random(5);
    for (int trial = 0; trial < 200; trial++) {
      Vector3 d =
          v(random.nextGaussian(), random.nextGaussian(), random.nextInt(2) * 1e-9 - 0.5)
              .normalized();
      Vector3 turned = Axes.toZ(d).apply(d);
      assertThat(turned.minus(v(0, 0, 1)).norm()).isLessThan(1e-15);
    }
    assertThat(Axes.toZ(v(0, 0, -1)).apply(v(0, 0, -1))).isEqualTo(v(0, 0, 1));
  }

  private static Vector3 v(double x, double y, double z) {
    return new Vector3(x, y, z);
  }

  /** Snapped elements are off by their rounding, products of turns by a few units more. */
  private static void assertSame(Rotation actual, Rotation expected) {
    double[][] a = Axes.elements(actual);
    double[][] e = Axes.elements(expected);
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        assertThat(Math.abs(a[i][j] - e[i][j])).isLessThan(8 * Axes.ROUNDING);
      }
    }
  }
}
