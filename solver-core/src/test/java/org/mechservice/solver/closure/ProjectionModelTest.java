package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.ExplicitModel;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.scenes.SharedScene;
import org.mechservice.solver.scenes.SharedScene.ReferenceState;

class ProjectionModelTest {
  private static final RunSettings SETTINGS = new RunSettings(0, 1, 0.1, "ode113", 1e-8, 1e-10);

  @ParameterizedTest
  @ValueSource(strings = {"slider_crank_planar", "fourbar_redundant"})
  void accelerationsAreThoseOfTheReferences(String name) {
    SharedScene scene = SharedScene.named(name);
    ClosedMechanism closed = new ClosedMechanism(scene.mechanism(), "DSR", SETTINGS);
    ProjectionModel model = new ProjectionModel(closed);
    for (ReferenceState state : scene.reference()) {
      double[] y = state(state);
      double[] yDot = new double[y.length];
      assertThat(model.complete(state.t(), y)).isTrue();
      assertThat(model.derivative(state.t(), y, yDot)).isEqualTo(ExplicitModel.REGULAR);
      double scale = 1 + Arrays.stream(state.a()).map(Math::abs).max().orElse(0);
      for (int i = 0; i < state.a().length; i++) {
        assertThat(yDot[state.q().length + i])
            .as("t = " + state.t() + " a" + i)
            .isCloseTo(state.a()[i], within(1e-11 * scale));
      }
    }
  }

  private static double[] state(ReferenceState state) {
    double[] y = Arrays.copyOf(state.q(), state.q().length + state.v().length);
    System.arraycopy(state.v(), 0, y, state.q().length, state.v().length);
    return y;
  }
}
