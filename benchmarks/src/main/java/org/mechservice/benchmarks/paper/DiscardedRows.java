package org.mechservice.benchmarks.paper;

import java.util.List;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;

/** A sink that discards the rows. */
final class DiscardedRows implements ResultSink {
  @Override
  public void begin(List<Variable> columns) {}

  @Override
  public void row(double[] values) {}
}
