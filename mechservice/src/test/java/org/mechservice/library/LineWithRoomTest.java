package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.program.RunFailedException;
import org.mechservice.solver.api.program.Trajectory;

/**
 * A four-bar falls through the line of its bars; its coupler is longer than that of a parallelogram
 * by a gap. With s = (a + b)/2 and d = (a − b)/2 its loop is
 *
 * <p>4 sin d (sin d + 3 sin s) = 6 gap,
 *
 * <p>a smooth curve, on which sin d and sin d + 3 sin s keep their signs: in the line, d = −3 s is
 * next, and the left bar turns back. Without a gap both bars turn alike for ever.
 */
@Tag("slow")
final class LineWithRoomTest {
  private static final Path SCENE = Path.of("../examples/extremes/line_with_1e-12_to_spare.xml");

  private static final List<List<String>> METHODS =
      List.of(
          List.of("DSR", "ode113"),
          List.of("DSR", "DE"),
          List.of("DSR", "ode15s"),
          List.of("RR", "ode15sR"),
          List.of("RR-JF", "ode15sR"));

  private static final double[] TOLERANCES = {1e-4, 1e-6, 1e-7, 1e-8};

  /** Returns a and b at 0.5 s. */
  private static double[] angles(String length, List<String> method, double tolerance)
      throws Exception {
    String text = Files.readString(SCENE).replace("3+1e-12", length).replace("\"2\"", "\"0.5\"");
    Trajectory rows =
        MechModel.of("line.xml", text)
            .formulation(method.get(0))
            .closure("projection")
            .integrator(method.get(1))
            .tolerances(tolerance, tolerance / 100)
            .simulate();
    double[] left = rows.column("j_left.q");
    return new double[] {left[left.length - 1], rows.column("j_right.q")[left.length - 1]};
  }

  /** The smallest is 20 units in the last place of the distance. */
  @ParameterizedTest
  @ValueSource(strings = {"3+1e-6", "3+1e-9", "3+1e-12", "3+1e-13", "3+3e-14"})
  void aBarTurnsBackHoweverSmallTheGapOrTheRunIsRefused(String length) throws Exception {
    for (List<String> method : METHODS) {
      for (double tolerance : TOLERANCES) {
        String run = method + ", tolerance " + tolerance;
        try {
          double[] angles = angles(length, method, tolerance);
          assertThat(angles[0]).as(run).isNegative();
          assertThat(angles[1]).as(run).isPositive();
        } catch (RunFailedException e) {
          assertThat(e).as(run).hasMessageContaining("N-023").hasMessageContaining("\"coupler\"");
        }
      }
    }
  }

  @Test
  void adamsMethodsTurnWithAGapOfAPicometre() throws Exception {
    for (List<String> method : METHODS.subList(0, 2)) {
      assertThat(angles("3+1e-12", method, 1e-8)[0]).as(method.toString()).isNegative();
    }
  }

  @Test
  void withoutAGapBothTurnAlike() throws Exception {
    for (List<String> method : METHODS.subList(0, 2)) {
      double[] angles = angles("3", method, 1e-8);
      assertThat(angles[0]).as(method.toString()).isCloseTo(0.221801334755, within(1e-6));
      assertThat(angles[1]).as(method.toString()).isCloseTo(0.221801334755, within(1e-6));
    }
  }
}
