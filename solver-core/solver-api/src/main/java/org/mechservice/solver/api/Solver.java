package org.mechservice.solver.api;

import java.io.IOException;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.StepwiseRun;

/**
 * Runs models. The runtime JAR offers its implementation as a service ({@link
 * java.util.ServiceLoader}), so that a client that has fetched it need not name any of its classes.
 */
public interface Solver {
  /**
   * Runs a model to the end of the requested interval, or until it fails or is stopped.
   *
   * @param model the model; its workspace is used, so it must not be in another run
   * @param request interval, tolerances, columns
   * @param sink receives the rows
   * @param control controls and monitors the run from other threads
   * @return the report; expected failures are outcomes, not exceptions
   * @throws IllegalArgumentException if the request does not fit the model (unknown integrator,
   *     columns it was built without, tolerances out of range); the message names the cause and the
   *     remedy
   * @throws IOException if the sink could not store a row
   */
  RunReport run(Model model, RunRequest request, ResultSink sink, RunControl control)
      throws IOException;

  /**
   * Runs a model as {@link #run(Model, RunRequest, ResultSink, RunControl)} does, and writes
   * checkpoints, or resumes from one. A resumed run passes the remaining rows to the sink; they and
   * the report's counts equal those of an uninterrupted run.
   *
   * @throws IllegalArgumentException also if the checkpoint is damaged, or belongs to another
   *     model, solver version or request; or if the model has an internal state that it cannot save
   * @throws IOException also if a checkpoint could not be stored
   * @throws UnsupportedOperationException if a checkpoint is given and this solver does not support
   *     checkpoints; such a solver writes none either
   */
  default RunReport run(
      Model model, RunRequest request, ResultSink sink, RunControl control, Checkpoints checkpoints)
      throws IOException {
    if (checkpoints.saved().isPresent()) {
      throw new UnsupportedOperationException("this solver knows no checkpoints");
    }
    return run(model, request, sink, control);
  }

  /**
   * Begins a run that advances from row to row and whose state may be changed at each.
   *
   * @param model the model; its workspace is used, so it must not be in another run
   * @param request its settings; the rows are its steps of communication
   * @param sink receives the rows
   * @param modelHash exact identification of the model, for saved runs
   * @throws IllegalArgumentException S-195 if the model is not integrated in time; also as {@link
   *     #run}
   * @throws IOException if the sink throws it
   * @throws UnsupportedOperationException if this solver takes no steps from outside
   */
  default StepwiseRun stepped(Model model, RunRequest request, ResultSink sink, String modelHash)
      throws IOException {
    throw new UnsupportedOperationException("this solver takes no steps from outside");
  }
}
