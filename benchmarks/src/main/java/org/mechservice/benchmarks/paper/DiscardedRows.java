package org.mechservice.benchmarks.paper;

import java.util.List;
import org.mechservice.solver.api.ResultSink;
import org.mechservice.solver.api.Variable;

/** Takes rows nobody wants. */
final class DiscardedRows implements ResultSink {
  @Override
  public void begin(List<Variable> columns) {}

  @Override
  public void row(double[] values) {}
}
