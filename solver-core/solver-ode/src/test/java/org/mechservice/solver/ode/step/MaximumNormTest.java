package org.mechservice.solver.ode.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.suite.FunctionOde;

/** The largest component counts, whatever the sign of it, and what is not finite is never lost. */
class MaximumNormTest {
  private static final double LARGEST = Double.MAX_VALUE;

  /**
   * Norm of two components at relative tolerance 1; the second one, of size s, is weighed 1 / s.
   */
  private static MaximumNorm norm(double size) {
    MaximumNorm norm = new MaximumNorm();
    norm.begin(1, new double[] {1, 1}, new Manifold(new FunctionOde(2, (t, y, yDot) -> {})));
    norm.weigh(new double[] {1, size});
    return norm;
  }

  @Test
  void isTheLargestMagnitudeOverTheErrorAllowed() {
    MaximumNorm norm = norm(4);
    assertThat(norm.of(new double[] {-2, 4})).isEqualTo(2);
    assertThat(norm.of(new double[] {0.5, -4})).isEqualTo(1);
    assertThat(norm.of(new double[] {-0.0, 0})).isZero();
    assertThat(norm.ofSum(new double[] {1, 8}, new double[] {-3, 8})).isEqualTo(4);
    assertThat(norm.of(new double[] {Double.MIN_VALUE, 0})).isEqualTo(Double.MIN_VALUE);
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
  void isNotFiniteIfAComponentIsNot(double component) {
    double[] x = {1, component};
    assertThat(norm(1).of(x)).isNotFinite();
    assertThat(norm(1).ofSum(x, new double[] {1, 1})).isNotFinite();
  }

  @Test
  void isNotANumberIfADifferenceOfInfinitiesIsInIt() {
    // The processor may give such a NaN either sign.
    double[] infinite = {LARGEST * 2, 1};
    double[] opposite = {-LARGEST * 2, 1};
    assertThat(norm(1).ofSum(infinite, opposite)).isNaN();
  }

  @Test
  void isNotANumberIfAnInfiniteComponentWeighsNothing() {
    MaximumNorm norm = norm(Double.POSITIVE_INFINITY);
    assertThat(norm.weight(1)).isCloseTo(0, within(Double.MIN_VALUE));
    assertThat(norm.of(new double[] {1, Double.NEGATIVE_INFINITY})).isNaN();
    assertThat(norm.of(new double[] {1, LARGEST})).isEqualTo(1);
  }
}
