package org.mechservice.report.solution;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

/** The climb to tight tolerances by a clock of its own: what a code would need is given. */
class ToleranceLadderTest {
  private double now;
  private final List<Double> tried = new ArrayList<>();

  /** A part of a solution, 1 if it reached the end. */
  private Optional<ToleranceLadder.Rung<Double>> climb(
      double seconds, DoubleUnaryOperator secondsAtTolerance) {
    return new ToleranceLadder<Double>(() -> now, 4)
        .climb(
            (tolerance, most) -> {
              tried.add(tolerance);
              double needed = secondsAtTolerance.applyAsDouble(tolerance);
              now += Math.min(needed, most);
              double part = Math.min(1, most / needed);
              return part < 0.2 ? Optional.empty() : Optional.of(part);
            },
            part -> part == 1,
            seconds);
  }

  @Test
  void withTimeEnoughTheTightestToleranceIsTaken() {
    assertThat(climb(100, tolerance -> 1))
        .hasValueSatisfying(
            rung -> {
              assertThat(rung.tolerance()).isEqualTo(1e-12);
              assertThat(rung.solution()).isEqualTo(1);
            });
  }

  /** Where rounding stops a code, time grows without bound; the tolerance before stands. */
  @Test
  void toleranceThatRoundingForbidsIsGivenUp() {
    assertThat(climb(100, tolerance -> tolerance < 5e-12 ? 1e6 : 1))
        .hasValueSatisfying(rung -> assertThat(rung.tolerance()).isEqualTo(1e-11));
    assertThat(now).as("time for the other solutions is left").isLessThan(100 - 2 * 1);
  }

  @Test
  void climbEndsWhereTheNextWouldLeaveNoTimeForTheOtherSolutions() {
    assertThat(climb(19, tolerance -> 2))
        .hasValueSatisfying(rung -> assertThat(rung.tolerance()).isEqualTo(1e-10));
    assertThat(19 - now).as("time for three more").isGreaterThanOrEqualTo(3 * 2);
  }

  @Test
  void partOfASolutionStandsIfEvenTheLoosestDoesNotReachTheEnd() {
    assertThat(climb(40, tolerance -> 20))
        .hasValueSatisfying(
            rung -> {
              assertThat(rung.tolerance()).isEqualTo(1e-9);
              assertThat(rung.solution()).isBetween(0.2, 0.5);
            });
    assertThat(tried).as("no second rough solution").containsExactly(1e-6, 1e-9);
  }

  @Test
  void roughSolutionStandsIfNothingIsKnownOfATighterOne() {
    assertThat(climb(40, tolerance -> tolerance < 1e-7 ? 1e6 : 2))
        .hasValueSatisfying(rung -> assertThat(rung.tolerance()).isEqualTo(1e-6));
  }

  @Test
  void noSolutionInItsTimeIsNone() {
    assertThat(climb(40, tolerance -> 1e6)).isEmpty();
  }
}
