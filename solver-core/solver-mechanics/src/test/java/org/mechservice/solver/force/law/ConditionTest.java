package org.mechservice.solver.force.law;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What laws ask of their numbers. */
final class ConditionTest {
  @ParameterizedTest
  @CsvSource({
    "FINITE, -1, 0, true",
    "NOT_NEGATIVE, 0, 0, true",
    "NOT_NEGATIVE, -1e-300, 0, false",
    "POSITIVE, 1e-300, 0, true",
    "POSITIVE, 0, 0, false",
    "AT_LEAST_ONE, 1, 0, true",
    "AT_LEAST_ONE, 0.999, 0, false",
    "ZERO_ON_ONE_SIDE, 0, 0, true",
    "ZERO_ON_ONE_SIDE, 1, 0, false",
    "POSITIVE_WITH_FRICTION, 0, 0, true",
    "POSITIVE_WITH_FRICTION, 0, 0.3, false",
    "POSITIVE_WITH_FRICTION, 0.1, 0.3, true",
    "POSITIVE, NaN, 0, false",
    "NOT_NEGATIVE, NaN, 0, false"
  })
  void holdsWhereItsWordsSay(Condition condition, double value, double before, boolean holds) {
    assertThat(condition.holds(value, before)).isEqualTo(holds);
  }
}
