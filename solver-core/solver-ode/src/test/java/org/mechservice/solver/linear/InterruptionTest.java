package org.mechservice.solver.linear;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.concurrent.CancellationException;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.linear.spectrum.SingularValues;

/** Eliminations and singular values, of which the set-up of large mechanisms consists, stop. */
class InterruptionTest {
  @AfterEach
  void clear() {
    Thread.interrupted();
  }

  @Test
  void anInterruptStopsLongComputations() {
    double[] matrix = {1, 2, 3, 4};
    List<ThrowingCallable> computations =
        List.of(
            () -> new PivotedElimination(2, 2).eliminate(matrix.clone(), 2),
            () -> new SingularValues(2, 2).decompose(matrix.clone()));
    Thread.currentThread().interrupt();
    for (ThrowingCallable each : computations) {
      assertThatThrownBy(each).isInstanceOf(CancellationException.class);
    }
  }
}
