package org.mechservice.client.run;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.guard.worker.WorkerDescription;
import org.mechservice.guard.worker.WorkerLostException;
import org.mechservice.guard.worker.WorkerModel;
import org.mechservice.guard.worker.WorkerOrder;
import org.mechservice.guard.worker.WorkerProcess;
import org.mechservice.guard.worker.WorkerResult;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.api.run.RunRequest;

/**
 * Computes in a process behind the walls: for a model whose classes come from somewhere else. Only
 * numbers and texts come back from there.
 *
 * @param worker the process, which has described the model
 * @param note that the report has besides those of the solver
 */
public record ConfinedComputation(
    WorkerProcess worker,
    WorkerModel model,
    WorkerDescription description,
    RunRequest request,
    Optional<RunNotes.Note> note)
    implements LocalComputation {
  @Override
  public List<TunableParameter> parameters() {
    return description.parameters();
  }

  @Override
  public RunResult run(
      Map<String, String> values, ResultSink sink, RunControl control, Checkpoints checkpoints)
      throws IOException {
    try {
      WorkerResult ended =
          worker.run(new WorkerOrder(model, values, request), sink, control, checkpoints);
      WorkerResult done = note.map(ended::with).orElse(ended);
      return new RunResult(done.outcome(), done.report());
    } catch (WorkerLostException lost) {
      return brokenOff(lost, control);
    }
  }

  /** A process that ignores the wish to stop is killed: then its run was stopped. */
  private static RunResult brokenOff(WorkerLostException lost, RunControl control) {
    Map<String, Object> report = new LinkedHashMap<>();
    if (control.stopRequested()) {
      report.put("outcome", "stopped");
      return new RunResult(new Outcome.Stopped(), report);
    }
    Failure failure =
        new Failure(
            lost.code(),
            String.valueOf(lost.getMessage()),
            Double.isNaN(control.time()) ? 0 : control.time(),
            control.stepSize(),
            control.order(),
            "",
            lost.advice() + " The rows up to then are kept.");
    report.put("outcome", "failed");
    report.put("failure", failure.message());
    return new RunResult(new Outcome.Failed(failure), report);
  }

  @Override
  public void close() {
    worker.close();
  }
}
