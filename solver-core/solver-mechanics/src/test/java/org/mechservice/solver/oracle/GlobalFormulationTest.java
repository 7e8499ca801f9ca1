package org.mechservice.solver.oracle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.scenes.SharedScene;
import org.mechservice.solver.scenes.SharedScene.ReferenceState;

class GlobalFormulationTest {
  @ParameterizedTest
  @ValueSource(
      strings = {
        "pendulum5",
        "double_pendulum",
        "dzhanibekov",
        "slider_crank_planar",
        "fourbar_redundant",
        "A03_andrews",
        "fps",
        "gimbal_q2_0.4"
      })
  void accelerationsAreThoseOfTheReferences(String name) {
    SharedScene scene = SharedScene.named(name);
    GlobalFormulation global = new GlobalFormulation(scene.mechanism(), scene.forces());
    for (ReferenceState state : scene.reference()) {
      double[] a = global.accelerations(state.t(), state.q(), state.v());
      double scale = 1 + Arrays.stream(state.a()).map(Math::abs).max().orElse(0);
      for (int i = 0; i < a.length; i++) {
        // The reference gives 15 digits of state and acceleration; stiff forces cost some of them.
        assertThat(a[i])
            .as("%s, t = %s, a[%s]", name, state.t(), i)
            .isCloseTo(state.a()[i], within(1e-10 * scale));
      }
    }
  }
}
