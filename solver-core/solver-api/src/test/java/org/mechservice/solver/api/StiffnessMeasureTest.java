package org.mechservice.solver.api;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.run.Stiffness;

/** The measure counts time constants of damped motions and radians of others. */
class StiffnessMeasureTest {
  /** An oscillation of frequency 1000 rad/s, by its damping ratio and the length of the run. */
  @ParameterizedTest
  @CsvSource({
    "1, 0.49, NOT_STIFF",
    "1, 0.51, STIFF",
    "0.051, 0.51, STIFF",
    "0.049, 0.51, OSCILLATORY",
    "0, 0.49, NOT_STIFF",
    "0, 0.51, OSCILLATORY",
    "-0.1, 0.51, OSCILLATORY"
  })
  void dampingRatioAndLengthDecide(double ratio, double length, Stiffness.Verdict verdict) {
    double swing = 1000 * Math.sqrt(1 - ratio * ratio);
    double[] real = {-1000 * ratio, -1000 * ratio, -1};
    assertThat(verdict(length, real, new double[] {swing, -swing, 0})).isEqualTo(verdict);
  }

  @Test
  void buckledSpringMovesAway() {
    double[] real = {-1e3, 1e3};
    double[] imaginary = {0, 0};
    assertThat(Stiffness.deciding(real, imaginary)).isEqualTo(1);
    assertThat(verdict(1, real, imaginary)).isEqualTo(Stiffness.Verdict.OSCILLATORY);
  }

  @Test
  void undampedMotionHalfAsFastDecidesAndASlowerOneDoesNot() {
    double[] real = {-1e3, 0, 0};
    assertThat(Stiffness.deciding(real, new double[] {0, 510, -510})).isEqualTo(1);
    assertThat(Stiffness.deciding(real, new double[] {0, 490, -490})).isZero();
  }

  /** A contact with 1e4 1/s that is closed at one of eleven times passes 1e4 / 11 in 1 s. */
  @Test
  void contactCountsForThePartOfTheTimeInWhichItIsClosed() {
    Stiffness stiffness = new Stiffness();
    for (int i = 0; i < Stiffness.USUAL_TIMES; i++) {
      stiffness.add(new double[] {i == 5 ? -1e4 : 0}, new double[] {0});
    }
    assertThat(stiffness.timeConstants(1)).isEqualTo(1e4 / 11);
    assertThat(stiffness.radians(1)).isZero();
    assertThat(stiffness.verdict(0.5)).isEqualTo(Stiffness.Verdict.NOT_STIFF);
    assertThat(stiffness.verdict(0.6)).isEqualTo(Stiffness.Verdict.STIFF);
  }

  @Test
  void nothingThatMovesIsNotStiff() {
    assertThat(new Stiffness().verdict(1e9)).isEqualTo(Stiffness.Verdict.NOT_STIFF);
    assertThat(verdict(1e9, new double[0], new double[0])).isEqualTo(Stiffness.Verdict.NOT_STIFF);
  }

  private static Stiffness.Verdict verdict(double length, double[] real, double[] imaginary) {
    Stiffness stiffness = new Stiffness();
    stiffness.add(real, imaginary);
    return stiffness.verdict(length);
  }
}
