package org.mechservice.solver.simulation;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;

/** Keeps the rows of a run. */
public final class RecordedRows implements ResultSink {
  public final List<Variable> columns = new ArrayList<>();
  public final List<double[]> rows = new ArrayList<>();

  @Override
  public void begin(List<Variable> columns) {
    this.columns.addAll(columns);
  }

  @Override
  public void row(double[] values) {
    rows.add(values.clone());
  }
}
