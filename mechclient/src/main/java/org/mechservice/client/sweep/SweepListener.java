package org.mechservice.client.sweep;

import java.io.IOException;
import java.util.List;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.solver.api.result.Variable;

/** Receives the rows of a sweep; calls do not overlap. */
public interface SweepListener {
  /**
   * The model was read and built with the values of its file.
   *
   * @param warnings about it
   * @param columns of the runs' rows
   * @throws IOException to end the sweep
   */
  void begins(List<ModelMessage> warnings, List<Variable> columns) throws IOException;

  /**
   * A point is finished.
   *
   * @param running number of other runs in progress
   * @throws IOException if the row cannot be stored; the sweep then ends
   */
  void finished(SweepRow row, int running) throws IOException;
}
