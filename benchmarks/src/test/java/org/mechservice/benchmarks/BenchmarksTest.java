package org.mechservice.benchmarks;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.benchmarks.peer.PeerEvaluations;
import org.mechservice.benchmarks.peer.PeerJacobians;
import org.mechservice.benchmarks.peer.PeerModels;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.suite.Kepler;

/** What is measured does what its name says; nothing is timed here. */
class BenchmarksTest {
  @EnumSource
  @ParameterizedTest
  void methodReachesTheEndOfAnOrbit(ComparedIntegrator method) {
    ComparedIntegrator.Cost cost = method.run(StepOverhead.TOLERANCE).toEnd(new Kepler());
    assertThat(cost.steps()).isPositive();
    assertThat(cost.evaluations()).isGreaterThan(cost.steps());
  }

  @Test
  void overheadRunsAndEvaluationsAreOfTheSameProblem() {
    StepOverhead whole = new StepOverhead();
    whole.problem = "Hires";
    whole.method = ComparedIntegrator.ODE15S;
    whole.prepare();
    StepOverhead.Work work = new StepOverhead.Work();
    assertThat(whole.run(work).evaluations()).isPositive();
    assertThat(work.step).isPositive();
    RightHandSideCost one = new RightHandSideCost();
    one.problem = "Hires";
    one.prepare();
    assertThat(one.evaluate()).hasSize(8);
  }

  @ValueSource(strings = {"ODE113", "DE", "ODE15S", "SWITCHING"})
  @ParameterizedTest
  void integrationWithoutEndGoesOn(String method) {
    StepMemory memory = new StepMemory();
    memory.method = method;
    memory.begin();
    assertThat(memory.step()).isEqualTo(StepResult.ADVANCED);
  }

  @ValueSource(strings = {"pendulum", "driver", "chain20"})
  @ParameterizedTest
  void formulationsAgreeOnTheAccelerations(String scene) {
    Evaluations evaluations = new Evaluations();
    evaluations.scene = scene;
    evaluations.prepare();
    double[] articulated = evaluations.dtr().clone();
    double largest = 0;
    for (double rate : articulated) {
      largest = Math.max(largest, Math.abs(rate));
    }
    double[] composite = evaluations.dsr();
    for (int i = 0; i < articulated.length; i++) {
      // Two ways to solve the same equations: round-off grown by the condition of M.
      assertThat(composite[i] - articulated[i]).isCloseTo(0, within(largest));
    }
    assertThat(evaluations.jacobian()).isTrue();
    assertThat(evaluations.factorisation()).isTrue();
    for (double residual : evaluations.rr()) {
      assertThat(residual).isCloseTo(0, within(largest));
    }
  }

  private static Offset<Double> within(double largest) {
    return Offset.offset(1e-8 * (1 + largest));
  }

  @ValueSource(strings = {"DTR", "DSR", "RR", "RR-JF"})
  @ParameterizedTest
  void generatedCodeIsMeasuredAtTheScenesStart(String formulation) {
    GeneratedCode generated = new GeneratedCode();
    generated.scene = "pendulum";
    generated.formulation = formulation;
    generated.prepare();
    assertThat(generated.evaluation()).hasSize(10).doesNotContain(Double.NaN);
  }

  @ValueSource(strings = {"DTR", "DSR", "RR", "RR-JF"})
  @ParameterizedTest
  void modelIsGeneratedAndCompiledInItsFormulation(String formulation) {
    ModelBuilding building = new ModelBuilding();
    building.scene = "pendulum";
    building.formulation = formulation;
    building.prepare();
    assertThat(building.generation().formulation()).isEqualTo(formulation);
    assertThat(building.compilation().description().stateCount()).isEqualTo(10);
  }

  @Test
  void modelIsReadWhole() {
    ModelReading reading = new ModelReading();
    reading.scene = "pendulum";
    assertThat(reading.reading().mechanism().joints()).hasSize(5);
  }

  @Test
  void jacobiansAndFactorsOfAnImplicitStepAreThere() {
    ImplicitSteps steps = new ImplicitSteps();
    steps.scene = "pendulum";
    steps.prepare();
    assertThat(steps.jacobianAlongTheTree()).isTrue();
    assertThat(steps.factorsAlongTheTree()).isTrue();
    assertThat(steps.jacobianByDifferences()).hasSize(100).doesNotContain(Double.NaN);
    assertThat(steps.factorsOfDenseMatrix()).isNegative();
  }

  @ValueSource(strings = {"pend5", "pend5s", "driver41"})
  @ParameterizedTest
  void modelsForOtherProgramsAreWrittenAsTheyRead(String scene, @TempDir Path folder)
      throws IOException {
    PeerEvaluations evaluation = new PeerEvaluations();
    evaluation.scene = scene;
    evaluation.prepare();
    assertThat(evaluation.derivative()).doesNotContain(Double.NaN);
    PeerJacobians jacobian = new PeerJacobians();
    jacobian.scene = scene;
    jacobian.prepare();
    assertThat(jacobian.derivatives()).doesNotContain(Double.NaN);
    PeerModels.main(new String[] {folder.toString(), scene});
    assertThat(Files.readString(folder.resolve(scene + ".c")))
        .contains("int derivative(double t, double *y, double *yDot)")
        .doesNotContain("[]", "private", "Math.");
    assertThat(Files.readString(folder.resolve(scene + ".xml"))).contains("<joint type='hinge'");
  }
}
