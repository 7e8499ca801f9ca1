package org.mechservice.result;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.mechservice.solver.api.result.Variable;

/** The rows of a table while a file is read row by row. */
final class GrowingTable {
  private static final int FIRST_ROWS = 1024;

  private final List<String> names;
  private final double[][] values;
  private int rows;

  GrowingTable(List<String> names) {
    this.names = names;
    values = new double[names.size()][FIRST_ROWS];
  }

  int columnCount() {
    return names.size();
  }

  /**
   * Appends a row.
   *
   * @param row as many numbers as there are columns, from the first element on
   * @param count how many it has
   * @throws IOException if it has too few or too many
   */
  void add(double[] row, int count) throws IOException {
    if (count != names.size()) {
      throw new IOException(
          "row " + (rows + 1) + " has " + count + " values for " + names.size() + " columns");
    }
    for (int i = 0; i < count; i++) {
      if (rows == values[i].length) {
        values[i] = Arrays.copyOf(values[i], 2 * rows);
      }
      values[i][rows] = row[i];
    }
    rows++;
  }

  /**
   * Returns the table.
   *
   * @param units by the names of columns; those it lacks are unknown
   */
  SignalTable table(Map<String, String> units) {
    List<Variable> columns = new ArrayList<>();
    List<double[]> trimmed = new ArrayList<>();
    for (int i = 0; i < names.size(); i++) {
      columns.add(new Variable(names.get(i), units.getOrDefault(names.get(i), "")));
      trimmed.add(Arrays.copyOf(values[i], rows));
    }
    return new SignalTable(columns, trimmed);
  }
}
