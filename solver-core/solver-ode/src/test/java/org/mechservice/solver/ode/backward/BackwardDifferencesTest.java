package org.mechservice.solver.ode.backward;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BackwardDifferencesTest {
  /** A polynomial of degree 5. */
  private static double polynomial(double t) {
    return 1 + t * (2 - t * (3 + t * (0.5 - t * (0.25 + t))));
  }

  /** Its differences of orders 1 … 5 at t = 0 over steps of h. */
  private static double[] differences(double h) {
    double[] values = new double[6];
    for (int i = 0; i < 6; i++) {
      values[i] = polynomial(-i * h);
    }
    double[] differences = new double[6];
    for (int m = 1; m < 6; m++) {
      for (int i = 0; i < 6 - m; i++) {
        values[i] -= values[i + 1];
      }
      differences[m] = values[0];
    }
    return differences;
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.1, 0.3, 0.7, 1, 1.3, 4, 10})
  void rescaledDifferencesAreThoseOfTheSamePolynomial(double ratio) {
    RescalingMatrix matrix = new RescalingMatrix();
    matrix.prepare(ratio, 5);
    double[] before = differences(0.1);
    double[] after = differences(0.1 * ratio);
    for (int m = 1; m <= 5; m++) {
      double sum = 0;
      for (int i = m; i <= 5; i++) {
        sum += before[i] * matrix.element(i, m);
      }
      // Round-off of the differences, 1e-16 times 2⁵, is enlarged by ratio⁵.
      assertThat(sum).isCloseTo(after[m], within(1e-14 * Math.max(1, Math.pow(ratio, 5))));
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5})
  void unchangedSizeLeavesTheDifferencesToTheLastBit(int k) {
    RescalingMatrix matrix = new RescalingMatrix();
    matrix.prepare(1, k);
    for (int i = 1; i <= k; i++) {
      for (int j = 1; j <= i; j++) {
        assertThat(matrix.element(i, j)).isEqualTo(i == j ? 1 : 0);
      }
    }
  }

  @Test
  void rescalingLeavesTheLastStepAsItWas() {
    BackwardDifferences differences = new BackwardDifferences(1);
    differences.begin(new double[] {1});
    differences.slope()[0] = 0.5;
    differences.predict(1, BackwardFormulas.NDF);
    differences.accept(1);
    double before = differences.accepted(1)[0];
    differences.rescale(3, 1);
    differences.rescale(2, 1);
    assertThat(differences.accepted(1)[0]).isEqualTo(before);
    assertThat(differences.tried(1)[0]).isEqualTo(6 * before);
  }

  @Test
  void formulasDifferentiatePolynomialsOfTheirOrderExactly() {
    // Without correction they say ψ = h y'(t_{n+1}) / ((1 − κ_k) γ_k); here y = t^k, t_n = 0, h =
    // 1.
    for (int k = 1; k <= 5; k++) {
      double[] differences = differencesOfPower(k);
      double psi = 0;
      for (int m = 1; m <= k; m++) {
        psi += BackwardFormulas.NDF.share(m, k) * differences[m];
      }
      assertThat(psi * BackwardFormulas.NDF.leading(k)).isCloseTo(k, within(1e-11));
    }
  }

  /** Differences of t^k, orders 1 … k, at t = 0 over steps of 1. */
  private static double[] differencesOfPower(int k) {
    double[] values = new double[k + 1];
    for (int i = 0; i <= k; i++) {
      values[i] = StrictMath.pow(-i, k);
    }
    double[] differences = new double[k + 1];
    for (int m = 1; m <= k; m++) {
      for (int i = 0; i <= k - m; i++) {
        values[i] -= values[i + 1];
      }
      differences[m] = values[0];
    }
    return differences;
  }
}
