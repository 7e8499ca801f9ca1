package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.mechanism.Mechanism;

/** Random closed mechanisms against the maximal coordinates of the oracle. */
class RandomLoopsTest {
  private int compared;

  @Test
  void accelerationsAndReactionsAreThoseOfMaximalCoordinates() {
    LongStream.rangeClosed(1, 60).forEach(this::compare);
    assertThat(compared).isGreaterThan(25);
  }

  private void compare(long seed) {
    Mechanism mechanism = LoopComparison.mechanism(seed);
    if (LoopComparison.leftOut(mechanism).isPresent()) {
      return;
    }
    LoopComparison comparison = LoopComparison.of(mechanism);
    comparison
        .forward()
        .forEach(
            (formulation, error) ->
                assertThat(error)
                    .as("seed %s, %s", seed, formulation)
                    .isLessThan(comparison.forwardBound()));
    assertThat(comparison.missing()).as("seed %s", seed).isLessThan(LoopComparison.MISSING);
    compared++;
  }
}
