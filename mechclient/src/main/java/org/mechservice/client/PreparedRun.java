package org.mechservice.client;

import java.io.IOException;
import org.mechservice.solver.api.ResultSink;

/** A run that is ready to start, at the server or on this machine. */
public sealed interface PreparedRun extends AutoCloseable permits RemoteRun, LocalRun {
  /**
   * Runs to the end and puts out the rows as they arise.
   *
   * @param sink takes the rows
   * @return how the run ended and its report
   * @throws IOException if the sink cannot keep a row; the run is then cancelled
   * @throws ServiceException if the server is lost or refuses the run; the sink has the rows up to
   *     then
   */
  RunResult toEnd(ResultSink sink) throws IOException;

  /**
   * Asks the run to stop, from any thread; {@link #toEnd} then returns with the rows so far.
   *
   * @throws ServiceException if the server is lost
   */
  void cancel();

  /**
   * Returns how far the run is.
   *
   * @throws ServiceException if the server is lost
   */
  RunProgress progress();

  /** Gives up what the run holds. */
  @Override
  void close();
}
