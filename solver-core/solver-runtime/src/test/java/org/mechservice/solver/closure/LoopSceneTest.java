package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.closure.model.LoopModel;
import org.mechservice.solver.closure.model.PenaltyModel;
import org.mechservice.solver.closure.model.ProjectionModel;
import org.mechservice.solver.scenes.SharedScene;
import org.mechservice.solver.scenes.SharedScene.ReferenceState;

/** The shared scenes with loops in every formulation and integrator that applies. */
class LoopSceneTest {
  @ParameterizedTest
  @CsvSource({
    "slider_crank_planar, DSR",
    "fourbar_redundant, DSR",
    "A03_andrews, DSR",
    "fps, DSR",
    "slider_crank_planar, DSR penalty",
    "fourbar_redundant, DSR penalty",
    "A03_andrews, DSR penalty",
    "fps, DSR penalty",
  })
  void accelerationsAreThoseOfTheReferences(String name, String formulation) {
    SharedScene scene = SharedScene.named(name);
    LoopModel model =
        LoopModels.of(scene.mechanism(), formulation, SceneRun.settings(1, 0.1, "ode113", 1e-8));
    for (ReferenceState state : scene.reference()) {
      double[] y = state(state);
      double[] yDot = new double[y.length];
      assertThat(closed(model, state.t(), y)).isTrue();
      assertThat(model.derivative(state.t(), y, yDot)).isEqualTo(ExplicitModel.REGULAR);
      double scale = 1 + Arrays.stream(state.a()).map(Math::abs).max().orElse(0);
      for (int i = 0; i < state.a().length; i++) {
        // at the start the reference is exact; later states are rounded, which stiff forces show
        double tolerance = state.t() == 0 ? 1e-11 : 1e-10;
        assertThat(yDot[state.q().length + i])
            .as("t = " + state.t() + " a" + i)
            .isCloseTo(state.a()[i], within(tolerance * scale));
      }
    }
  }

  private static boolean closed(LoopModel model, double t, double[] y) {
    return model instanceof ProjectionModel projection
        ? projection.jump(t, y, new boolean[y.length])
        : ((PenaltyModel) model).project(t, y);
  }

  private static double[] state(ReferenceState state) {
    double[] y = Arrays.copyOf(state.q(), state.q().length + state.v().length);
    System.arraycopy(state.v(), 0, y, state.q().length, state.v().length);
    return y;
  }

  /** Bounds: 1000 rtol by default. */
  @ParameterizedTest
  @CsvSource({
    "slider_crank_planar, DSR, ode113, 1e-8",
    "slider_crank_planar, DSR, DE, 1e-8",
    "slider_crank_planar, DSR, ode15s, 1e-6",
    "slider_crank_planar, RR, ode15sR, 1e-6",
    "slider_crank_planar, RR-JF, ode15sR, 1e-6",
    "fourbar_redundant, DSR, ode113, 1e-8",
    "fourbar_redundant, DSR, DE, 1e-8",
    "fourbar_redundant, DSR, ode15s, 1e-6",
    "fourbar_redundant, RR, ode15sR, 1e-6",
    "fourbar_redundant, RR-JF, ode15sR, 1e-6",
    "A03_andrews, DSR, ode113, 1e-8",
    "A03_andrews, DSR, DE, 1e-8",
    "A03_andrews, DSR, ode15s, 1e-6",
    "A03_andrews, RR, ode15sR, 1e-6",
    "A03_andrews, RR-JF, ode15sR, 1e-6",
    "fps, DSR, ode113, 1e-8",
    "fps, DSR, DE, 1e-8",
    "fps, DSR, ode15s, 1e-6",
    "fps, RR, ode15sR, 1e-6",
    "fps, RR-JF, ode15sR, 1e-6",
    "slider_crank_planar, DSR penalty, ode113, 1e-8",
    "slider_crank_planar, DSR penalty, DE, 1e-8",
    "slider_crank_planar, DSR penalty, ode15s, 1e-6",
    "fourbar_redundant, DSR penalty, ode113, 1e-8",
    "fourbar_redundant, DSR penalty, DE, 1e-8",
    "fourbar_redundant, DSR penalty, ode15s, 1e-6",
    "A03_andrews, DSR penalty, ode113, 1e-8",
    "A03_andrews, DSR penalty, DE, 1e-8",
    "A03_andrews, DSR penalty, ode15s, 1e-6",
    "fps, DSR penalty, ode113, 1e-8",
    "fps, DSR penalty, DE, 1e-8",
    "fps, DSR penalty, ode15s, 1e-6",
    "slider_crank_singular, DSR penalty, ode113, 1e-8",
    "slider_crank_singular, DSR penalty, DE, 1e-4",
    "slider_crank_singular, DSR penalty, ode15s, 1e-6",
    "slider_crank_planar, RR penalty, ode15sR, 1e-6",
    "slider_crank_planar, RR-JF penalty, ode15sR, 1e-6",
    "fourbar_redundant, RR penalty, ode15sR, 1e-6",
    "fourbar_redundant, RR-JF penalty, ode15sR, 1e-6",
    "A03_andrews, RR penalty, ode15sR, 1e-6",
    "A03_andrews, RR-JF penalty, ode15sR, 1e-6",
    "fps, RR penalty, ode15sR, 1e-6",
    "fps, RR-JF penalty, ode15sR, 1e-6",
    "slider_crank_singular, RR penalty, ode15sR, 1e-6",
    "slider_crank_singular, RR-JF penalty, ode15sR, 1e-6",
    "slider_crank_singular, DSR, ode113, 1e-8",
    "slider_crank_singular, DSR, DE, 1e-4",
    "slider_crank_singular, DSR, ode15s, 1e-6",
    "slider_crank_singular, RR, ode15sR, 1e-6",
    "slider_crank_singular, RR-JF, ode15sR, 1e-6",
  })
  void motionIsThatOfTheReference(
      String name, String formulation, String integrator, double tolerance) {
    SharedScene scene = SharedScene.named(name);
    double step = name.equals("A03_andrews") ? 0.005 : name.equals("fps") ? 0.05 : 0.25;
    SceneRun run =
        LoopModels.run(
            scene.mechanism(),
            formulation,
            SceneRun.settings(scene.end(), step, integrator, tolerance));
    assertThat(run.report.outcome()).isInstanceOf(Outcome.Completed.class);
    assertThat(run.error(scene)).isLessThan(1000 * tolerance);
  }
}
