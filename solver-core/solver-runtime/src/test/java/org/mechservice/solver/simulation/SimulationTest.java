package org.mechservice.solver.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;

class SimulationTest {
  private final RecordedRows rows = new RecordedRows();
  private final RunControl control = new RunControl();

  /**
   * Tolerance 1e-10 over a third of a period: the global error stays within a hundred times that.
   */
  @ValueSource(strings = {"ode113", "DE"})
  @ParameterizedTest
  void rowsLieOnTheExactSolutionAtEveryOutputTime(String integrator) throws IOException {
    run(new HarmonicOscillator(), settings(integrator, 2, 0.25), Set.of());
    assertThat(rows.rows).hasSize(9);
    for (double[] row : rows.rows) {
      assertThat(row[1]).isCloseTo(StrictMath.cos(row[0]), within(1e-8));
      assertThat(row[2]).isCloseTo(-StrictMath.sin(row[0]), within(1e-8));
    }
  }

  @Test
  void columnsAreTimeThenPositionsThenVelocitiesThenWhatWasAskedFor() throws IOException {
    run(
        new HarmonicOscillator(),
        HarmonicOscillator.SETTINGS,
        EnumSet.of(ColumnGroup.ENERGY, ColumnGroup.ACCELERATIONS));
    assertThat(rows.columns)
        .extracting(Variable::name)
        .containsExactly(
            "t",
            "slide.q",
            "slide.v",
            "slide.a",
            "energy.kinetic",
            "energy.potential",
            "energy.work");
    assertThat(rows.columns)
        .extracting(Variable::unit)
        .containsExactly("s", "m", "m/s", "m/s^2", "J", "J", "J");
  }

  @Test
  void reportTellsTheEnergyDriftAgainstItsScale() throws IOException {
    RunReport report = run(new HarmonicOscillator(), HarmonicOscillator.SETTINGS, Set.of());
    assertThat(report.energyDrift().orElseThrow()).isLessThan(1e-9);
    assertThat(report.energyScale().orElseThrow()).isCloseTo(0.5, within(0.02));
  }

  @Test
  void modelWithoutEnergyHasNoEnergyInItsReport() throws IOException {
    RunReport report = run(withoutEnergy(), HarmonicOscillator.SETTINGS, Set.of());
    assertThat(report.asMap()).doesNotContainKey("energyDrift");
  }

  @Test
  void zeroLengthRunIsOneRow() throws IOException {
    RunReport report = run(new HarmonicOscillator(), settings("ode113", 0, 0.1), Set.of());
    assertThat(report.outcome()).isEqualTo(new Outcome.Completed());
    assertThat(rows.rows).hasSize(1);
  }

