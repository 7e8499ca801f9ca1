package org.mechservice.solver.simulation;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.capability.AlgebraicModel;
import org.mechservice.solver.api.capability.Defects;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.ResultTable;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;

/** Runs models without integration: a sequence of states, or one table. */
public final class AnalysisSolver implements Solver {
  /** Returns whether this solver can run a model. */
  public static boolean takes(Model model) {
    Model equations = ModelParts.of(model).equations();
    return equations instanceof AlgebraicModel || equations instanceof ResultTable;
  }

  @Override
  public RunReport run(Model model, RunRequest request, ResultSink sink, RunControl control)
      throws IOException {
    OutputTimes.requireUsable(request.settings());
    if (request.maxDrift().isPresent()) {
      throw EnergyMonitor.unbalanced(model, "is not integrated");
    }
    ModelParts parts = ModelParts.of(model);
    return parts.equations() instanceof ResultTable table
        ? tabulate(table, request.settings(), sink)
        : new States(parts, request, sink, control).toEnd();
  }

  private static RunReport tabulate(ResultTable table, RunSettings settings, ResultSink sink)
      throws IOException {
    long begun = System.nanoTime();
    long[] rows = {0};
    sink.begin(table.columns());
    int result =
        table.tabulate(
            settings.tStart(),
            new ResultSink() {
              @Override
              public void begin(List<Variable> columns) {}

              @Override
              public void row(double[] values) throws IOException {
                sink.row(values);
                rows[0]++;
              }
            });
    Outcome outcome =
        result == ExplicitModel.REGULAR
            ? new Outcome.Completed()
            : failed(table, settings.tStart());
    return report(table, outcome, settings, 0, rows[0], settings.tStart(), begun, List.of());
  }

  private static Outcome failed(Defects model, double t) {
    return new Outcome.Failed(FailureText.of(model.lastDefect(), t, 0, 0));
  }

  private static RunReport report(
      Model model,
      Outcome outcome,
      RunSettings settings,
      long iterations,
      long rows,
      double reached,
      long begun,
      List<RunNotes.Note> ofRows) {
    List<RunNotes.Note> notes = new ArrayList<>(ofRows);
    if (model instanceof RunNotes noted) {
      notes.addAll(0, noted.notes());
    }
    return new RunReport(
        outcome,
        model.description().name(),
        model.description().formulation(),
        settings,
        iterations,
        0,
        iterations,
        rows,
        reached,
        (System.nanoTime() - begun) * 1e-9,
        OptionalDouble.empty(),
        OptionalDouble.empty(),
        false,
        0,
        0,
        List.of(),
        notes,
        SolverVersion.CURRENT);
  }

  /** States at all output times. */
  private static final class States {
    private final AlgebraicModel model;
    private final RunSettings settings;
    private final RunControl control;
    private final RowWriter rows;
    private final double[] y;
    private final long begun = System.nanoTime();
    private double reached;

    States(ModelParts parts, RunRequest request, ResultSink sink, RunControl control)
        throws IOException {
      model = (AlgebraicModel) parts.equations();
      this.control = control;
      settings = request.settings();
      reached = settings.tStart();
      rows = new RowWriter(model, parts.columns(), request, sink);
      y = new double[model.description().stateCount()];
    }

    RunReport toEnd() throws IOException {
      Outcome outcome = walk();
      return report(
          model, outcome, settings, model.iterations(), rows.rows(), reached, begun, rows.notes());
    }

    private Outcome walk() throws IOException {
      OutputTimes times = new OutputTimes(settings);
      for (long row = 0; row < times.count(); row++) {
        double t = times.time(row);
        if (model.find(t, y) != ExplicitModel.REGULAR) {
          return failed(model, t);
        }
        int column = rows.write(t, y);
        if (column != RowWriter.ALL_FINITE) {
          return new Outcome.Failed(
              FailureText.notFiniteColumn(t, rows.columnName(column), rows.largestState()));
        }
        reached = t;
        if (!control.proceed(t, settings.tStep(), 0, row + 1)) {
          return new Outcome.Stopped();
        }
      }
      return new Outcome.Completed();
    }
  }
}
