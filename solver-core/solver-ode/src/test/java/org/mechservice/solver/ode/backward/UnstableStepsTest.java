package org.mechservice.solver.ode.backward;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class UnstableStepsTest {
  private static final int STEPS = 4000;

  /** Degrees from the negative real axis as a damping ratio. */
  static double damping(double degrees) {
    return StrictMath.cos(StrictMath.toRadians(degrees));
  }

  /**
   * Growth per step of y' = λ y by the formula itself, in complex numbers, from one value of 1 and
   * k of 0; mean of the second half of the steps.
   */
  static double growth(BackwardFormulas formulas, int k, double size, double degrees) {
    double lambdaReal = -size * damping(degrees);
    double lambdaImaginary = size * StrictMath.sin(StrictMath.toRadians(degrees));
    // Coefficients of y_{n+1−i} in Σ ∇^m y_{n+1} / m − κ γ ∇^{k+1} y_{n+1}.
    double[] coefficients = new double[k + 2];
    for (int m = 1; m <= k + 1; m++) {
      double share = m <= k ? 1.0 / m : -formulas.kappa(k) * formulas.gamma(k);
      double binomial = 1;
      for (int i = 0; i <= m; i++) {
        coefficients[i] += (i % 2 == 0 ? share : -share) * binomial;
        binomial = binomial * (m - i) / (i + 1);
      }
    }
    double[] real = new double[k + 2];
    double[] imaginary = new double[k + 2];
    real[1] = 1;
    double logarithm = 0;
    for (int n = 0; n < STEPS; n++) {
      double sumReal = 0;
      double sumImaginary = 0;
      for (int i = 1; i <= k + 1; i++) {
        sumReal -= coefficients[i] * real[i];
        sumImaginary -= coefficients[i] * imaginary[i];
      }
      double leftReal = coefficients[0] - lambdaReal;
      double leftImaginary = -lambdaImaginary;
      double square = leftReal * leftReal + leftImaginary * leftImaginary;
      real[0] = (sumReal * leftReal + sumImaginary * leftImaginary) / square;
      imaginary[0] = (sumImaginary * leftReal - sumReal * leftImaginary) / square;
      double scale = 0;
      for (int i = 0; i <= k; i++) {
        scale = Math.max(scale, Math.abs(real[i]) + Math.abs(imaginary[i]));
      }
      for (int i = k; i >= 0; i--) {
        real[i + 1] = real[i] / scale;
        imaginary[i + 1] = imaginary[i] / scale;
      }
      logarithm += n >= STEPS / 2 ? StrictMath.log(scale) : 0;
    }
    return StrictMath.exp(logarithm / (STEPS - STEPS / 2));
  }

  @ParameterizedTest
  @CsvSource({
    "3, 84", "3, 88", "4, 70", "4, 80", "4, 87", "5, 55", "5, 70", "5, 84", "5, 88", "3, 89",
    "4, 89", "3, 89.7", "5, 89.7"
  })
  void oscillationGrowsInsideTheIntervalAndDecaysBelowIt(int k, double degrees) {
    UnstableSteps unstable = BackwardFormulas.NDF.unstable();
    double first = unstable.first(k, damping(degrees));
    // Ratios are told apart by a 300th of their square root, which moves the edge by less.
    assertThat(growth(BackwardFormulas.NDF, k, 0.95 * first, degrees)).isLessThan(1);
    assertThat(growth(BackwardFormulas.NDF, k, 1.05 * first, degrees)).isGreaterThan(1);
    assertThat(unstable.contains(k, 0.95 * first, damping(degrees))).isFalse();
    assertThat(unstable.contains(k, 1.05 * first, damping(degrees))).isTrue();
    assertThat(growth(BackwardFormulas.NDF, k, 100, degrees)).isLessThan(1);
    assertThat(unstable.contains(k, 100, damping(degrees))).isFalse();
  }

  @ParameterizedTest
  @CsvSource({"3, 80, 86", "4, 66, 73", "5, 51, 51"})
  void cornersOfStabilityAreThosePublished(int k, double ofNdf, double ofBdf) {
    assertThat(BackwardFormulas.NDF.unstable().first(k, damping(ofNdf - 1))).isInfinite();
    assertThat(BackwardFormulas.NDF.unstable().first(k, damping(ofNdf + 2))).isFinite();
    assertThat(BackwardFormulas.BDF.unstable().first(k, damping(ofBdf - 1))).isInfinite();
    assertThat(BackwardFormulas.BDF.unstable().first(k, damping(ofBdf + 2))).isFinite();
  }

  @Test
  void ordersOneAndTwoAreStableForEveryDampedOscillation() {
    UnstableSteps unstable = BackwardFormulas.NDF.unstable();
    for (int k = 1; k <= 2; k++) {
      assertThat(unstable.first(k, damping(89))).isInfinite();
      assertThat(unstable.contains(k, 1, damping(89))).isFalse();
    }
  }
}