  @Test
  void columnGroupTheModelWasBuiltWithoutIsRefusedByName() {
    assertThatThrownBy(
            () ->
                run(
                    new HarmonicOscillator(),
                    HarmonicOscillator.SETTINGS,
                    Set.of(ColumnGroup.BODIES)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("bodies")
        .hasMessageContaining("mech build");
  }

  @Test
  void unknownIntegratorIsRefusedByName() {
    assertThatThrownBy(() -> run(new HarmonicOscillator(), settings("euler", 1, 0.1), Set.of()))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("euler");
  }

  @Test
  void endBeforeTheStartIsRefused() {
    assertThatThrownBy(() -> run(new HarmonicOscillator(), settings("DE", -1, 0.1), Set.of()))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("-1.0");
  }

  @Test
  void forcesThatBecomeInfiniteFailTheRunAndKeepTheRowsBefore() throws IOException {
    RunReport report =
        run(
            new HarmonicOscillator() {
              @Override
              public int derivative(double t, double[] y, double[] yDot) {
                super.derivative(t, y, yDot);
                yDot[1] /= t < 1 ? 1 : 0;
                return REGULAR;
              }
            },
            HarmonicOscillator.SETTINGS,
            Set.of());
    Outcome.Failed failed = (Outcome.Failed) report.outcome();
    assertThat(failed.failure().code()).isEqualTo(MessageCode.NOT_FINITE);
    assertThat(failed.failure().time()).isCloseTo(1, within(0.1));
    List<Failure.Step> steps = failed.failure().lastSteps();
    assertThat(steps).hasSize(10);
    assertThat(steps.get(9).result()).isEqualTo("a value was not finite");
    assertThat(("" + report.asMap().get("lastSteps")).lines().toList())
        .hasSize(10)
        .allSatisfy(line -> assertThat(line).matches("t=.* s, h=.* s, order \\d+.*: .*"));
    assertThat(rows.rows).hasSize(4);
    assertThat(rows.rows).allSatisfy(row -> assertThat(row[1]).isFinite());
  }

  @Test
  void numbersThatOverflowInARowAreToldWithTheStateThatHasGrown() throws IOException {
    RunReport report =
        run(
            new HarmonicOscillator() {
              @Override
              public int derivative(double t, double[] y, double[] yDot) {
                yDot[0] = y[1];
                yDot[1] = 1e6 * y[0];
                return REGULAR;
              }
            },
            HarmonicOscillator.SETTINGS,
            Set.of(ColumnGroup.ENERGY));
    Failure failure = ((Outcome.Failed) report.outcome()).failure();
    assertThat(failure.code()).isEqualTo(MessageCode.NOT_FINITE);
    assertThat(failure.part()).startsWith("column energy.");
    assertThat(failure.advice()).matches("The largest state is .*\\.v, .*E[12]\\d\\d: .*");
  }

  @Test
  void singularInertiaIsNamedByItsJointBeforeTheFirstRow() throws IOException {
    RunReport report =
        run(
            new HarmonicOscillator() {
              @Override
              public int derivative(double t, double[] y, double[] yDot) {
                return 0;
              }
            },
            HarmonicOscillator.SETTINGS,
            Set.of());
    Outcome.Failed failed = (Outcome.Failed) report.outcome();
    assertThat(failed.failure().code()).isEqualTo(MessageCode.SINGULAR_INERTIA);
    assertThat(failed.failure().part()).isEqualTo("joint \"slide\"");
    assertThat(rows.rows).isEmpty();
  }

  @Test
  void outputThatIsNotFiniteNeverReachesTheSink() throws IOException {
    RunReport report =
        run(
            new HarmonicOscillator() {
              @Override
              public void energy(double t, double[] y, double[] energy) {
                energy[0] = t > 0.6 ? Double.NaN : 0;
              }
            },
            HarmonicOscillator.SETTINGS,
            Set.of(ColumnGroup.ENERGY));
    Outcome.Failed failed = (Outcome.Failed) report.outcome();
    assertThat(failed.failure().part()).isEqualTo("column energy.kinetic");
    assertThat(rows.rows).hasSize(3);
  }

  @Test
  void stopEndsTheRunAndKeepsItsRows() throws IOException {
    RunReport report =
        run(
            new HarmonicOscillator() {
              @Override
              public int derivative(double t, double[] y, double[] yDot) {
                if (t > 1) {
                  control.stop();
                }
                return super.derivative(t, y, yDot);
              }
            },
            HarmonicOscillator.SETTINGS,
            Set.of());
    assertThat(report.outcome()).isEqualTo(new Outcome.Stopped());
    assertThat(rows.rows).isNotEmpty().hasSizeLessThan(9);
  }

  @Test
  void singleStepsAndPausesDoNotChangeTheRows() throws Exception {
    RecordedRows atOnce = new RecordedRows();
    new RuntimeSolver()
        .run(
            new HarmonicOscillator(),
            new RunRequest(HarmonicOscillator.SETTINGS, Set.of()),
            atOnce,
            new RunControl());
    control.pause();
    CompletableFuture<RunReport> run =
        CompletableFuture.supplyAsync(
            () -> {
              try {
                return run(new HarmonicOscillator(), HarmonicOscillator.SETTINGS, Set.of());
              } catch (IOException e) {
                throw new UncheckedIOException(e);
              }
            });
    for (long steps = 1; steps <= 3; steps++) {
      assertThat(control.awaitHeld(10_000)).isTrue();
      control.step();
      while (control.steps() < steps) {
        Thread.onSpinWait();
      }
    }
    assertThat(control.awaitHeld(10_000)).isTrue();
    control.resumeTo(1);
    while (control.time() < 1) {
      Thread.onSpinWait();
    }
    assertThat(control.awaitHeld(10_000)).isTrue();
    control.resume();
    run.get(10, TimeUnit.SECONDS);
    assertThat(rows.rows).hasSameSizeAs(atOnce.rows);
    for (int i = 0; i < rows.rows.size(); i++) {
      assertThat(rows.rows.get(i)).containsExactly(atOnce.rows.get(i));
    }
  }

  private RunReport run(Model model, RunSettings settings, Set<ColumnGroup> columns)
      throws IOException {
    return new RuntimeSolver().run(model, new RunRequest(settings, columns), rows, control);
  }

  private static RunSettings settings(String integrator, double tEnd, double tStep) {
    return new RunSettings(0, tEnd, tStep, integrator, 1e-10, 1e-12);
  }

  private static Model withoutEnergy() {
    HarmonicOscillator oscillator = new HarmonicOscillator();
    return new ExplicitModel() {
      @Override
      public ModelDescription description() {
        return oscillator.description();
      }

      @Override
      public void initialState(double[] y) {
        oscillator.initialState(y);
      }

      @Override
      public int derivative(double t, double[] y, double[] yDot) {
        return oscillator.derivative(t, y, yDot);
      }
    };
  }
}
