package org.mechservice.report;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;

/**
 * The Runge-Kutta method of order 4 with equal steps that follow the tolerance, or a broken one.
 */
final class RungeKuttaSolver implements Solver {
  /** What is wrong with a method. */
  enum Fault {
    NONE,
    /** The last weight is 0.16 for 1/6: nothing is integrated right, however short the steps. */
    WRONG_WEIGHT,
    /** The second stage lies at 0.4 for 0.5 of the step: order 1 for 4. */
    WRONG_STAGE,
    /** The error constant is too small: steps are eight times too long, of the right order. */
    WRONG_ERROR_CONSTANT,
    /** Rows between the steps' ends on a straight line: order 2 for 4, ends of steps exact. */
    LINEAR_DENSE_OUTPUT,
    /** Rows between the steps' ends by Hermite's cubic with slopes a tenth too small: order 1. */
    WRONG_SLOPES_IN_DENSE_OUTPUT
  }

  /** So that errors are about the tolerance for motions with slopes of about one. */
  private static final double STEP = 0.6;

  private final Fault fault;

  RungeKuttaSolver(Fault fault) {
    this.fault = fault;
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
    double interval = settings.tEnd() - settings.tStart();
    int rows = (int) Math.rint(interval / settings.tStep());
    double h = STEP * Math.pow(settings.relativeTolerance(), 0.25);
    h *= fault == Fault.WRONG_ERROR_CONSTANT ? 8 : 1;
    long steps = (long) Math.ceil(interval / h);
    h = interval / steps;
    write(sink, settings.tStart(), y);
    int row = 1;
    for (long i = 0; i < steps; i++) {
      double[] before = y.clone();
      step(equations, h, y);
      double end = i + 1 == steps ? interval : (i + 1) * h;
      for (; row < rows && row * settings.tStep() <= end; row++) {
        double part = (row * settings.tStep() - i * h) / h;
        write(
            sink,
            settings.tStart() + row * settings.tStep(),
            between(equations, before, y, h, part));
      }
    }
    write(sink, settings.tEnd(), y);
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

  /** Hermite's cubic through both ends of a step. */
  private double[] between(
      ExplicitModel equations, double[] from, double[] to, double h, double part) {
    double[] slopeFrom = new double[from.length];
    double[] slopeTo = new double[from.length];
    equations.derivative(0, from, slopeFrom);
    equations.derivative(0, to, slopeTo);
    double weight = fault == Fault.WRONG_SLOPES_IN_DENSE_OUTPUT ? 0.9 : 1;
    double[] y = new double[from.length];
    for (int k = 0; k < y.length; k++) {
      double line = from[k] + part * (to[k] - from[k]);
      double rise = to[k] - from[k];
      double bend =
          (1 - 2 * part) * rise
              + (part - 1) * h * weight * slopeFrom[k]
              + part * h * weight * slopeTo[k];
      y[k] = fault == Fault.LINEAR_DENSE_OUTPUT ? line : line + part * (part - 1) * bend;
    }
    return y;
  }

  private static void write(ResultSink sink, double t, double[] y) throws IOException {
    double[] row = new double[y.length + 1];
    row[0] = t;
    System.arraycopy(y, 0, row, 1, y.length);
    sink.row(row);
  }

  private void step(ExplicitModel equations, double h, double[] y) {
    double last = fault == Fault.WRONG_WEIGHT ? 0.16 : 1.0 / 6;
    double[] weights = {1.0 / 6, 1.0 / 3, 1.0 / 3, last};
    double[] places = {0, fault == Fault.WRONG_STAGE ? 0.4 : 0.5, 0.5, 1};
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
