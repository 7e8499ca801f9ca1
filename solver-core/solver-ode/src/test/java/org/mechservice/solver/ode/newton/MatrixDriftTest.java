package org.mechservice.solver.ode.newton;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** The rate grows by 1 per second where derivatives are formed at t = 0. */
class MatrixDriftTest {
  private static MatrixDrift growing() {
    MatrixDrift drift = MatrixDrift.of(false);
    drift.formed(0);
    drift.moveTo(0.1);
    drift.learn(0.1);
    return drift;
  }

  @Test
  void rateGrowsWithTheTimeSinceTheDerivativesWereFormed() {
    assertThat(growing().moveTo(0.15)).isCloseTo(1.5, within(1e-15));
  }

  @Test
  void newDerivativesAreWantedBeforeTheIterationIsSlow() {
    MatrixDrift drift = growing();
    assertThat(drift.slowAt(0.2)).isFalse();
    assertThat(drift.slowAt(0.3)).isTrue();
  }

  @Test
  void differencesAreKeptLonger() {
    MatrixDrift drift = MatrixDrift.of(true);
    drift.formed(0);
    drift.moveTo(0.1);
    drift.learn(0.1);
    assertThat(drift.slowAt(0.3)).isFalse();
    assertThat(drift.slowAt(0.8)).isTrue();
  }

  @Test
  void growthOutlivesTheDerivatives() {
    MatrixDrift drift = growing();
    drift.formed(1);
    assertThat(drift.slowAt(1.1)).isFalse();
    assertThat(drift.slowAt(1.3)).isTrue();
  }

  @Test
  void growthThatIsNeverMetIsTriedAgain() {
    MatrixDrift drift = growing();
    int formed = 0;
    while (drift.slowAt(formed + 1.0) && formed < 100) {
      formed++;
      drift.formed(formed);
    }
    assertThat(formed).isBetween(5, 50);
  }

  @Test
  void rateWhereTheDerivativesWereFormedSaysNothingOfLaterSteps() {
    MatrixDrift drift = MatrixDrift.of(false);
    drift.formed(1);
    drift.moveTo(1);
    drift.learn(0.5);
    assertThat(drift.moveTo(1.1)).isInfinite();
    assertThat(drift.slowAt(10)).isFalse();
  }

  @Test
  void matrixThatStaysIsNeverSlow() {
    MatrixDrift drift = MatrixDrift.none();
    drift.formed(0);
    assertThat(drift.moveTo(1)).isEqualTo(1);
    drift.learn(0.8);
    assertThat(drift.slowAt(100)).isFalse();
    assertThat(drift.formedHere()).isTrue();
  }
}
