package org.mechservice.solver.api.result;

import java.io.IOException;
import java.util.List;

/** Takes the rows of a run as they arise. */
public interface ResultSink {
  /**
   * Announces the columns, before the first row.
   *
   * @throws IOException if the results cannot be kept
   */
  void begin(List<Variable> columns) throws IOException;

  /**
   * Takes one row.
   *
   * @param values one number per column, the first is time; valid during the call only
   * @throws IOException if the row cannot be kept
   */
  void row(double[] values) throws IOException;
}
