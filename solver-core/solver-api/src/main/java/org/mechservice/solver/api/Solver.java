package org.mechservice.solver.api;

import java.io.IOException;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;

/**
 * Runs models. The runtime JAR offers its implementation as a service ({@link
 * java.util.ServiceLoader}), so that whoever fetched it needs no class of it by name.
 */
public interface Solver {
  /**
   * Runs a model to the end of the requested interval, or until it fails or is stopped.
   *
   * @param model the model; its workspace is used, so it must not be in another run
   * @param request interval, tolerances, columns
   * @param sink takes the rows
   * @param control steers and watches the run from other threads
   * @return what happened; expected failures are outcomes, not exceptions
   * @throws IllegalArgumentException if the request does not fit the model (unknown integrator,
   *     columns it was built without, tolerances out of range); the message says which and what to
   *     do
   * @throws IOException if the sink could not keep a row
   */
  RunReport run(Model model, RunRequest request, ResultSink sink, RunControl control)
      throws IOException;

  /**
   * Runs a model as {@link #run(Model, RunRequest, ResultSink, RunControl)} does, leaving
   * checkpoints on its way, or going on from one. A run that goes on hands the rows that are still
   * to come to the sink; they and the report's counts are those of a run that was never
   * interrupted.
   *
   * @throws IllegalArgumentException also if the checkpoint is damaged, or of another model, solver
   *     version or request; or if the model has a state of its own that it does not tell
   * @throws IOException also if a checkpoint could not be kept
   * @throws UnsupportedOperationException if there is a checkpoint to go on from and this solver
   *     knows none; such a solver leaves none either
   */
  default RunReport run(
      Model model, RunRequest request, ResultSink sink, RunControl control, Checkpoints checkpoints)
      throws IOException {
    if (checkpoints.saved().isPresent()) {
      throw new UnsupportedOperationException("this solver knows no checkpoints");
    }
    return run(model, request, sink, control);
  }
}
