package org.mechservice.report;

import java.io.IOException;
import java.util.List;
import java.util.OptionalDouble;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;

/**
 * The bouncing ball in equal steps that follow the tolerance, exact but for its bounces: these it
 * sees at the ends of steps, and sets them right inside the step or not.
 */
final class SteppedBall implements Solver {
  private final boolean bouncesWhereItHits;

  SteppedBall(boolean bouncesWhereItHits) {
    this.bouncesWhereItHits = bouncesWhereItHits;
  }

  @Override
  public RunReport run(Model model, RunRequest request, ResultSink sink, RunControl control)
      throws IOException {
    RunSettings settings = request.settings();
    sink.begin(List.of(new Variable("t", "s"), new Variable("q", "m"), new Variable("v", "m/s")));
    double[] y = {EventScenes.HEIGHT, 0};
    int rows = (int) Math.rint((settings.tEnd() - settings.tStart()) / settings.tStep());
    int parts = (int) Math.ceil(Math.pow(settings.relativeTolerance(), -0.25));
    double h = (settings.tEnd() - settings.tStart()) / rows / parts;
    sink.row(new double[] {settings.tStart(), y[0], y[1]});
    for (int row = 1; row <= rows; row++) {
      for (int part = 0; part < parts; part++) {
        step(h, y);
      }
      double t = row == rows ? settings.tEnd() : settings.tStart() + row * settings.tStep();
      sink.row(new double[] {t, y[0], y[1]});
    }
    long steps = (long) rows * parts;
    return new RunReport(
        new Outcome.Completed(),
        "",
        "",
        settings,
        steps,
        0,
        steps,
        rows + 1L,
        settings.tEnd(),
        0,
        OptionalDouble.empty(),
        OptionalDouble.empty(),
        false,
        "");
  }

  private void step(double h, double[] y) {
    double[] from = y.clone();
    fall(h, y);
    if (y[0] >= 0 || y[1] >= 0) {
      return;
    }
    if (bouncesWhereItHits) {
      double g = EventScenes.GRAVITY;
      double hit = (from[1] + Math.sqrt(from[1] * from[1] + 2 * g * from[0])) / g;
      y[0] = 0;
      y[1] = -EventScenes.RESTITUTION * (from[1] - g * hit);
      fall(h - hit, y);
    } else {
      y[1] *= -EventScenes.RESTITUTION;
    }
  }

  private static void fall(double h, double[] y) {
    y[0] += h * y[1] - EventScenes.GRAVITY * h * h / 2;
    y[1] -= EventScenes.GRAVITY * h;
  }
}
