package org.mechservice.report.page;

import java.util.List;
import java.util.Locale;
import org.mechservice.report.measure.Effort;
import org.mechservice.report.measure.Point;
import org.mechservice.report.measure.Quantiles;
import org.mechservice.report.measure.ReportBudget;
import org.mechservice.report.measure.SceneFindings;
import org.mechservice.report.solution.Judge;
import org.mechservice.report.solution.Reference;

/** The section of the page on the measurement: reference, rules, warm-up, spread. */
final class HowMeasured {
  /** Relative change of times that counts as warm; times scatter by a few per cent. */
  private static final double WARM = 0.05;

  /** Points without which nothing is said of the warm-up. */
  private static final int FEW_POINTS = 3;

  private final SceneFindings found;

  HowMeasured(SceneFindings found) {
    this.found = found;
  }

  String html() {
    StringBuilder html = new StringBuilder();
    html.append("<details open><summary>How this was measured</summary><ul>");
    Judge judge = found.judge();
    judge.said().forEach(said -> html.append("\n<li>").append(Html.escape(said)));
    judge
        .reference()
        .flatMap(Reference::amplification)
        .ifPresent(
            factors ->
                html.append("\n<li>A change of the start by 1e-9 has grown ")
                    .append(Html.number(factors[factors.length - 1]))
                    .append("× at the end."));
    html.append("\n<li>").append(definition(found)).append(" Intervals and output rows the same.");
    html.append("\n<li>Tolerances: relative as stated, absolute a hundredth of it.");
    html.append("\n<li>").append(timing());
    warmth().forEach(sentence -> html.append("\n<li>").append(sentence));
    html.append("\n<li>").append(budget());
    if (!found.savings().isEmpty()) {
      html.append("\n<li>").append(time());
    }
    html.append("\n<li>");
    html.append(String.join(" · ", found.versions().stream().map(Html::escape).toList()));
    html.append("\n<li>Every single run: ").append(link(found.scene().runs()));
    if (judge.reference().flatMap(Reference::amplification).isPresent()) {
      String kept = found.scene().reference();
      html.append("; what the codes of this report made, to every digit: ").append(link(kept));
    }
    return html.append("</ul></details>").toString();
  }

  private static String link(String file) {
    return "<a href=\"" + Html.escape(file) + "\">" + Html.escape(file) + "</a>";
  }

  /** The one definition of the error, in a sentence. */
  static String definition(SceneFindings found) {
    return "Error: the largest |x − x<sub>ref</sub>| / (1 + |x<sub>ref</sub>|) of all positions and"
        + " velocities in SI units, over "
        + found.judge().reference().map(HowMeasured::times).orElse("no times")
        + "; the same for every method.";
  }

  private static String times(Reference reference) {
    String clear = reference.jumps().isEmpty() ? "" : " clear of the jumps of the state";
    return reference.times().length + " times" + clear;
  }

  private String timing() {
    Effort effort = found.effort();
    int fewest =
        found.points().stream()
            .filter(Point::completed)
            .mapToInt(Point::repeats)
            .min()
            .orElse(effort.fewestRepeats());
    String repeats =
        fewest == Effort.REPEATS
            ? "median of " + Effort.REPEATS + " runs"
            : "median of " + fewest + " to " + Effort.REPEATS + " runs (the tables say how many)";
    return String.format(
        Locale.ROOT,
        "Time: processor time of the run's thread, %s. Before them%s, rounds that do not count until"
            + " %.2g s of them got no faster (by 2 %%). Every round runs every point once,"
            + " beginning at another one. Spread: quartiles.",
        repeats,
        found.savings().isEmpty() ? "" : ", if the time for the report allowed it",
        effort.warmSeconds());
  }

  /** Returns the evidence that methods were warm, and the accuracy of times. */
  private List<String> warmth() {
    double[] drifts =
        found.points().stream().mapToDouble(Point::drift).filter(Double::isFinite).toArray();
    if (drifts.length < FEW_POINTS) {
      return List.of(spread(found.points()));
    }
    double middle = Quantiles.median(drifts) - 1;
    return List.of(
        String.format(
            Locale.ROOT,
            "Warm-up: from the earlier half of the rounds to the later one the times change by"
                + " %+.1f %% (median of %d points; half of them between %+.1f and %+.1f %%)%s",
            100 * middle,
            drifts.length,
            100 * (Quantiles.of(drifts, 0.25) - 1),
            100 * (Quantiles.of(drifts, 0.75) - 1),
            Math.abs(middle) <= WARM
                ? ": the methods were warm."
                : ": <b>they were not warm, or the machine was not quiet.</b>"),
        spread(found.points()));
  }

  /** How far half of a point's times differ, in the middle of all points; a sentence. */
  static String spread(List<Point> points) {
    double[] spreads =
        points.stream().mapToDouble(Point::spread).filter(Double::isFinite).toArray();
    return spreads.length == 0
        ? "Times are of one or two runs, so how far they scatter is not known."
        : String.format(
            Locale.ROOT,
            "Half of a point's times lie within %.1f %% of each other (median of the points):"
                + " ratios nearer to 1 than that mean nothing.",
            100 * Quantiles.median(spreads));
  }

  /** The time for the report and what it cost, where it was short. */
  private String time() {
    return "The time for the report, "
        + ReportBudget.inWords(found.effort().budgetSeconds())
        + ", was kept by leaving out what is named here (<code>mech report --budget SECONDS</code>"
        + " sets it): "
        + String.join(" ", found.savings().stream().map(Html::escape).toList());
  }

  private String budget() {
    double limit = found.effort().limitSeconds();
    String all = String.format(Locale.ROOT, "Runs were stopped after %.3g s", limit);
    return limit <= Effort.CHEAP_SECONDS
        ? all + "."
        : all
            + String.format(
                Locale.ROOT,
                ", and those beyond %.0f s if they took %.0f times what the fastest method took at"
                    + " the same tolerance.",
                Effort.CHEAP_SECONDS,
                Effort.SENSELESS);
  }
}
