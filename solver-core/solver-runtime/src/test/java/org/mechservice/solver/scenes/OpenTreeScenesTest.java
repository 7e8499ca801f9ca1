package org.mechservice.solver.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.dynamics.LinearisedResidualModel;
import org.mechservice.solver.dynamics.LinearisedResidualModel.Mode;
import org.mechservice.solver.dynamics.RecursiveResidualModel;
import org.mechservice.solver.dynamics.SemiRecursiveModel;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.simulation.RecordedRows;
import org.mechservice.solver.simulation.RuntimeSolver;
import org.mechservice.solver.spatial.Blocks;
import org.mechservice.solver.spatial.EulerParameters;

/** The shared scenes without loops, in every formulation. */
class OpenTreeScenesTest {
  private static ExplicitModel model(String formulation, Mechanism scene, RunSettings settings) {
    UserForceSource none = UserForceSource.NONE;
    return switch (formulation) {
      case "DTR" -> new DataDrivenModel(scene, settings, none);
      case "DSR" -> new SemiRecursiveModel(scene, settings, none);
      case "RR" -> new RecursiveResidualModel(scene, settings, none);
      case "RR-JF" -> new LinearisedResidualModel(scene, settings, none, Mode.FULL);
      case "RR-JF forces" -> new LinearisedResidualModel(scene, settings, none, Mode.FORCES_ONLY);
      default -> throw new IllegalArgumentException(formulation);
    };
  }

  static Stream<Arguments> scenesWithAccelerations() {
    return Stream.of(
            "A01_simple_pendulum",
            "A05_flyball",
            "double_pendulum",
            "pendulum5",
            "driver_C0",
            "driver_CK100",
            "driver_free_C0",
            "driver_free_CK100",
            "dzhanibekov",
            "gimbal_q2_0.4",
            "massratio_1e8_root",
            "near_massless_0")
        .flatMap(name -> Stream.of("DTR", "DSR", "RR").map(form -> Arguments.of(name, form)));
  }

  /** Relative 1e-11 at the start, where the reference has its accelerations. */
  @MethodSource("scenesWithAccelerations")
  @ParameterizedTest
  void acceleratesAsTheReferenceDoes(String name, String formulation) {
    SharedScene scene = SharedScene.named(name);
    RunSettings settings = new RunSettings(0, 1, 1, "ode113", 1e-6, 1e-6);
    ExplicitModel model = model(formulation, scene.mechanism(), settings);
    SharedScene.ReferenceState start = scene.reference().get(0);
    double[] y = join(start.q(), start.v());
    double[] yDot = new double[y.length];
    assertThat(model.derivative(start.t(), y, yDot)).isEqualTo(ExplicitModel.REGULAR);
    double largest = 0;
    for (double a : start.a()) {
      largest = Math.max(largest, Math.abs(a));
    }
    assertThat(start.a()).hasSize(start.v().length);
    for (int i = 0; i < start.a().length; i++) {
      assertThat(yDot[start.q().length + i]).isCloseTo(start.a()[i], within(1e-11 * largest));
    }
  }

  /**
   * Bounds at rtol 1e-10: 1e-7 for the tumbling body, 1e-6 after 159 turns; 1000 rtol for the rest,
   * 1e4 rtol for the light chain on a heavy root, which is a whip, and for implicit formulas at
   * rtol 1e-8.
   */
  @CsvSource({
    "dzhanibekov, 5, DTR, ode113, 1e-10, 1e-12, 1e-7",
    "dzhanibekov, 5, DSR, ode113, 1e-10, 1e-12, 1e-7",
    "dzhanibekov, 5, DSR, DE, 1e-10, 1e-12, 1e-7",
    "dzhanibekov, 5, RR-JF, ode15sR, 1e-8, 1e-10, 1e-4",
    "high_spin_1e5_sym, 0.01, DTR, ode113, 1e-10, 1e-12, 1e-6",
    "high_spin_1e5_sym, 0.01, DSR, ode113, 1e-10, 1e-12, 1e-6",
    "gimbal_q2_0.4, 1, DTR, ode113, 1e-10, 1e-12, 1e-7",
    "gimbal_q2_0.4, 1, DSR, ode113, 1e-10, 1e-12, 1e-7",
    "gimbal_q2_0.4, 1, RR-JF, ode15sR, 1e-8, 1e-10, 1e-4",
    "massratio_1e8_root, 2, DTR, ode113, 1e-10, 1e-12, 1e-6",
    "massratio_1e8_root, 2, DSR, ode113, 1e-10, 1e-12, 1e-6",
    "massratio_1e8_root, 1, RR-JF, ode15sR, 1e-8, 1e-10, 1e-4",
    "near_massless_0, 2, DTR, ode113, 1e-10, 1e-12, 1e-7",
    "near_massless_0, 2, DSR, ode113, 1e-10, 1e-12, 1e-7",
    "near_massless_0, 2, RR-JF, ode15sR, 1e-8, 1e-10, 1e-4",
    "pendulum5, 1, RR, ode15sR, 1e-8, 1e-10, 1e-4",
    "pendulum5, 1, RR-JF, ode15sR, 1e-8, 1e-10, 1e-4",
    "pendulum5, 1, RR-JF forces, ode15sR, 1e-8, 1e-10, 1e-4",
    "driver_CK100, 0.05, RR, ode15sR, 1e-6, 1e-8, 1e-3",
    "driver_CK100, 0.05, RR-JF, ode15sR, 1e-6, 1e-8, 1e-3",
    "driver_CK100, 0.05, RR-JF forces, ode15sR, 1e-6, 1e-8, 1e-3",
  })
  @ParameterizedTest
  void endsWhereTheReferenceDoes(
      String name,
      double end,
      String formulation,
      String integrator,
      double rtol,
      double atol,
      double bound)
      throws IOException {
    SharedScene scene = SharedScene.named(name);
    RunSettings settings = new RunSettings(0, end, end, integrator, rtol, atol);
    RecordedRows recorded = new RecordedRows();
    RunReport report = run(model(formulation, scene.mechanism(), settings), settings, recorded);
    assertThat(report.outcome()).isEqualTo(new Outcome.Completed());
    SharedScene.ReferenceState reference =
        scene.reference().stream()
            .filter(state -> Math.abs(state.t() - end) < 1e-12)
            .findFirst()
            .orElseThrow();
    double[] expected = join(reference.q(), reference.v());
    double[] row = recorded.rows.get(recorded.rows.size() - 1);
    double worst = 0;
    for (int i = 0; i < expected.length; i++) {
      worst = Math.max(worst, Math.abs(row[1 + i] - expected[i]) / (1 + Math.abs(expected[i])));
    }
    assertThat(worst).isLessThan(bound);
  }

