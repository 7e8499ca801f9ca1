package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.ExplicitModel;
import org.mechservice.solver.api.Outcome;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.force.UserForceSource;
import org.mechservice.solver.scenes.SharedScene;
import org.mechservice.solver.scenes.SharedScene.ReferenceState;

class ProjectionModelTest {
  private static final RunSettings SETTINGS = SceneRun.settings(1, 0.1, "ode113", 1e-8);

  private static ProjectionModel model(SharedScene scene, RunSettings settings) {
    ClosedMechanism closed = new ClosedMechanism(scene.mechanism(), "DSR", settings);
    return new ProjectionModel(closed, UserForceSource.NONE);
  }

  @ParameterizedTest
  @ValueSource(strings = {"slider_crank_planar", "fourbar_redundant", "A03_andrews", "fps"})
  void accelerationsAreThoseOfTheReferences(String name) {
    SharedScene scene = SharedScene.named(name);
    ProjectionModel model = model(scene, SETTINGS);
    for (ReferenceState state : scene.reference()) {
      double[] y = state(state);
      double[] yDot = new double[y.length];
      assertThat(model.complete(state.t(), y)).isTrue();
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

  private static double[] state(ReferenceState state) {
    double[] y = Arrays.copyOf(state.q(), state.q().length + state.v().length);
    System.arraycopy(state.v(), 0, y, state.q().length, state.v().length);
    return y;
  }

  @ParameterizedTest
  @CsvSource({
    "slider_crank_planar, 0.25, ode113, 1e-8",
    "slider_crank_planar, 0.25, DE, 1e-8",
    "slider_crank_planar, 0.25, ode15s, 1e-6",
    "fourbar_redundant, 0.25, ode113, 1e-8",
    "fourbar_redundant, 0.25, DE, 1e-8",
    "A03_andrews, 0.005, ode113, 1e-8",
    "A03_andrews, 0.005, DE, 1e-8",
    "fps, 0.05, ode113, 1e-8",
    "fps, 0.05, DE, 1e-8",
    "fps, 0.05, ode15s, 1e-6",
  })
  void motionIsThatOfTheReference(String name, double step, String integrator, double tolerance) {
    SharedScene scene = SharedScene.named(name);
    SceneRun run =
        SceneRun.of(model(scene, SceneRun.settings(scene.end(), step, integrator, tolerance)));
    System.out.println(
        "PRINT "
            + name
            + " "
            + integrator
            + " "
            + run.error(scene) / tolerance
            + " rtol, "
            + run.report.steps()
            + " steps "
            + run.report.rejectedSteps()
            + " rej "
            + run.report.evaluations()
            + " f "
            + run.report.wallTime());
    assertThat(run.report.outcome()).isInstanceOf(Outcome.Completed.class);
    // SCENES §8: 1000 rtol by default
    assertThat(run.error(scene)).isLessThan(1000 * tolerance);
  }
}
