package org.mechservice.solver.ode.jumps;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.ode.solve.FoundEvent;
import org.mechservice.solver.ode.solve.Ode;
import org.mechservice.solver.ode.solve.OdeEvent;
import org.mechservice.solver.ode.solve.OdeFunction;
import org.mechservice.solver.ode.solve.OdeMethod;
import org.mechservice.solver.ode.solve.OdeOptions;

/**
 * A force that changes its sign with the position, written as sign(y) and declared to nobody: each
 * change of sign is found as an event, and no crossing delays those to come.
 */
class UndeclaredRelayTest {
  private static final double END = 20;

  /** Errors of nine crossings add up; one tolerance each. */
  private static final double TOLERANCES = 10;

  /**
   * y″ = −sign(y) − k y, from rest at y0: between two changes of sign a part of a parabola (k = 0)
   * or of an oscillation about −1 / k, so that the first falls on √(2 y0), or on arccos(1 / (1 + k
   * y0)) / √k, and the others on its odd multiples.
   */
  @ParameterizedTest
  @CsvSource({
    "ODE113, 0, 1",
    "ODE113, 0.3, 1",
    "ODE113, 0.3, 0.7",
    "DE, 0, 1",
    "DE, 0.3, 1",
    "DE, 0.3, 0.7"
  })
  void changesOfSignAreFoundInTime(OdeMethod method, double k, double y0) {
    double first = k == 0 ? Math.sqrt(2 * y0) : Math.acos(1 / (1 + k * y0)) / Math.sqrt(k);
    OdeFunction relay =
        (t, y, yDot) -> {
          yDot[0] = y[1];
          yDot[1] = -Math.signum(y[0]) - k * y[0];
        };
    for (double tolerance : new double[] {1e-3, 1e-4, 1e-6, 1e-9, 1e-11}) {
      List<FoundEvent> found =
          Ode.solve(
                  relay,
                  0,
                  new double[] {y0, 0},
                  END,
                  OdeOptions.standard()
                      .searchUndeclaredJumps()
                      .rtol(tolerance)
                      .atol(tolerance)
                      .method(method)
                      .event(OdeEvent.when((t, y) -> y[0])))
              .events();
      assertThat(found).hasSize((int) ((END / first + 1) / 2));
      for (int i = 0; i < found.size(); i++) {
        assertThat(found.get(i).time())
            .as("change of sign %d at %.0e", i, tolerance)
            .isCloseTo((2 * i + 1) * first, within(TOLERANCES * tolerance));
      }
    }
  }
}
