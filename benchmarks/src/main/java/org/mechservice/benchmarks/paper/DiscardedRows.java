package org.mechservice.benchmarks.paper;

import java.util.List;
import org.mechservice.solver.api.ResultSink;
import org.mechservice.solver.api.Variable;

/** A sink that discards the rows. */
final class DiscardedRows implements ResultSink {
  @Override
  public void begin(List<Variable> columns) {}

  @Override
  public void row(double[] values) {}
}
