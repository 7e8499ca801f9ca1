package org.mechservice.solver.api.program;

import java.io.IOException;
import java.nio.DoubleBuffer;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.text.ResultFile;

/** The rows of a run, or of an analysis, with the names and units of their columns. */
public final class Trajectory {
  private static final int MOST_NAMES = 12;

  private final RowMemory table;
  private final RunReport report;

  /**
   * @param table all rows there will be
   * @param report what happened
   */
  public Trajectory(RowMemory table, RunReport report) {
    this.table = table;
    this.report = report;
  }

  /** Returns the columns in order, the first is time. */
  public List<Variable> columns() {
    return table.columns();
  }

  /** Returns how many rows there are. */
  public int rows() {
    return table.rows();
  }

  /** Returns the times of the rows, s. */
  public double[] time() {
    return column(0);
  }

  /**
   * Returns the values of a column, one number per row, in the unit that {@link #unit} says.
   *
   * @throws IllegalArgumentException if there is none of that name; lists those there are
   */
  public double[] column(String name) {
    return column(indexOf(name));
  }

  private double[] column(int index) {
    double[] values = new double[table.rows()];
    for (int i = 0; i < values.length; i++) {
      values[i] = table.get(i, index);
    }
    return values;
  }

  /**
   * Returns the SI unit of a column, {@code 1} for a pure number.
   *
   * @throws IllegalArgumentException if there is none of that name; lists those there are
   */
  public String unit(String name) {
    return columns().get(indexOf(name)).unit();
  }

  private int indexOf(String name) {
    List<Variable> columns = columns();
    for (int i = 0; i < columns.size(); i++) {
      if (columns.get(i).name().equals(name)) {
        return i;
      }
    }
    String known =
        columns.stream().limit(MOST_NAMES).map(Variable::name).collect(Collectors.joining(", "));
    String more =
        columns.size() > MOST_NAMES ? " and " + (columns.size() - MOST_NAMES) + " more" : "";
    throw new IllegalArgumentException(
        "there is no column \"" + name + "\"; there are " + known + more);
  }

  /**
   * Returns all values, row by row, without copying them: a direct buffer in the byte order of this
   * machine that ends with the last row. Its memory lives as long as the buffer.
   */
  public DoubleBuffer values() {
    return table.values();
  }

  /**
   * Writes the rows to a CSV file, and the units beside it in a file that ends in {@code
   * .units.json}, as {@code mech simulate} writes them.
   *
   * @throws IOException if it cannot be written
   */
  public void writeCsv(Path csv) throws IOException {
    try (ResultFile file = new ResultFile(csv)) {
      file.begin(columns());
      double[] row = new double[columns().size()];
      DoubleBuffer values = values();
      while (values.hasRemaining()) {
        values.get(row);
        file.row(row);
      }
      file.keep();
    }
  }

  /** Returns what happened: how it ended, its steps, its energy balance. */
  public RunReport report() {
    return report;
  }

  @Override
  public String toString() {
    return rows() + " rows of " + columns().size() + " columns of \"" + report.model() + "\"";
  }
}
