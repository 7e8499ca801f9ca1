package org.mechservice.study.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.mechservice.study.design.Design;
import org.mechservice.study.design.Spread;

/** Indices of a function whose indices are known, and their errors. */
class SobolIndicesTest {
  private static final int BLOCKS = 2048;

  /** The a of the g-function. */
  private static final double[] G = {0, 1, 4.5, 9, 99, 99, 99, 99};

  /** Ishigami and Homma 1990: sin x + 7 sin² y + z⁴ sin x / 10 on [−π, π]³. */
  private static double ishigami(double[] x) {
    return Math.sin(x[0])
        + 7 * Math.pow(Math.sin(x[1]), 2)
        + 0.1 * Math.pow(x[2], 4) * Math.sin(x[0]);
  }

  private static double[] values(long seed) {
    List<Spread> angles = Collections.nCopies(3, new Spread.Range(-Math.PI, Math.PI, 0));
    Design design = Design.indices(angles, BLOCKS, seed);
    return IntStream.range(0, design.size()).mapToDouble(i -> ishigami(design.point(i))).toArray();
  }

  /** Variances by integration, with a = 7 and b = 0.1; of z alone there is none. */
  @Test
  void indicesOfIshigamisFunctionAreFoundWithinTheirErrors() {
    double p4 = Math.pow(Math.PI, 4);
    double byX = Math.pow(1 + 0.1 * p4 / 5, 2) / 2;
    double byY = 49 / 8.0;
    double byXz = 0.01 * p4 * p4 * 8 / 225;
    double all = byX + byY + byXz;
    double[] first = {byX / all, byY / all, 0};
    double[] total = {(byX + byXz) / all, byY / all, byXz / all};
    for (long seed = 0; seed < 20; seed++) {
      double[] values = values(seed);
      List<SobolIndices> found = SobolIndices.of(values, values.length, 3);
      for (int i = 0; i < 3; i++) {
        SobolIndices index = found.get(i);
        // 4 standard errors: missed once in 16 000 draws even if blocks were drawn independently
        assertThat(index.first()).isCloseTo(first[i], within(4 * index.firstError()));
        assertThat(index.total()).isCloseTo(total[i], within(4 * index.totalError()));
        assertThat(index.firstError()).isLessThan(0.04);
        assertThat(index.totalError()).isLessThan(0.04);
      }
    }
  }

  @Test
  void blocksWithAMissingValueAreLeftOut() {
    double[] values = values(1);
    double[] fewer = IntStream.range(5, values.length).mapToDouble(i -> values[i]).toArray();
    values[3] = Double.NaN;

    assertThat(SobolIndices.of(values, values.length, 3))
        .isEqualTo(SobolIndices.of(fewer, fewer.length, 3));
    assertThat(SobolIndices.of(values, 5 * 7, 3)).isEmpty();
  }

  /** Saltelli and Sobol 1995: the product of (|4 x - 2| + a) / (1 + a) on the unit cube. */
  private static double g(double[] x) {
    double product = 1;
    for (int i = 0; i < x.length; i++) {
      product *= (Math.abs(4 * x[i] - 2) + G[i]) / (1 + G[i]);
    }
    return product;
  }

  /**
   * The factors are independent with mean 1 and variance v = 1 / (3 (1 + a)²), so that all = Π (1 +
   * v) - 1, alone v and, with interactions, v times the product of 1 + v of the others.
   */
  @Test
  void indicesOfTheGFunctionAreFoundWithinTheirErrors() {
    double[] v = Arrays.stream(G).map(a -> 1 / (3 * (1 + a) * (1 + a))).toArray();
    double product = Arrays.stream(v).reduce(1, (all, one) -> all * (1 + one));
    for (long seed = 0; seed < 10; seed++) {
      Design design =
          Design.indices(Collections.nCopies(G.length, new Spread.Range(0, 1, 0)), BLOCKS, seed);
      double[] values =
          IntStream.range(0, design.size()).mapToDouble(i -> g(design.point(i))).toArray();
      List<SobolIndices> found = SobolIndices.of(values, values.length, G.length);
      for (int i = 0; i < G.length; i++) {
        SobolIndices index = found.get(i);
        double first = v[i] / (product - 1);
        double total = v[i] * product / (1 + v[i]) / (product - 1);
        assertThat(index.first()).isCloseTo(first, within(4 * index.firstError()));
        assertThat(index.total()).isCloseTo(total, within(4 * index.totalError()));
        assertThat(index.firstError()).isLessThan(0.04);
        assertThat(index.totalError()).isLessThan(0.04);
      }
    }
  }
}
