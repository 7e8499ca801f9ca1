package org.mechservice.client.run;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.RunControl;

/** What computes a run on this machine, once. */
public interface LocalComputation extends AutoCloseable {
  /** Returns the parameters that may be set before the start, as the model was built. */
  List<TunableParameter> parameters();

  /**
   * Computes the run to its end.
   *
   * @param values numbers of parameters, by name, which may be set
   * @return outcome and report, without what only the client knows
   * @throws IllegalArgumentException if the settings do not fit the model; the message says why
   * @throws IOException if a row or a checkpoint cannot be kept
   */
  RunResult run(
      Map<String, String> values, ResultSink sink, RunControl control, Checkpoints checkpoints)
      throws IOException;

  /** Ends what is left of it. */
  @Override
  void close();
}
