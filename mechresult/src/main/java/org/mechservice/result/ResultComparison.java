package org.mechservice.result;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.TreeSet;
import org.mechservice.solver.api.result.Variable;

/**
 * Compares two results signal by signal.
 *
 * <p>A signal of one result is the broken line through its rows. Around every point of one result
 * the other must come as near as the tolerances allow: within the time tolerance it must take a
 * value whose distance is at most the tolerance times the size of the signal. So a jump that comes
 * a little earlier is no difference. Both results are the reference once, so that neither may have
 * a peak that the other lacks, and the order of the two does not matter.
 *
 * <p>The size of a signal is the range of its values in both results. Where that is less than a
 * hundredth of its largest absolute value, that hundredth is its size, and it is at least 1e-9 of
 * the largest value among the signals of the same unit, so that rounding errors of a signal that is
 * zero are no difference.
 */
public final class ResultComparison {
  private static final double SMALLEST_RANGE = 0.01;
  private static final double ROUNDING = 1e-9;

  private final double tolerance;
  private final double timeTolerance;
  private final List<SignalDifference> signals = new ArrayList<>();
  private final List<String> remarks = new ArrayList<>();

  private ResultComparison(double tolerance, double timeTolerance) {
    this.tolerance = tolerance;
    this.timeTolerance = timeTolerance;
  }

  /**
   * Compares two results over the time that both have.
   *
   * @param tolerance allowed difference relative to the size of a signal, 0 or more
   * @param timeTolerance allowed shift in time, s, 0 or more; empty: the tolerance times the
   *     duration of the longer result
   */
  public static ResultComparison of(
      SignalTable first, SignalTable second, double tolerance, OptionalDouble timeTolerance) {
    double duration = Math.max(duration(first), duration(second));
    ResultComparison comparison =
        new ResultComparison(tolerance, timeTolerance.orElse(tolerance * duration));
    comparison.compareColumns(first, second);
    if (first.rows() == 0 || second.rows() == 0) {
      if (first.rows() != second.rows()) {
        comparison.remarks.add(
            "the " + (first.rows() == 0 ? "first" : "second") + " result has no rows");
      }
      return comparison;
    }
    comparison.compareIntervals(first.time(), second.time());
    comparison.compareSignals(first, second);
    return comparison;
  }

  private static double duration(SignalTable table) {
    return table.rows() == 0 ? 0 : table.time()[table.rows() - 1] - table.time()[0];
  }

  /** Returns the allowed shift in time, s. */
  public double timeTolerance() {
    return timeTolerance;
  }

  /** Returns the signals that both results have, the one that differs most first. */
  public List<SignalDifference> signals() {
    return List.copyOf(signals);
  }

  /** Returns whether a signal differs by more than the tolerance. */
  public boolean differs(SignalDifference signal) {
    return !(signal.relative() <= tolerance);
  }

  /** Returns what else differs: columns, units, the interval; one sentence each. */
  public List<String> remarks() {
    return List.copyOf(remarks);
  }

  /** Returns whether nothing differs. */
  public boolean isEqual() {
    return remarks.isEmpty() && signals.stream().noneMatch(this::differs);
  }

  private void compareColumns(SignalTable first, SignalTable second) {
    Map<String, Variable> ofFirst = byName(first);
    Map<String, Variable> ofSecond = byName(second);
    for (Variable column : new TreeMap<>(ofFirst).values()) {
      String name = column.name();
      Variable counterpart = ofSecond.get(name);
      if (counterpart == null) {
        remarks.add("column " + name + " is in the first result only");
        continue;
      }
      String unit = column.unit();
      String other = counterpart.unit();
      if (!unit.isEmpty() && !other.isEmpty() && !unit.equals(other)) {
        remarks.add("column " + name + " is in " + unit + " and in " + other);
      }
    }
    for (String name : new TreeSet<>(ofSecond.keySet())) {
      if (!ofFirst.containsKey(name)) {
        remarks.add("column " + name + " is in the second result only");
      }
    }
  }