  /**
   * Energy and angular momentum of the tumbling body within 1e-9 at tolerance 1e-10; implicit
   * formulas, which damp, within 1000 rtol.
   */
  @CsvSource({"DTR, ode113, 1e-9", "DSR, DE, 1e-9", "RR-JF, ode15sR, 1e-7"})
  @ParameterizedTest
  void tumblingBodyKeepsEnergyAndAngularMomentum(
      String formulation, String integrator, double bound) throws IOException {
    SharedScene scene = SharedScene.named("dzhanibekov");
    RunSettings settings = new RunSettings(0, 5, 0.25, integrator, 1e-10, 1e-12);
    RecordedRows recorded = new RecordedRows();
    RunReport report = run(model(formulation, scene.mechanism(), settings), settings, recorded);
    assertThat(report.notes()).anyMatch(note -> note.code() == MessageCode.EULER_PARAMETER_NORM);
    double[] first = invariants(recorded.rows.get(0));
    for (double[] row : recorded.rows) {
      double[] now = invariants(row);
      assertThat(now[0]).isCloseTo(first[0], within(bound * first[0]));
      assertThat(now[1]).isCloseTo(first[1], within(bound * first[1]));
      double norm = row[1] * row[1] + row[2] * row[2] + row[3] * row[3] + row[4] * row[4];
      assertThat(Math.sqrt(norm)).isCloseTo(1, within(1e-12));
    }
  }

  /** Kinetic energy and length of the angular momentum of moments 1, 2, 3. */
  private static double[] invariants(double[] row) {
    double[] r = new double[9];
    EulerParameters.rotation(row, 1, r, 0);
    double[] omega = new double[3];
    Blocks.applyTransposed(r, 0, row, 5, omega, 0);
    double energy = 0;
    double square = 0;
    for (int i = 0; i < 3; i++) {
      energy += (i + 1) * omega[i] * omega[i] / 2;
      square += Math.pow((i + 1) * omega[i], 2);
    }
    return new double[] {energy, Math.sqrt(square)};
  }

  /** No force resists these at the start: the run ends before its first step, naming the joints. */
  @CsvSource({
    "gimbal_q2_1.5707963267948966, DTR, ode113, ja, jc",
    "gimbal_q2_1.5707963267948966, DSR, ode113, ja, jc",
    "gimbal_q2_1.5707963267948966, RR, ode15sR, ja, jc",
    "gimbal_q2_1.5707963267948966, RR-JF, ode15sR, ja, jc",
    "coaxial_massless, DTR, DE, ja, jb",
    "coaxial_massless, DSR, DE, ja, jb",
    "coaxial_massless, RR, ode15sR, ja, jb",
    "coaxial_massless, RR-JF, ode15sR, ja, jb"
  })
  @ParameterizedTest
  void singularInertiaEndsTheRunBeforeItsFirstStep(
      String name, String formulation, String integrator, String first, String second)
      throws IOException {
    SharedScene scene = SharedScene.named(name);
    RunSettings settings = new RunSettings(0, scene.end(), scene.end(), integrator, 1e-6, 1e-8);
    RecordedRows recorded = new RecordedRows();
    RunReport report = run(model(formulation, scene.mechanism(), settings), settings, recorded);
    assertThat(report.outcome()).isInstanceOf(Outcome.Failed.class);
    assertThat(((Outcome.Failed) report.outcome()).failure().message())
        .startsWith("N-002 t=0.0 s")
        .contains("joint \"" + first + "\" and joint \"" + second + "\"");
    assertThat(report.steps()).isZero();
  }

  private static RunReport run(ExplicitModel model, RunSettings settings, ResultSink sink)
      throws IOException {
    return new RuntimeSolver()
        .run(model, new RunRequest(settings, Set.of()), sink, new RunControl());
  }

  private static double[] join(double[] q, double[] v) {
    double[] y = new double[q.length + v.length];
    System.arraycopy(q, 0, y, 0, q.length);
    System.arraycopy(v, 0, y, q.length, v.length);
    return y;
  }
}
