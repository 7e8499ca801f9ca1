package org.mechservice.solver.linear;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A band as wide as the matrix does what every solver does; a narrow one the same as a dense. */
class BandLuTest extends LuFactorsContract {
  @Override
  protected LinearSolver create(int n) {
    int all = Math.max(0, n - 1);
    return new BandLu(new BandLayout(n, all, all));
  }

  @ParameterizedTest
  @CsvSource({"1, 0, 0", "6, 0, 0", "6, 1, 1", "9, 2, 2", "12, 3, 1", "12, 0, 4", "12, 5, 0"})
  void bandIsSolvedAsIfItWereDense(int n, int lower, int upper) {
    Random random = new Random(77);
    for (int trial = 0; trial < 20; trial++) {
      LinearSolver band = new BandLu(new BandLayout(n, lower, upper));
      LinearSolver dense = new DenseLu(n);
      double[] full = fill(band.layout(), random);
      assertThat(band.factor(packed(band.layout(), full))).isEqualTo(dense.factor(full));
      double[] b = random.doubles(n).toArray();
      double[] x = b.clone();
      band.solve(x);
      dense.solve(b);
      // The same operations in the same order, but for the zeros.
      assertThat(x).containsExactly(b, within(1e-12 * Arrays.stream(b).map(Math::abs).sum()));
      assertThat(band.reciprocalCondition())
          .isCloseTo(dense.reciprocalCondition(), within(1e-9 * dense.reciprocalCondition()));
    }
  }

  /** Random elements in the band of a dense matrix; small ones on the diagonal ask for pivots. */
  private static double[] fill(MatrixLayout layout, Random random) {
    int n = layout.dimension();
    double[] full = new double[n * n];
    for (int j = 0; j < n; j++) {
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i++) {
        full[i * n + j] = random.nextGaussian() * (i == j ? 0.1 : 1);
      }
    }
    return full;
  }

  /** The band of a dense matrix; what lies outside of the matrix is NaN. */
  private static double[] packed(MatrixLayout layout, double[] full) {
    double[] band = new double[layout.length()];
    Arrays.fill(band, Double.NaN);
    for (int j = 0; j < layout.dimension(); j++) {
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i++) {
        band[layout.index(i, j)] = full[i * layout.dimension() + j];
      }
    }
    return band;
  }

  @Test
  void elementsAreStoredRowAfterRowOfTheBand() {
    BandLayout layout = new BandLayout(5, 1, 2);
    assertThat(layout.length()).isEqualTo(20);
    assertThat(layout.index(0, 0)).isEqualTo(1);
    assertThat(layout.index(2, 1)).isEqualTo(8);
    assertThat(layout.index(2, 4)).isEqualTo(11);
  }

  @Test
  void columnsAtTheDistanceShareNoRow() {
    BandLayout layout = new BandLayout(20, 2, 3);
    int d = layout.columnDistance();
    assertThat(IntStream.range(0, 20 - d))
        .allMatch(j -> layout.lastRow(j) < layout.firstRow(j + d));
    assertThat(IntStream.range(3, 20 - d - 2))
        .noneMatch(j -> layout.lastRow(j) < layout.firstRow(j + d - 1));
  }

  @ParameterizedTest
  @CsvSource({"3, 3, 0, below, 3", "3, 0, 3, above, 3", "3, -1, 0, below, -1", "0, 1, 0, below, 1"})
  void bandOutsideOfTheMatrixIsRefused(int n, int lower, int upper, String side, String given) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new BandLayout(n, lower, upper))
        .withMessageContaining(side + " the main one is " + given);
  }
}
