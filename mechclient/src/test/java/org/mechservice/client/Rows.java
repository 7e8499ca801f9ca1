package org.mechservice.client;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;

/** Keeps what a run puts out. */
final class Rows implements ResultSink {
  List<Variable> columns = List.of();
  final List<double[]> rows = new ArrayList<>();

  @Override
  public void begin(List<Variable> columns) {
    this.columns = columns;
  }

  @Override
  public void row(double[] values) {
    rows.add(values.clone());
  }
}
