package org.mechservice.client.run;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import org.mechservice.client.failure.InvalidOptionException;
import org.mechservice.client.failure.InvalidStateException;
import org.mechservice.client.failure.NotAvailableException;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.result.ResultSink;

/** A run that is ready to start, at the server or on this machine. */
public sealed interface PreparedRun extends AutoCloseable permits RemoteRun, LocalRun {
  /**
   * Returns the parameters that may be set before the start, with their present values.
   *
   * @throws ServiceException if the server is lost
   */
  List<TunableParameter> parameters();

  /**
   * Sets parameters before the start; those set earlier stay.
   *
   * @param values numbers by the parameters' names, in their units
   * @throws InvalidOptionException if a parameter was settled when the model was built (S-125), or
   *     a value is no number (S-126)
   * @throws InvalidStateException if the run was started
   */
  void setParameters(Map<String, String> values);

  /**
   * Runs to the end and passes each row on when it is computed.
   *
   * @param sink receives the rows
   * @return outcome and report of the run
   * @throws IOException if the sink cannot store a row; the run is then cancelled
   * @throws ServiceException if the server is lost or refuses the run; the sink has the rows up to
   *     then
   */
  default RunResult toEnd(ResultSink sink) throws IOException {
    return toEnd(sink, CheckpointStore.NONE);
  }

  /**
   * Runs to the end as {@link #toEnd(ResultSink)} does, and writes checkpoints during the run and
   * when it is stopped, or resumes from one, with only the rows after it.
   *
   * @param store stores the checkpoints
   * @throws InvalidOptionException also if the checkpoint is damaged, or of another model, solver
   *     version or request
   * @throws NotAvailableException if checkpoints are wanted and the model cannot be saved
   * @throws IOException also if a checkpoint cannot be stored
   */
  RunResult toEnd(ResultSink sink, CheckpointStore store) throws IOException;

  /**
   * Requests the run to stop, from any thread; {@link #toEnd} then returns with the rows so far.
   *
   * @throws ServiceException if the server is lost
   */
  void cancel();

  /**
   * Returns the progress of the run.
   *
   * @throws ServiceException if the server is lost
   */
  RunProgress progress();

  /** Releases the objects of the run. */
  @Override
  void close();
}
