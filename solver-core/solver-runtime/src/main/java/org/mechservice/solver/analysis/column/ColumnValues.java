package org.mechservice.solver.analysis.column;

import java.util.List;
import org.mechservice.solver.api.result.Variable;

/** One group of result columns, read from equations of motion that have been balanced. */
interface ColumnValues {
  /** Returns name and unit of each column. */
  List<Variable> columns();

  /**
   * Writes the values.
   *
   * @param t time, s
   * @param values as many as there are columns, from {@code at}; overwritten
   */
  void write(double t, double[] values, int at);
}
