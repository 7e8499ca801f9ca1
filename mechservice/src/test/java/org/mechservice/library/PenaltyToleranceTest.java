package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.program.Trajectory;

/** Loops by penalty in implicit methods, at tolerances near the rounding errors of the loops. */
class PenaltyToleranceTest {
  private static final Path SUSPENSION =
      Path.of("../examples/five-point-suspension/variants/elements.xml");

  private static MechModel suspension(String formulation, String closure) throws Exception {
    String file = Files.readString(SUSPENSION);
    String chosen = "<formulation name=\"" + formulation + "\" closure=\"" + closure + "\"/>";
    return MechModel.of("suspension", file.replace("</dynamic>", chosen + "</dynamic>"))
        .until(0.5)
        .every(0.5);
  }

  /**
   * The car has driven 15 m and its wheel spins at 108 rad/s, while the carrier turns by 1e-5
   * rad/s: where that passes zero, at 0.308 s, its rounding errors exceed the absolute tolerance.
   */
  @ParameterizedTest
  @ValueSource(strings = {"RR", "RR-JF"})
  void absoluteTolerancesBelowTheRoundingOfTheLoopsAreMet(String formulation) throws Exception {
    Trajectory expected =
        suspension("DSR", "projection").integrator("ode113").tolerances(1e-11, 1e-12).simulate();
    Trajectory motion =
        suspension(formulation, "penalty").integrator("ode15sR").tolerances(1e-9, 1e-12).simulate();
    // error ≤ 10 rtol of each state, or of the largest velocity that its rounding comes from
    for (String column : new String[] {"j1.q", "j3.q", "j1.v", "j3.v"}) {
      double end = expected.column(column)[1];
      assertThat(motion.column(column)[1]).as(column).isCloseTo(end, within(1e-8 * Math.abs(end)));
    }
  }
}
