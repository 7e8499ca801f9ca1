package org.mechservice.robot.fuzz;

import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.time.Duration;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A slice of what {@link FuzzPageTest} does for long with expressions. */
class ExpressionFuzzTest {
  private static final Duration PATIENCE = Duration.ofMinutes(5);
  private static final int TEXTS = 10_000;

  @ParameterizedTest
  @ValueSource(longs = {1, 2})
  void randomTextsHaveAFiniteValueOrAreRefusedInPlace(long seed) {
    assertTimeoutPreemptively(PATIENCE, () -> new ExpressionCampaign(seed).texts(TEXTS));
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2})
  void drawnExpressionsHaveTheValueWorkedOutWhileTheyWereWritten(long seed) {
    assertTimeoutPreemptively(PATIENCE, () -> new ExpressionCampaign(seed).expressions(TEXTS));
  }
}
