package org.mechservice.solver.scenes;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.dynamics.LinearisedResidualModel;
import org.mechservice.solver.dynamics.RecursiveResidualModel;
import org.mechservice.solver.dynamics.SemiRecursiveModel;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.scenes.SharedScene.ReferenceState;
import org.mechservice.solver.simulation.RuntimeSolver;

/** A run of an open scene in one formulation, compared with its reference. */
final class OpenSceneRun implements ResultSink {
  private final SharedScene scene;
  private final List<double[]> rows = new ArrayList<>();
  private final RunReport report;

  private OpenSceneRun(SharedScene scene, String formulation, RunSettings settings) {
    this.scene = scene;
    Model model = model(scene.mechanism(), formulation, settings);
    RunRequest request = new RunRequest(settings, Set.of());
    try {
      report = new RuntimeSolver().run(model, request, this, new RunControl());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns a scene's model in a formulation. */
  static ExplicitModel model(Mechanism mechanism, String formulation, RunSettings settings) {
    return switch (formulation) {
      case "DTR" -> new DataDrivenModel(mechanism, settings, UserForceSource.NONE);
      case "DSR" -> new SemiRecursiveModel(mechanism, settings, UserForceSource.NONE);
      case "RR" -> new RecursiveResidualModel(mechanism, settings, UserForceSource.NONE);
      case "RR-JF" ->
          new LinearisedResidualModel(
              mechanism, settings, UserForceSource.NONE, LinearisedResidualModel.Mode.FULL);
      case "RR-JF forces" ->
          new LinearisedResidualModel(
              mechanism, settings, UserForceSource.NONE, LinearisedResidualModel.Mode.FORCES_ONLY);
      default -> throw new IllegalArgumentException(formulation);
    };
  }

  /**
   * Runs a scene to its end, or to a time before it.
   *
   * @param step distance of the rows, which must meet the reference's times, s
   */
  static OpenSceneRun of(
      SharedScene scene,
      String formulation,
      String integrator,
      double tolerance,
      double end,
      double step) {
    RunSettings settings = new RunSettings(0, end, step, integrator, tolerance, tolerance / 100);
    return new OpenSceneRun(scene, formulation, settings);
  }

  RunReport report() {
    return report;
  }

  @Override
  public void begin(List<Variable> columns) {}

  @Override
  public void row(double[] values) {
    rows.add(values.clone());
  }

  /** Returns the largest |q − reference| / (1 + |reference|) at the output times reached. */
  double error() {
    double error = 0;
    double end = rows.get(rows.size() - 1)[0];
    for (ReferenceState state : scene.reference()) {
      if (state.t() <= end + 1e-9) {
        error = Math.max(error, error(state));
      }
    }
    return error;
  }

  private double error(ReferenceState state) {
    double[] row =
        rows.stream()
            .filter(r -> Math.abs(r[0] - state.t()) < 1e-9)
            .findFirst()
            .orElseThrow(() -> new IllegalStateException("no row at " + state.t()));
    double error = 0;
    for (int i = 0; i < state.q().length; i++) {
      double reference = state.q()[i];
      error = Math.max(error, Math.abs(row[1 + i] - reference) / (1 + Math.abs(reference)));
    }
    return error;
  }
}
