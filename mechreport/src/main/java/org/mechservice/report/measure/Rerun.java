package org.mechservice.report.measure;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;

/**
 * The comparison of two reports of one scene. What does not depend on the machine, outcome, error
 * and counts, must be the same to the last digit; times must lie within the spread that the reports
 * state.
 *
 * @param pairs points that both reports have
 * @param alone number of points that only one has
 */
public record Rerun(List<Pair> pairs, int alone) {
  /** Part of the points whose times must agree. */
  private static final double MOST = 0.9;

  public Rerun {
    pairs = List.copyOf(pairs);
  }

  /**
   * A point in both reports.
   *
   * @param first earlier
   * @param second later
   */
  public record Pair(Point first, Point second) {
    /** Returns whether all that does not depend on the machine is the same. */
    boolean same() {
      MeasuredRun a = first.first();
      MeasuredRun b = second.first();
      return a.cause().equals(b.cause())
          && a.errors().equals(b.errors())
          && a.steps() == b.steps()
          && a.rejected() == b.rejected()
          && a.evaluations() == b.evaluations()
          && a.jacobians() == b.jacobians()
          && a.factorisations() == b.factorisations();
    }

    boolean timed() {
      return first.repeats() > 0 && second.repeats() > 0;
    }

    /** Returns the later time over the earlier one. */
    double ratio() {
      return second.seconds() / first.seconds();
    }

    /** Each median lies within the other's quartiles, widened by their distance. */
    boolean withinSpread() {
      return withinSpread(1);
    }

    /** The same where the second computer is slower by a factor. */
    boolean withinSpread(double factor) {
      return within(first, second.seconds() / factor) && within(second, first.seconds() * factor);
    }

    private static boolean within(Point point, double seconds) {
      double spread = point.highSeconds() - point.lowSeconds();
      return seconds >= point.lowSeconds() - spread && seconds <= point.highSeconds() + spread;
    }

    String name() {
      return String.format(
          Locale.ROOT, "%s at %.0e", first.first().method(), first.first().tolerance());
    }
  }

  /**
   * Compares the files of two reports.
   *
   * @throws IOException if one cannot be read
   */
  public static Rerun of(Path first, Path second) throws IOException {
    return of(Point.of(MeasurementFile.read(first)), Point.of(MeasurementFile.read(second)));
  }

  static Rerun of(List<Point> first, List<Point> second) {
    List<Pair> pairs = new ArrayList<>();
    for (Point a : first) {
      second.stream()
          .filter(b -> b.first().method().equals(a.first().method()))
          .filter(b -> b.tolerance() == a.tolerance())
          .findFirst()
          .ifPresent(b -> pairs.add(new Pair(a, b)));
    }
    return new Rerun(pairs, first.size() + second.size() - 2 * pairs.size());
  }

  /** Returns whether both reports say the same. */
  public boolean agrees() {
    List<Pair> timed = timed();
    long within = timed.stream().filter(Pair::withinSpread).count();
    return !pairs.isEmpty()
        && alone == 0
        && pairs.stream().allMatch(Pair::same)
        && within >= MOST * timed.size();
  }

  private List<Pair> timed() {
    return pairs.stream().filter(Pair::timed).toList();
  }

  /** Returns the findings of the comparison, one sentence each. */
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    lines.add(line("%d points in both, %d in one alone", pairs.size(), alone));
    List<Pair> differing = pairs.stream().filter(pair -> !pair.same()).toList();
    lines.add(
        line(
            "outcome, errors, steps, evaluations, Jacobians, factorisations: the same in %d",
            pairs.size() - differing.size()));
    differing.forEach(pair -> lines.add("differs: " + pair.name()));
    List<Pair> timed = timed();
    if (!timed.isEmpty()) {
      double[] ratios = timed.stream().mapToDouble(Pair::ratio).toArray();
      Pair worst =
          timed.stream()
              .max(Comparator.comparingDouble(pair -> Math.abs(Math.log(pair.ratio()))))
              .orElseThrow();
      lines.add(
          line(
              "time, second over first: %.3f in the median, 90 %% of %d within %.3f and %.3f",
              Quantiles.of(ratios, 0.5),
              ratios.length,
              Quantiles.of(ratios, 0.05),
              Quantiles.of(ratios, 0.95)));
      lines.add(line("largest difference: %.3f, %s", worst.ratio(), worst.name()));
      long within = timed.stream().filter(Pair::withinSpread).count();
      lines.add(
          line(
              "medians within each other's quartiles widened by their distance: %d of %d",
              within, timed.size()));
      double common = Quantiles.of(ratios, 0.5);
      lines.add(
          line(
              "the same with the factor %.3f taken out, which all have in common: %d of %d",
              common,
              timed.stream().filter(pair -> pair.withinSpread(common)).count(),
              timed.size()));
    }
    lines.add(agrees() ? "rerun within noise" : "NOT within noise (90 % of the times must be)");
    return lines;
  }

  private static String line(String format, Object... values) {
    return String.format(Locale.ROOT, format, values);
  }
}
