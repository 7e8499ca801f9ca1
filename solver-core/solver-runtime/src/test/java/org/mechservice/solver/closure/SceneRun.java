package org.mechservice.solver.closure;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.scenes.SharedScene;
import org.mechservice.solver.scenes.SharedScene.ReferenceState;
import org.mechservice.solver.simulation.RuntimeSolver;

/** A run of a model with its rows. */
final class SceneRun implements ResultSink {
  final List<double[]> rows = new ArrayList<>();
  final RunReport report;

  private SceneRun(
      Solver solver, Model model, RunSettings settings, boolean strict, OptionalDouble maxDrift) {
    try {
      report =
          solver.run(
              model, new RunRequest(settings, Set.of(), strict, maxDrift), this, new RunControl());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Runs a model as its own settings say. */
  static SceneRun of(Model model) {
    return new SceneRun(
        new RuntimeSolver(), model, model.description().defaults(), false, OptionalDouble.empty());
  }

  /** Likewise, by a solver of its own. */
  static SceneRun by(Solver solver, Model model) {
    RunSettings settings = model.description().defaults();
    return new SceneRun(solver, model, settings, false, OptionalDouble.empty());
  }

  /** Likewise, and the first warning ends it. */
  static SceneRun strict(Model model) {
    return new SceneRun(
        new RuntimeSolver(), model, model.description().defaults(), true, OptionalDouble.empty());
  }

  /** Likewise, and a drift of the energy balance above a part of its scale ends it. */
  static SceneRun watched(Model model, double maxDrift) {
    return new SceneRun(
        new RuntimeSolver(),
        model,
        model.description().defaults(),
        false,
        OptionalDouble.of(maxDrift));
  }

  /** Returns settings with an absolute tolerance of a hundredth of the relative one. */
  static RunSettings settings(
      double end, double step, String integrator, double relativeTolerance) {
    return new RunSettings(0, end, step, integrator, relativeTolerance, relativeTolerance / 100);
  }

  @Override
  public void begin(List<Variable> columns) {}

  @Override
  public void row(double[] values) {
    rows.add(values.clone());
  }

  /** Returns the row of a time. */
  double[] at(double t) {
    return rows.stream()
        .filter(row -> Math.abs(row[0] - t) < 1e-9)
        .findFirst()
        .orElseThrow(() -> new IllegalStateException("no row at " + t + ": " + report.outcome()));
  }

  /**
   * Returns the largest |q − reference| / (1 + |reference|) at the output times; Euler parameters
   * may have either sign.
   */
  double error(SharedScene scene) {
    double error = 0;
    for (ReferenceState state : scene.reference()) {
      double[] row = at(state.t());
      for (int i = 0; i < state.q().length; i++) {
        double reference = state.q()[i];
        error = Math.max(error, Math.abs(row[1 + i] - reference) / (1 + Math.abs(reference)));
      }
    }
    return error;
  }
}
