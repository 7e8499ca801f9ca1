package org.mechservice.study.run;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.mechservice.solver.text.ShortestDecimal;

/**
 * Mean, deviation and extremes of each output over the points so far, in their order (Welford); its
 * quantiles and, for a design of indices, the part of its variance that each factor causes.
 *
 * <p>Quantiles and indices need all values: they are kept up to {@link #MOST_KEPT}, 8 bytes each.
 */
public final class StudyStatistics {
  static final int MOST_KEPT = 4_000_000;
  private static final int FIRST_KEPT = 64;
  private static final double[] QUANTILES = {0.05, 0.25, 0.5, 0.75, 0.95};

  /** Factors of a design of indices; empty for others. */
  private final List<String> factors;

  /** Values of each output by row, NaN where there is none; empty if they are too many. */
  private double[][] kept;

  private final List<StudyOutput> outputs;
  private final long[] count;
  private final double[] mean;
  private final double[] squares;
  private final double[] least;
  private final double[] largest;
  private int rows;
  private int failed;

  StudyStatistics(List<StudyOutput> outputs) {
    this(outputs, List.of());
  }

  /**
   * @param factors of a design of indices, whose points these are from the first on; empty for
   *     others
   */
  StudyStatistics(List<StudyOutput> outputs, List<String> factors) {
    this.outputs = outputs;
    this.factors = List.copyOf(factors);
    kept = new double[outputs.size()][FIRST_KEPT];
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
    if (kept.length > 0 && (long) (rows + 1) * kept.length > MOST_KEPT) {
      kept = new double[0][];
    }
    rows++;
    failed += hasFailed ? 1 : 0;
    for (int i = 0; i < mean.length; i++) {
      double x = hasFailed ? outputs.get(i).failing().orElse(Double.NaN) : values[i];
      keep(i, x);
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

  private void keep(int output, double x) {
    if (kept.length == 0) {
      return;
    }
    if (rows > kept[output].length) {
      kept[output] = Arrays.copyOf(kept[output], 2 * kept[output].length);
    }
    kept[output][rows - 1] = x;
  }

  /** Returns the values of an output in rising order; none if they were too many. */
  private double[] sorted(int output) {
    return kept.length == 0
        ? new double[0]
        : Arrays.stream(kept[output], 0, rows).filter(x -> !Double.isNaN(x)).sorted().toArray();
  }

  /**
   * Returns a quantile of sorted values, straight between two of them (Hyndman and Fan 1996, number
   * 7).
   */
  private static double quantile(double[] sorted, double part) {
    double place = part * (sorted.length - 1);
    int below = (int) place;
    int above = Math.min(below + 1, sorted.length - 1);
    return sorted[below] + (place - below) * (sorted[above] - sorted[below]);
  }

  /** Returns the indices of an output by all factors; none if the design has none. */
  List<SobolIndices> indices(int output) {
    return factors.isEmpty() || kept.length == 0
        ? List.of()
        : SobolIndices.of(kept[output], rows, factors.size());
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
        double[] sorted = sorted(i);
        if (sorted.length > 1) {
          JsonObject quantiles = new JsonObject();
          for (double part : QUANTILES) {
            quantiles.addProperty(ShortestDecimal.format(part), quantile(sorted, part));
          }
          one.add("quantiles", quantiles);
        }
      }
      JsonArray indices = new JsonArray();
      List<SobolIndices> found = indices(i);
      for (int k = 0; k < found.size(); k++) {
        JsonObject index = new JsonObject();
        index.addProperty("factor", factors.get(k));
        index.addProperty("first", found.get(k).first());
        index.addProperty("firstError", found.get(k).firstError());
        index.addProperty("total", found.get(k).total());
        index.addProperty("totalError", found.get(k).totalError());
        indices.add(index);
      }
      if (!indices.isEmpty()) {
        one.add("indices", indices);
      }
      all.add(one);
    }
    return all;
  }

  /**
   * Returns lines for each output that has values, for people to read: mean and spread, quantiles,
   * and indices by factor.
   */
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    for (int i = 0; i < mean.length; i++) {
      if (count[i] > 0) {
        lines.add(line(i));
      }
      List<SobolIndices> found = indices(i);
      for (int k = 0; k < found.size(); k++) {
        SobolIndices index = found.get(k);
        lines.add(
            String.format(
                Locale.ROOT,
                "  of its variance by %s: alone %.3f +- %.2g, with interactions %.3f +- %.2g",
                factors.get(k),
                index.first(),
                index.firstError(),
                index.total(),
                index.totalError()));
      }
    }
    return lines;
  }

  private String line(int i) {
    double[] sorted = sorted(i);
    String spread =
        count[i] > 1
            ? String.format(Locale.ROOT, " +- %.2g, deviation %.4g", standardError(i), deviation(i))
            : "";
    String quantiles =
        sorted.length > 1
            ? String.format(
                Locale.ROOT,
                ", 5 %% %.6g, median %.6g, 95 %% %.6g",
                quantile(sorted, 0.05),
                quantile(sorted, 0.5),
                quantile(sorted, 0.95))
            : "";
    return String.format(
        Locale.ROOT,
        "%s: mean %.6g%s, min %.6g%s, max %.6g %s, %d values",
        outputs.get(i).name(),
        mean[i],
        spread,
        least[i],
        quantiles,
        largest[i],
        outputs.get(i).unit(),
        count[i]);
  }
}
