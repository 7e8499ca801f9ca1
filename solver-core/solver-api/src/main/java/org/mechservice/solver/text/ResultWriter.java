package org.mechservice.solver.text;

import java.io.Closeable;
import java.io.IOException;
import org.mechservice.solver.api.result.ResultSink;

/**
 * Writes the rows of one run in one file format. The order of calls is {@link #begin}, any number
 * of {@link #row}, {@link #finish}, {@link #close}; close alone gives the rows up.
 */
public interface ResultWriter extends ResultSink, Closeable {
  /**
   * Writes what the format needs after the last row; the bytes written so far are then a complete
   * file.
   *
   * @throws IOException if they cannot be written
   */
  void finish() throws IOException;
}