  private static Map<String, Variable> byName(SignalTable table) {
    Map<String, Variable> columns = new HashMap<>();
    table.columns().forEach(column -> columns.put(column.name(), column));
    return columns;
  }

  private void compareIntervals(double[] first, double[] second) {
    if (Math.abs(first[0] - second[0]) > timeTolerance) {
      remarks.add(
          "the first result begins at " + first[0] + " s, the second at " + second[0] + " s");
    }
    double end = first[first.length - 1];
    double other = second[second.length - 1];
    if (Math.abs(end - other) > timeTolerance) {
      remarks.add("the first result ends at " + end + " s, the second at " + other + " s");
    }
  }

  private void compareSignals(SignalTable first, SignalTable second) {
    Map<String, Integer> places = new HashMap<>();
    for (int i = 1; i < second.columns().size(); i++) {
      places.put(second.columns().get(i).name(), i);
    }
    Map<String, Double> largest = new HashMap<>();
    for (SignalTable table : List.of(first, second)) {
      for (int i = 1; i < table.columns().size(); i++) {
        double magnitude = magnitude(table.values().get(i));
        largest.merge(table.columns().get(i).unit(), magnitude, Math::max);
      }
    }
    for (int i = 1; i < first.columns().size(); i++) {
      Variable column = first.columns().get(i);
      if (places.containsKey(column.name())) {
        double[] mine = first.values().get(i);
        double[] its = second.values().get(places.get(column.name()));
        double rounding = ROUNDING * largest.getOrDefault(column.unit(), 0.0);
        double size = Math.max(rounding, size(mine, its));
        signals.add(compare(column, first.time(), mine, second.time(), its, size));
      }
    }
    signals.sort(
        Comparator.comparingDouble(SignalDifference::relative)
            .reversed()
            .thenComparing(SignalDifference::name));
  }

  private static double magnitude(double[] values) {
    double magnitude = 0;
    for (double value : values) {
      magnitude = Math.max(magnitude, Double.isNaN(value) ? 0 : Math.abs(value));
    }
    return magnitude;
  }

  private static double size(double[] first, double[] second) {
    double least = Double.POSITIVE_INFINITY;
    double most = Double.NEGATIVE_INFINITY;
    for (double[] values : List.of(first, second)) {
      for (double value : values) {
        if (!Double.isNaN(value)) {
          least = Math.min(least, value);
          most = Math.max(most, value);
        }
      }
    }
    double magnitude = Math.max(magnitude(first), magnitude(second));
    return Math.max(least <= most ? most - least : 0, SMALLEST_RANGE * magnitude);
  }

  private SignalDifference compare(
      Variable column, double[] t1, double[] x1, double[] t2, double[] x2, double size) {
    SignalTube aroundFirst = new SignalTube(t1, x1, timeTolerance);
    SignalTube aroundSecond = new SignalTube(t2, x2, timeTolerance);
    int ofSecond = aroundFirst.farthest(t2, x2);
    int ofFirst = aroundSecond.farthest(t1, x1);
    double outside2 = ofSecond < 0 ? 0 : aroundFirst.distance(t2[ofSecond], x2[ofSecond]);
    double outside1 = ofFirst < 0 ? 0 : aroundSecond.distance(t1[ofFirst], x1[ofFirst]);
    boolean second = Double.isNaN(outside2) || outside2 >= outside1;
    int at = second ? ofSecond : ofFirst;
    double time = at < 0 ? t1[0] : second ? t2[at] : t1[at];
    return new SignalDifference(
        column.name(),
        column.unit(),
        time,
        second || at < 0 ? aroundFirst.value(time) : x1[at],
        second && at >= 0 ? x2[at] : aroundSecond.value(time),
        second ? outside2 : outside1,
        size);
  }
}
