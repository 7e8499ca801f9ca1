package org.mechservice.sim.model;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;

/** Keeps the columns and rows of a run. */
public final class KeptRows implements ResultSink {
  private final List<Variable> columns = new ArrayList<>();
  private final List<double[]> rows = new ArrayList<>();

  @Override
  public void begin(List<Variable> announced) {
    columns.addAll(announced);
  }

  @Override
  public void row(double[] values) {
    rows.add(values.clone());
  }

  public List<Variable> columns() {
    return columns;
  }

  public List<double[]> rows() {
    return rows;
  }
}
