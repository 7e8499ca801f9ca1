package org.mechservice.client.sweep;

import java.io.IOException;
import java.util.List;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.solver.api.result.Variable;

/** Hears of a sweep as it goes on; no two calls at once. */
public interface SweepListener {
  /**
   * The model was read and built as it is in its file.
   *
   * @param warnings about it
   * @param columns of the runs' rows
   * @throws IOException if the sweep is not to go on
   */
  void begins(List<ModelMessage> warnings, List<Variable> columns) throws IOException;

  /**
   * A point is finished.
   *
   * @param running how many others are under way
   * @throws IOException if the row cannot be kept; the sweep then ends
   */
  void finished(SweepRow row, int running) throws IOException;
}
