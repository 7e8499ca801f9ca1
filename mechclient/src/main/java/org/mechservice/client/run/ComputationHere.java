package org.mechservice.client.run;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;

/**
 * Computes in this process: for a model that this program has generated, or whose solver it has
 * accepted.
 *
 * @param note that the report has besides those of the solver
 */
public record ComputationHere(
    ModelSource source, Solver solver, RunRequest request, Optional<RunNotes.Note> note)
    implements LocalComputation {
  @Override
  public List<TunableParameter> parameters() {
    return source.parameters();
  }

  @Override
  public RunResult run(
      Map<String, String> values, ResultSink sink, RunControl control, Checkpoints checkpoints)
      throws IOException {
    RunReport ended = solver.run(source.model(values), request, sink, control, checkpoints);
    RunReport done = note.map(ended::with).orElse(ended);
    return new RunResult(done.outcome(), done.asMap());
  }

  @Override
  public void close() {}
}
