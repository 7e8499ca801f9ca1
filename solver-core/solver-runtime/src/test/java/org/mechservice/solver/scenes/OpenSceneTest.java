package org.mechservice.solver.scenes;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.run.Outcome;

/** The open scenes in every formulation against their references. */
class OpenSceneTest {
  /**
   * Bound 100 rtol, and not below ten times the reference's own doubt; measured errors are below 15
   * rtol.
   */
  @CsvSource({
    "driver_C0, DTR, ode113, 1e-6, 0.025",
    "driver_C0, DSR, DE, 1e-6, 0.025",
    "driver_C0, RR-JF, ode15sR, 1e-6, 0.025",
    "driver_CK100, DTR, ode15s, 1e-6, 0.025",
    "driver_CK100, DSR, ode15s, 1e-6, 0.025",
    "driver_CK100, RR, ode15sR, 1e-6, 0.025",
    "driver_CK100, RR-JF, ode15sR, 1e-8, 0.025",
    "driver_CK100, RR-JF forces, ode15sR, 1e-6, 0.025",
    "driver_free_C0, DTR, DE, 1e-8, 0.05",
    "driver_free_C0, DSR, ode113, 1e-6, 0.05",
    "driver_free_CK100, DTR, ode15s, 1e-8, 0.05",
    "driver_free_CK100, RR-JF, ode15sR, 1e-6, 0.05",
    "A05_flyball, DTR, ode15s, 1e-6, 0.1",
    "A05_flyball, DSR, ode15s, 1e-8, 0.1",
    "A05_flyball, RR, ode15sR, 1e-6, 0.1",
    "A05_flyball, RR-JF, ode15sR, 1e-8, 0.1",
    "stiff_1e9_c1e5, DSR, ode15s, 1e-8, 1e-4",
    "stiff_1e9_c1e5, RR, ode15sR, 1e-8, 1e-4",
    "stiff_1e9_c1e5, RR-JF, ode15sR, 1e-8, 1e-4",
  })
  @ParameterizedTest
  void motionIsThatOfTheReference(
      String name, String formulation, String integrator, double tolerance, double step) {
    SharedScene scene = SharedScene.named(name);
    OpenSceneRun run =
        OpenSceneRun.of(scene, formulation, integrator, tolerance, scene.end(), step);
    assertThat(run.report().outcome()).isInstanceOf(Outcome.Completed.class);
    assertThat(run.error()).isLessThan(100 * tolerance);
  }

  /** Chaotic after 3 s. */
  @CsvSource({
    "DTR, ode113",
    "DSR, ode113",
    "DTR, DE",
    "DSR, DE",
    "DSR, ode15s",
    "RR, ode15sR",
    "RR-JF, ode15sR",
    "RR-JF forces, ode15sR"
  })
  @ParameterizedTest
  void pendulumMovesAsTheReference(String formulation, String integrator) {
    SharedScene scene = SharedScene.named("pendulum5");
    OpenSceneRun run = OpenSceneRun.of(scene, formulation, integrator, 1e-8, 3, 0.1);
    assertThat(run.error()).isLessThan(100 * 1e-8);
  }

  /** A whip, which makes a hundred errors of one within its two seconds: 1e4 rtol. */
  @CsvSource({"DTR, ode113", "DTR, DE", "DSR, ode15s", "RR, ode15sR", "RR-JF, ode15sR"})
  @ParameterizedTest
  void lightChainOnAHeavyRootMovesAsTheReference(String formulation, String integrator) {
    SharedScene scene = SharedScene.named("massratio_1e8_root");
    OpenSceneRun run = OpenSceneRun.of(scene, formulation, integrator, 1e-8, scene.end(), 0.1);
    assertThat(run.error()).isLessThan(1e4 * 1e-8);
  }

  @CsvSource({"DTR, ode113", "DSR, DE", "DSR, ode15s", "RR-JF, ode15sR"})
  @ParameterizedTest
  void stiffSpringWithoutDamperKeepsItsPhase(String formulation, String integrator) {
    SharedScene scene = SharedScene.named("stiff_1e9_c0");
    OpenSceneRun run = OpenSceneRun.of(scene, formulation, integrator, 1e-8, scene.end(), 1e-4);
    assertThat(run.error()).isLessThan(1e-6);
  }

  @CsvSource({"DSR, ode15s", "RR, ode15sR", "RR-JF, ode15sR"})
  @ParameterizedTest
  void stiffSpringWithDamperCostsFewImplicitSteps(String formulation, String integrator) {
    SharedScene scene = SharedScene.named("stiff_1e9_c1e5");
    OpenSceneRun run = OpenSceneRun.of(scene, formulation, integrator, 1e-8, scene.end(), 0.1);
    assertThat(run.report().steps()).isLessThan(500);
  }

  /**
   * Table II of Rodríguez et al. 2003: dampers of a hundredth of the stiffness slow an explicit
   * integrator down and speed an implicit one up. Counted in evaluations, and at an accuracy where
   * the undamped driver must resolve its oscillations.
   */
  @CsvSource({"driver", "driver_free"})
  @ParameterizedTest
  void dampersSlowExplicitAndSpeedImplicitMethods(String driver) {
    long explicitWithout = evaluations(driver + "_C0", "DTR", "DE");
    long explicitWith = evaluations(driver + "_CK100", "DTR", "DE");
    long implicitWithout = evaluations(driver + "_C0", "RR-JF", "ode15sR");
    long implicitWith = evaluations(driver + "_CK100", "RR-JF", "ode15sR");
    assertThat(explicitWith).isGreaterThan(2 * explicitWithout);
    assertThat(implicitWith).isLessThan(implicitWithout / 2);
    assertThat(implicitWith).isLessThan(explicitWith / 4);
  }

  private static long evaluations(String name, String formulation, String integrator) {
    SharedScene scene = SharedScene.named(name);
    OpenSceneRun run =
        OpenSceneRun.of(scene, formulation, integrator, 1e-6, scene.end(), scene.end());
    assertThat(run.report().outcome()).isInstanceOf(Outcome.Completed.class);
    return run.report().evaluations();
  }
}
