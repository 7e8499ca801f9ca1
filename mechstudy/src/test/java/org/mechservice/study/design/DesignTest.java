package org.mechservice.study.design;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Points of designs, as functions of their numbers. */
class DesignTest {
  private static final Spread UNIT = new Spread.Range(0, 1, 0);

  private static double[] factor(Design design, int factor) {
    return IntStream.range(0, design.size()).mapToDouble(i -> design.point(i)[factor]).toArray();
  }

  @Test
  void gridHasEveryCombinationTheLastFactorFastest() {
    Design grid =
        Design.grid(List.of(new Spread.Range(1, 2, 2).levels(), new double[] {10, 20, 30}));

    assertThat(factor(grid, 0)).containsExactly(1, 1, 1, 2, 2, 2);
    assertThat(factor(grid, 1)).containsExactly(10, 20, 30, 10, 20, 30);
  }

  @Test
  void rangeEndsAtItsEnds() {
    double[] levels = new Spread.Range(0.1, 0.7, 7).levels();

    assertThat(levels[0]).isEqualTo(0.1);
    assertThat(levels[6]).isEqualTo(0.7);
    assertThat(levels[3]).isCloseTo(0.4, within(1e-15));
  }

  @Test
  void gridBeyondAnyNumberIsRefused() {
    double[] many = new double[100_000];

    assertThatThrownBy(() -> Design.grid(List.of(many, many))).hasMessageContaining("2147483647");
  }

  /** The first points of Sobol's sequence in two dimensions (Joe and Kuo). */
  @Test
  void sobolPointsAreThePublishedOnes() {
    Design sobol = Design.sobol(List.of(UNIT, UNIT), 7, 0);

    assertThat(factor(sobol, 0)).containsExactly(0.5, 0.75, 0.25, 0.375, 0.875, 0.625, 0.125);
    assertThat(factor(sobol, 1)).containsExactly(0.5, 0.25, 0.75, 0.375, 0.875, 0.125, 0.625);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 7, 100, 1500})
  void latinHypercubeHasOnePointInEachStripOfEachFactor(int points) {
    Design cube = Design.latinHypercube(List.of(UNIT, UNIT, UNIT), points, 3);

    for (int j = 0; j < 3; j++) {
      int[] strips = Arrays.stream(factor(cube, j)).mapToInt(u -> (int) (u * points)).toArray();
      Arrays.sort(strips);
      assertThat(strips).containsExactly(IntStream.range(0, points).toArray());
    }
  }

  @Test
  void seedsGiveOtherPointsAndTheSameSeedTheSame() {
    for (long seed = 0; seed < 5; seed++) {
      Design a = Design.monteCarlo(List.of(UNIT, UNIT), 50, seed);
      Design b = Design.monteCarlo(List.of(UNIT, UNIT), 50, seed);
      Design c = Design.monteCarlo(List.of(UNIT, UNIT), 50, seed + 1);

      assertThat(factor(a, 1)).containsExactly(factor(b, 1));
      assertThat(factor(a, 1)).isNotEqualTo(factor(c, 1));
    }
  }

  /** Bounds are five standard errors of 20 000 draws. */
  @Test
  void drawsHaveTheMomentsOfTheirDistributions() {
    List<Spread> spreads =
        List.of(
            UNIT,
            Spread.normal(80, 12),
            Spread.lognormal(3, 0.9),
            Spread.triangular(1, 2, 6),
            new Spread.Choice(new double[] {1, 2, 6}));
    double[] mean = {0.5, 80, 3, 3, 3};
    double[] deviation = {Math.sqrt(1 / 12.0), 12, 0.9, Math.sqrt(21 / 18.0), Math.sqrt(14 / 3.0)};
    int n = 20_000;
    Design draws = Design.monteCarlo(spreads, n, 1);

    for (int j = 0; j < mean.length; j++) {
      double middle = mean[j];
      double[] x = factor(draws, j);
      double average = Arrays.stream(x).average().orElseThrow();
      double spread =
          Math.sqrt(Arrays.stream(x).map(v -> (v - middle) * (v - middle)).average().orElseThrow());
      assertThat(average).isCloseTo(middle, within(5 * deviation[j] / Math.sqrt(n)));
      assertThat(spread).isCloseTo(deviation[j], within(0.04 * deviation[j]));
    }
  }
}
