package org.mechservice.solver.simulation;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
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
        ? tabulate(table, request, sink)
        : new States(parts, request, sink, control).toEnd();
  }

  private static RunReport tabulate(ResultTable table, RunRequest request, ResultSink sink)
      throws IOException {
    RunSettings settings = request.settings();
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
    List<RunNotes.Note> notes = notes(table, List.of(), request);
    Outcome outcome =
        result == ExplicitModel.REGULAR
            ? ofStrict(notes, request).orElseGet(Outcome.Completed::new)
            : failed(table, settings.tStart());
    return report(table, outcome, settings, 0, rows[0], settings.tStart(), begun, notes);
  }

  /** Returns the notes of a model and of its rows, but silenced ones. */
  private static List<RunNotes.Note> notes(
      Model model, List<RunNotes.Note> ofRows, RunRequest request) {
    List<RunNotes.Note> notes = new ArrayList<>();
    if (model instanceof RunNotes noted) {
      notes.addAll(noted.notes());
    }
    notes.addAll(ofRows);
    notes.removeIf(note -> request.silenced().contains(note.code()));
    return notes;
  }

  /** Returns the failure of a strict run with a warning. */
  private static Optional<Outcome> ofStrict(List<RunNotes.Note> notes, RunRequest request) {
    return notes.stream()
        .filter(note -> request.strict() && note.warning())
        .findFirst()
        .map(warning -> new Outcome.Failed(FailureText.ofStrict(warning)));
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
      List<RunNotes.Note> notes) {
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
    private final RunRequest request;
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
      this.request = request;
      settings = request.settings();
      reached = settings.tStart();
      rows = new RowWriter(model, parts.columns(), request, sink);
      y = new double[model.description().stateCount()];
    }

    RunReport toEnd() throws IOException {
      Outcome outcome = walk();
      return report(
          model, outcome, settings, model.iterations(), rows.rows(), reached, begun, notes());
    }

    private List<RunNotes.Note> notes() {
      return AnalysisSolver.notes(model, rows.notes(), request);
    }

    private Outcome walk() throws IOException {
      OutputTimes times = new OutputTimes(settings);
      model.begin(settings.tStart(), settings.tEnd());
      for (long row = 0; row < times.count(); row++) {
        double t = times.time(row);
        if (model.find(t, y) != ExplicitModel.REGULAR) {
          return failed(model, t);
        }
        Optional<Outcome> warned = ofStrict(notes(), request);
        if (warned.isPresent()) {
          return warned.get();
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
