package org.mechservice.sim.scene.forecast;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.simulation.RuntimeSolver;

/**
 * The first steps of a run, taken to learn their length: how many steps an oscillation takes
 * depends on its amplitude, on the tolerances and on the method, and far from equilibrium its
 * frequency is not that of the linearised equations. The first half is left out, in which methods
 * begin at order 1 with small steps.
 */
final class TrialSteps extends RunControl {
  /** Enough for several periods at usual tolerances, in milliseconds for small mechanisms. */
  private static final long MOST = 2000;

  private static final ResultSink NOWHERE =
      new ResultSink() {
        @Override
        public void begin(List<Variable> columns) {}

        @Override
        public void row(double[] values) {}
      };

  private double halfTime;
  private double time;
  private long steps;

  private TrialSteps() {}

  /**
   * Returns the mean length of the steps of a run after its beginning, s; empty if it fails within
   * these steps, or ends.
   *
   * @param model the equations of the run; its internal state is used
   * @param settings of the run, with the name of an integrator for y' = f(t, y)
   */
  static OptionalDouble meanStep(ExplicitModel model, RunSettings settings) {
    double length = settings.tEnd() - settings.tStart();
    RunRequest request = new RunRequest(settings.withOutput(settings.tEnd(), length), Set.of());
    TrialSteps trial = new TrialSteps();
    try {
      new RuntimeSolver().run(model, request, NOWHERE, trial);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return trial.steps < MOST
        ? OptionalDouble.empty()
        : OptionalDouble.of((trial.time - trial.halfTime) / (trial.steps - MOST / 2));
  }

  @Override
  public boolean proceed(double time, double stepSize, int order, long steps) {
    this.time = time;
    this.steps = steps;
    if (steps == MOST / 2) {
      halfTime = time;
    }
    if (steps >= MOST) {
      stop();
    }
    return super.proceed(time, stepSize, order, steps);
  }
}
