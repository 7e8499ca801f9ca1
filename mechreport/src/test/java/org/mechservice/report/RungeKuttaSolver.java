package org.mechservice.report;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.mechservice.solver.api.ExplicitModel;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.Outcome;
import org.mechservice.solver.api.ResultSink;
import org.mechservice.solver.api.RunControl;
import org.mechservice.solver.api.RunReport;
import org.mechservice.solver.api.RunRequest;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.Variable;

/**
 * The Runge-Kutta method of order 4 with equal steps that follow the tolerance: right if its last
 * weight is 1/6, and broken with any other.
 */
final class RungeKuttaSolver implements Solver {
  private final double lastWeight;

  RungeKuttaSolver(double lastWeight) {
    this.lastWeight = lastWeight;
  }

  @Override
  public RunReport run(Model model, RunRequest request, ResultSink sink, RunControl control)
      throws IOException {
    RunSettings settings = request.settings();
    ExplicitModel equations = (ExplicitModel) model;
    double[] y = new double[model.description().stateCount()];
    model.initialState(y);
    List<Variable> columns = new ArrayList<>(List.of(new Variable("t", "s")));
    columns.addAll(model.description().states());
    sink.begin(columns);
    int rows = (int) Math.rint((settings.tEnd() - settings.tStart()) / settings.tStep());
    int parts = (int) Math.ceil(settings.tStep() / Math.pow(settings.relativeTolerance(), 0.25));
    long steps = 0;
    write(sink, settings.tStart(), y);
    for (int row = 1; row <= rows; row++) {
      for (int part = 0; part < 2 * parts; part++) {
        step(equations, settings.tStep() / (2 * parts), y);
        steps++;
      }
      write(sink, settings.tStart() + row * settings.tStep(), y);
    }
    return new RunReport(
        new Outcome.Completed(),
        "",
        "",
        settings,
        steps,
        0,
        4 * steps,
        rows + 1L,
        settings.tEnd(),
        0,
        OptionalDouble.empty(),
        OptionalDouble.empty(),
        false,
        "");
  }

  private static void write(ResultSink sink, double t, double[] y) throws IOException {
    double[] row = new double[y.length + 1];
    row[0] = t;
    System.arraycopy(y, 0, row, 1, y.length);
    sink.row(row);
  }

  private void step(ExplicitModel equations, double h, double[] y) {
    double[] weights = {1.0 / 6, 1.0 / 3, 1.0 / 3, lastWeight};
    double[] places = {0, 0.5, 0.5, 1};
    double[] slope = new double[y.length];
    double[] stage = new double[y.length];
    double[] sum = y.clone();
    for (int i = 0; i < weights.length; i++) {
      for (int k = 0; k < y.length; k++) {
        stage[k] = y[k] + places[i] * h * slope[k];
      }
      equations.derivative(0, stage, slope);
      for (int k = 0; k < y.length; k++) {
        sum[k] += weights[i] * h * slope[k];
      }
    }
    System.arraycopy(sum, 0, y, 0, y.length);
  }
}
