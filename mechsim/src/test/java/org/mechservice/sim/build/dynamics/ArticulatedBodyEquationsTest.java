package org.mechservice.sim.build.dynamics;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.sim.build.Scenes;
import org.mechservice.sim.symbolic.Program;

class ArticulatedBodyEquationsTest {
  @ParameterizedTest
  @ValueSource(strings = {"pend5", "pend5s", "driver41", "chain200"})
  void accelerationsOfTimingModelsEqualPinocchios(String name) {
    Scenes.TimingModel model = Scenes.timingModel(name);
    Links links = Links.of(model.mechanism());
    int n = model.accelerations().length;
    Program program = ArticulatedBodyEquations.derive(links, link -> 2 * n + link.joint());
    double[] yDot = new double[2 * n];
    assertThat(program.evaluate(model.input(), yDot)).isEqualTo(-1);
    double worst = 0;
    double scale = 0;
    for (int i = 0; i < n; i++) {
      worst = Math.max(worst, Math.abs(yDot[n + i] - model.accelerations()[i]));
      scale = Math.max(scale, Math.abs(model.accelerations()[i]));
    }
    System.out.println(
        name
            + " "
            + worst / scale
            + " flops "
            + program.operationCount()
            + " zero tau "
            + ArticulatedBodyEquations.derive(links).operationCount());
    assertThat(worst).isLessThan(1e-11 * scale);
  }
}
