package org.mechservice.examples;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;

/**
 * A CSV result file, read back.
 *
 * @param columns the names of the header line
 * @param rows one row per output time, in the order of the columns
 */
record ResultRows(List<String> columns, List<List<Double>> rows) {

  static ResultRows read(Path csv) {
    try {
      List<String> lines = Files.readAllLines(csv);
      List<List<Double>> rows =
          lines.stream()
              .skip(1)
              .map(line -> Arrays.stream(line.split(",")).map(Double::valueOf).toList())
              .toList();
      return new ResultRows(List.of(lines.get(0).split(",")), rows);
    } catch (IOException e) {
      throw new AssertionError("no result file " + csv, e);
    }
  }

  /** Returns a column from the first output time to the last. */
  double[] column(String name) {
    int index = columns.indexOf(name);
    if (index < 0) {
      throw new AssertionError("no column " + name + " among " + columns);
    }
    return rows.stream().mapToDouble(row -> row.get(index)).toArray();
  }

  /**
   * Returns the largest |x − ref| / (1 + |ref|) over the columns and output times of a reference.
   *
   * @param reference its columns and times must all occur here
   * @param tLast output times up to here, s
   */
  double distanceTo(ResultRows reference, double tLast) {
    double largest = 0;
    for (List<Double> expected : reference.rows()) {
      double t = expected.get(0);
      if (t > tLast) {
        continue;
      }
      List<Double> row = rowAt(t);
      for (int i = 1; i < expected.size(); i++) {
        double ref = expected.get(i);
        double x = row.get(columns.indexOf(reference.columns().get(i)));
        largest = Math.max(largest, Math.abs(x - ref) / (1 + Math.abs(ref)));
      }
    }
    return largest;
  }

  /** Returns the row at a time, s. */
  List<Double> rowAt(double t) {
    // Output times are k * step: the nearest double to the reference's time is one rounding off.
    return rows.stream()
        .filter(row -> Math.abs(row.get(0) - t) < 1e-12)
        .findFirst()
        .orElseThrow(() -> new AssertionError("no row at t = " + t + " s"));
  }
}
