package org.mechservice.view.plot;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.mechservice.result.ResultComparison;
import org.mechservice.result.SignalDifference;
import org.mechservice.result.SignalTable;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The diagram of what differs between two results: the signals that differ most, each with both
 * results over each other and, below them, the second minus the first.
 */
public final class DifferencePlot {
  /** Signals that are drawn. */
  private static final int MOST = 3;

  private static final int BUCKETS = 3000;

  private DifferencePlot() {}

  /**
   * Draws the signals that differ, or without any the one that comes nearest to a difference.
   *
   * @param runs names of the two results
   * @param comparison of them
   * @throws IllegalArgumentException with a message code if they have no rows or no signal in
   *     common, so that there is nothing to draw
   */
  public static Plot of(
      List<String> runs, SignalTable first, SignalTable second, ResultComparison comparison) {
    List<SignalDifference> signals = comparison.signals();
    if (signals.isEmpty()) {
      throw new IllegalArgumentException(
          MessageCode.RESULT_UNREADABLE
              + " the two results have no signal with rows in both: there is nothing to draw");
    }
    List<SignalDifference> different = signals.stream().filter(comparison::differs).toList();
    List<SignalDifference> drawn =
        different.isEmpty()
            ? signals.subList(0, 1)
            : different.subList(0, Math.min(MOST, different.size()));
    List<Plot.Panel> panels = new ArrayList<>();
    List<String> notes = new ArrayList<>();
    for (SignalDifference signal : drawn) {
      double[] values = values(first, signal.name());
      double[] others = values(second, signal.name());
      List<double[]> rows = rows(first.time(), values);
      List<double[]> itsRows = rows(second.time(), others);
      List<double[]> between =
          rows(first.time(), difference(first.time(), values, second.time(), others));
      panels.add(
          new Plot.Panel(
              "",
              signal.unit(),
              List.of(
                  new Plot.Curve(signal.name(), 0, 0, rows, 1),
                  new Plot.Curve(signal.name(), 1, 0, itsRows, 1))));
      panels.add(
          new Plot.Panel(
              "difference",
              signal.unit(),
              List.of(new Plot.Curve("second − first", 1, 1, between, 1))));
      notes.add(words(signal));
    }
    comparison.remarks().stream().limit(MOST).forEach(notes::add);
    return new Plot(
        different.size() + " of " + signals.size() + " signals differ",
        first.columns().get(0).name(),
        first.columns().get(0).unit(),
        runs,
        panels,
        notes);
  }

  private static String words(SignalDifference signal) {
    return String.format(
        Locale.ROOT,
        "%s: largest difference at t = %.6g s, %.8g and %.8g, %.3g of its size",
        signal.name(),
        signal.time(),
        signal.first(),
        signal.second(),
        signal.relative());
  }

  private static double[] values(SignalTable table, String name) {
    for (int i = 1; i < table.columns().size(); i++) {
      if (table.columns().get(i).name().equals(name)) {
        return table.values().get(i);
      }
    }
    throw new IllegalArgumentException("no column " + name);
  }

  private static List<double[]> rows(double[] time, double[] values) {
    ThinnedRows kept = new ThinnedRows(BUCKETS);
    for (int i = 0; i < time.length; i++) {
      kept.accept(new double[] {time[i], values[i]});
    }
    return kept.rows();
  }

  /** Second minus first at the times of the first; a gap where the second has no rows. */
  private static double[] difference(double[] time, double[] values, double[] t, double[] x) {
    double[] difference = new double[time.length];
    int at = 0;
    for (int i = 0; i < time.length; i++) {
      while (at < t.length - 1 && t[at + 1] <= time[i]) {
        at++;
      }
      int next = Math.min(at + 1, t.length - 1);
      double other;
      if (time[i] == t[at]) {
        other = x[at];
      } else if (time[i] < t[at] || time[i] > t[next]) {
        other = Double.NaN;
      } else {
        other = x[at] + (time[i] - t[at]) / (t[next] - t[at]) * (x[next] - x[at]);
      }
      difference[i] = other - values[i];
    }
    return difference;
  }
}
