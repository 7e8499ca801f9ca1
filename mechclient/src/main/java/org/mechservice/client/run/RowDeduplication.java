package org.mechservice.client.run;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import org.mechservice.client.failure.ServerFailureException;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Passes each row of a run to a sink once, also if the run is computed again from its start on
 * another host.
 */
final class RowDeduplication implements ResultSink {
  private final ResultSink sink;
  private long known;
  private long toSkip;
  private double[] last = {};

  /**
   * @param taken number of rows that the caller has taken before
   */
  RowDeduplication(ResultSink sink, long taken) {
    this.sink = sink;
    known = taken;
  }

  @Override
  public void begin(List<Variable> columns) throws IOException {
    sink.begin(columns);
  }

  /** Prepares for rows that begin at the start of the run again. */
  void again() {
    toSkip = known;
  }

  /**
   * {@inheritDoc}
   *
   * @throws ServerFailureException with code S-118 if the last row known and its repetition differ
   */
  @Override
  public void row(double[] values) throws IOException {
    if (toSkip == 0) {
      sink.row(values);
      known++;
      if (last.length != values.length) {
        last = new double[values.length];
      }
      System.arraycopy(values, 0, last, 0, last.length);
      return;
    }
    toSkip--;
    if (toSkip == 0 && last.length > 0 && !Arrays.equals(values, last)) {
      throw new ServerFailureException(
          MessageCode.RUN_PLACED_AGAIN.code(),
          "the run gives other numbers on its new host than on the lost one at t="
              + last[0]
              + " s; start it anew, on hosts with the same version of MechService and of Java",
          "");
    }
  }
}
