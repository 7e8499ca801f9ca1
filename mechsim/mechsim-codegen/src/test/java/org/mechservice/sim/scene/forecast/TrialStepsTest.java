package org.mechservice.sim.scene.forecast;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.simulation.RuntimeSolver;

/** The first steps foresee the number of all within a factor of 2. */
class TrialStepsTest {
  private static final ResultSink NOWHERE =
      new ResultSink() {
        @Override
        public void begin(List<Variable> columns) {}

        @Override
        public void row(double[] values) {}
      };

  /** Two masses with x'' = −k(t) (x − x³/6 s) − c x' each, the second slower by a factor. */
  private record Masses(
      DoubleUnaryOperator stiffness, double damping, double hardening, double slower)
      implements ExplicitModel {
    @Override
    public ModelDescription description() {
      return new ModelDescription(
          "Masses",
          "DTR",
          List.of(new JointVariables("fast", JointType.P), new JointVariables("slow", JointType.P)),
          new RunSettings(0, 1, 1, "ode113", 1e-6, 1e-8));
    }

    @Override
    public void initialState(double[] y) {
      y[0] = 0.5;
      y[1] = 0.5;
      y[2] = 0;
      y[3] = 0;
    }

    @Override
    public int derivative(double t, double[] y, double[] yDot) {
      for (int i = 0; i < 2; i++) {
        double rate = i == 0 ? 1 : 1 / slower;
        yDot[i] = y[2 + i];
        double spring = y[i] + hardening * y[i] * y[i] * y[i];
        yDot[2 + i] = -rate * rate * stiffness.applyAsDouble(t) * spring - damping * y[2 + i];
      }
      return REGULAR;
    }
  }

  private static void foreseenWithinAFactorOfTwo(Masses model, String integrator) throws Exception {
    for (double tolerance : new double[] {1e-4, 1e-7}) {
      RunSettings settings = new RunSettings(0, 1, 1, integrator, tolerance, tolerance * 0.01);
      double step = TrialSteps.meanStep(model, settings).orElseThrow();
      RunReport whole =
          new RuntimeSolver()
              .run(model, new RunRequest(settings, Set.of()), NOWHERE, new RunControl());
      assertThat(whole.steps() * step)
          .as("steps over those foreseen, at %s", tolerance)
          .isBetween(0.5, 2.0);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"ode113", "DE", "ode15s", "switching"})
  void stepsOfAnOscillationOfSeveralFrequenciesAreForeseen(String integrator) throws Exception {
    foreseenWithinAFactorOfTwo(new Masses(t -> 2.5e7, 0, 0, 7.3), integrator);
  }

  /** Preloaded by its displacement far beyond where it is linear: it swings 11 times as fast. */
  @Test
  void stepsFarFromEquilibriumAreForeseen() throws Exception {
    foreseenWithinAFactorOfTwo(new Masses(t -> 2.5e5, 0, 500, 3), "ode113");
  }

  /** The amplitude grows by a factor of e⁵ = 148. */
  @Test
  void stepsOfAGrowingOscillationAreForeseen() throws Exception {
    foreseenWithinAFactorOfTwo(new Masses(t -> 2.5e7, -10, 0, 2), "ode113");
  }

  /** The stiffness grows to the fourfold, so that the step halves. */
  @Test
  void stepsThatBecomeShorterAreForeseen() throws Exception {
    foreseenWithinAFactorOfTwo(new Masses(t -> 2.5e7 * (1 + 3 * t), 0, 0, 2), "ode113");
  }

  /** After the decay, stability limits the steps. */
  @Test
  void stepsOfADampedMotionAreForeseen() throws Exception {
    foreseenWithinAFactorOfTwo(new Masses(t -> 2.5e7, 1e4, 0, 1), "ode113");
  }

  @Test
  void nothingIsForeseenOfARunThatEnds() {
    RunSettings settings = new RunSettings(0, 1e-3, 1, "ode113", 1e-6, 1e-8);
    assertThat(TrialSteps.meanStep(new Masses(t -> 1, 0, 0, 1), settings)).isEmpty();
  }
}
