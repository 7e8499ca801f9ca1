package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.mechservice.solver.api.JointType.R;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.closure.model.PenaltyModel;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;

class PenaltySettingsTest {
  @Test
  void numbersThatAreNotNamedHaveTheirDefaults() {
    assertThat(PenaltySettings.of("penalty")).isEqualTo(PenaltySettings.DEFAULT);
    assertThat(PenaltySettings.of("penalty:omega=20")).isEqualTo(new PenaltySettings(1e7, 20, 1));
    assertThat(PenaltySettings.of("penalty: alpha=1e8, omega=0, mu=0.5"))
        .isEqualTo(new PenaltySettings(1e8, 0, 0.5));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "penalty:alpha=10       | alpha is 10.0; it must lie between 1000 and 1.000e+12",
        "penalty:alpha=1e13     | alpha is 1.0E13; it must lie between 1000 and 1.000e+12",
        "penalty:omega=-1       | omega is -1.0; it must lie between 0.000 and 1.000e+06",
        "penalty:mu=NaN         | mu is NaN; it must lie between 0.000 and 100.0",
        "penalty:beta=1         | \"beta=1\" is no number of the penalty closure",
        "penalty:alpha          | \"alpha\" is no number of the penalty closure",
        "penalty:alpha=a lot    | \"alpha=a lot\" is no number of the penalty closure"
      })
  void whatCannotBeUsedIsRefusedByName(String closure, String why) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> PenaltySettings.of(closure))
        .withMessageContaining(why);
  }

  /** Repetition regains what the penalty costs, from its least to beyond its default. */
  @ParameterizedTest
  @ValueSource(doubles = {1e3, 1e5, 1e9, 1e10})
  void accelerationsDoNotDependOnThePenalty(double alpha) {
    Mechanism mechanism = Linkages.fourBar(List.of(R, R, R, R), 3);
    double[] expected = accelerations(mechanism, PenaltySettings.DEFAULT);
    double[] actual = accelerations(mechanism, new PenaltySettings(alpha, 10, 1));
    for (int i = 0; i < expected.length; i++) {
      // round-off of the penalty itself, 1e10 ε, less what repetition regains
      assertThat(actual[i]).isCloseTo(expected[i], within(1e-9 * (1 + Math.abs(expected[i]))));
    }
  }

  private static double[] accelerations(Mechanism mechanism, PenaltySettings settings) {
    ClosedMechanism closed =
        new ClosedMechanism(mechanism, "DSR", SceneRun.settings(1, 0.1, "ode113", 1e-6));
    PenaltyModel model = new PenaltyModel(closed, UserForceSource.NONE, settings);
    double[] yDot = new double[closed.start().state().length];
    assertThat(model.derivative(0, closed.start().state(), yDot)).isEqualTo(ExplicitModel.REGULAR);
    return yDot;
  }
}
