package org.mechservice.solver.api.result;

import java.io.IOException;
import java.util.List;

/** Receives the rows of a run as they are computed. */
public interface ResultSink {
  /**
   * Receives the columns, before the first row.
   *
   * @throws IOException if the results cannot be stored
   */
  void begin(List<Variable> columns) throws IOException;

  /**
   * Receives one row.
   *
   * @param values one number per column, the first is time; valid during the call only
   * @throws IOException if the row cannot be stored
   */
  void row(double[] values) throws IOException;
}
