package org.mechservice.study.run;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/** Mean, deviation and extremes of each output over the points so far, in their order (Welford). */
public final class StudyStatistics {
  private final List<StudyOutput> outputs;
  private final long[] count;
  private final double[] mean;
  private final double[] squares;
  private final double[] least;
  private final double[] largest;
  private int rows;
  private int failed;

  StudyStatistics(List<StudyOutput> outputs) {
    this.outputs = outputs;
    int n = outputs.size();
    count = new long[n];
    mean = new double[n];
    squares = new double[n];
    least = new double[n];
    largest = new double[n];
    Arrays.fill(least, Double.POSITIVE_INFINITY);
    Arrays.fill(largest, Double.NEGATIVE_INFINITY);
  }

  /**
   * Takes a point.
   *
   * @param values of the outputs; NaN where there is none; not looked at if it failed
   */
  void add(boolean hasFailed, double[] values) {
    rows++;
    failed += hasFailed ? 1 : 0;
    for (int i = 0; i < mean.length; i++) {
      double x = hasFailed ? outputs.get(i).failing().orElse(Double.NaN) : values[i];
      if (!Double.isNaN(x)) {
        count[i]++;
        double off = x - mean[i];
        mean[i] += off / count[i];
        squares[i] += off * (x - mean[i]);
        least[i] = Math.min(least[i], x);
        largest[i] = Math.max(largest[i], x);
      }
    }
  }

  /** Returns how many points were taken. */
  public int rows() {
    return rows;
  }

  /** Returns how many of them failed. */
  public int failed() {
    return failed;
  }

  long count(int output) {
    return count[output];
  }

  double mean(int output) {
    return mean[output];
  }

  private double deviation(int output) {
    return Math.sqrt(squares[output] / (count[output] - 1));
  }

  double standardError(int output) {
    return deviation(output) / Math.sqrt((double) count[output]);
  }

  /** Returns an object for each output that has values. */
  JsonArray json() {
    JsonArray all = new JsonArray();
    for (int i = 0; i < mean.length; i++) {
      JsonObject one = new JsonObject();
      one.addProperty("output", outputs.get(i).name());
      one.addProperty("unit", outputs.get(i).unit());
      one.addProperty("values", count[i]);
      outputs.get(i).failing().ifPresent(value -> one.addProperty("failing", value));
      if (count[i] > 0) {
        one.addProperty("mean", mean[i]);
        if (count[i] > 1) {
          one.addProperty("deviation", deviation(i));
          one.addProperty("standardError", standardError(i));
        }
        one.addProperty("min", least[i]);
        one.addProperty("max", largest[i]);
      }
      all.add(one);
    }
    return all;
  }

  /** Returns a line for each output that has values, for people to read. */
  public List<String> lines() {
    return IntStream.range(0, mean.length)
        .filter(i -> count[i] > 0)
        .mapToObj(
            i ->
                String.format(
                    Locale.ROOT,
                    "%s: mean %.6g%s, min %.6g, max %.6g %s, %d values",
                    outputs.get(i).name(),
                    mean[i],
                    count[i] > 1
                        ? String.format(
                            Locale.ROOT, " +- %.2g, deviation %.4g", standardError(i), deviation(i))
                        : "",
                    least[i],
                    largest[i],
                    outputs.get(i).unit(),
                    count[i]))
        .toList();
  }
}
