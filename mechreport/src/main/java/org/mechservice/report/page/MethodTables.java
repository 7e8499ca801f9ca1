package org.mechservice.report.page;

import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.mechservice.report.measure.ColdRunTimes;
import org.mechservice.report.measure.EqualError;
import org.mechservice.report.measure.Point;
import org.mechservice.report.measure.SceneFindings;
import org.mechservice.report.measure.TimeShares;
import org.mechservice.report.method.SimulationMethod;

/** The numbers behind the diagrams, as tables. */
final class MethodTables {
  private static final int BAR_WIDTH = 220;

  /** Methods reach order 13; observed orders scatter about it. */
  private static final double HIGHEST_ORDER = 20;

  private final SceneFindings found;
  private final CurveStyles styles;

  MethodTables(SceneFindings found, CurveStyles styles) {
    this.found = found;
    this.styles = styles;
  }

  /** Cost of equal errors, as ratio to the best. */
  String equalError() {
    double[] errors =
        java.util.stream.IntStream.rangeClosed(3, 9)
            .mapToDouble(k -> Math.pow(10, -k))
            .filter(error -> error > found.floor() && Double.isFinite(best(error)))
            .toArray();
    if (errors.length == 0) {
      return "";
    }
    double[] best = new double[errors.length];
    for (int i = 0; i < errors.length; i++) {
      best[i] = best(errors[i]);
    }
    StringBuilder html = new StringBuilder();
    html.append("<section><h2>Run time at equal error</h2>");
    html.append("<p class=\"note\">The best in seconds, the others as its multiples; interpolated");
    html.append(" between points. – : the error is not reached. ");
    html.append(HowMeasured.spread(found.points())).append("</p><table><tr><th>method");
    for (double error : errors) {
      html.append("<th>").append(Html.tolerance(error));
    }
    for (SimulationMethod method : found.measured()) {
      html.append("<tr>").append(styles.name(method));
      for (int i = 0; i < errors.length; i++) {
        html.append(cell(cost(method, errors[i]), best[i]));
      }
    }
    return html.append("</table></section>").toString();
  }

  private static String cell(OptionalDouble cost, double best) {
    if (cost.isEmpty()) {
      return "<td class=\"none\">–";
    }
    double ratio = cost.getAsDouble() / best;
    if (ratio <= 1) {
      return "<td class=\"best\">" + Html.seconds(best);
    }
    return "<td class=\"" + (ratio < 1.5 ? "good" : "") + "\">" + Html.factor(ratio);
  }

  private OptionalDouble cost(SimulationMethod method, double error) {
    return EqualError.cost(found.pointsOf(method.name()), error, Point::seconds);
  }

  private double best(double error) {
    double best = Double.POSITIVE_INFINITY;
    for (SimulationMethod method : found.methods()) {
      best = Math.min(best, cost(method, error).orElse(Double.POSITIVE_INFINITY));
    }
    return best;
  }

  /** One row per method: order, events, first runs, allocation. */
  String methods() {
    List<SimulationMethod> known =
        found.methods().stream()
            .filter(method -> order(method).isPresent() || isTimed(method))
            .toList();
    if (known.isEmpty()) {
      return "";
    }
    String at = Html.tolerance(found.effort().typicalTolerance());
    StringBuilder html = new StringBuilder();
    html.append("<section><h2>Methods</h2>");
    html.append("<p class=\"note\">First runs and shares of time at tolerance ").append(at);
    html.append("; of first runs the median, least and most, start of Java included. Order: how");
    html.append(" fast the error falls with the number of steps.</p><table><tr><th>method");
    html.append("<th>order observed<th>first run in a fresh JVM<th>where the time goes, warm");
    for (SimulationMethod method : known) {
      OptionalDouble order = order(method);
      ColdRunTimes fresh = found.freshStarts().get(method.name());
      html.append("<tr>").append(styles.name(method));
      html.append("<td>").append(order(order));
      html.append("<td>").append(fresh == null ? "–" : firstRuns(fresh));
      html.append("<td>").append(bar(found.shares().get(method.name())));
    }
    return html.append("</table>").append(partLegend()).append("</section>").toString();
  }

  private OptionalDouble order(SimulationMethod method) {
    return EqualError.order(found.pointsOf(method.name()), found.floor());
  }

  private boolean isTimed(SimulationMethod method) {
    return found.freshStarts().containsKey(method.name())
        || found.shares().containsKey(method.name());
  }

  private static String firstRuns(ColdRunTimes runs) {
    String median = Html.seconds(runs.seconds());
    return runs.count() == 1
        ? median
        : String.format(
            Locale.ROOT,
            "%s <span class=\"none\">(%.2f – %.2f s)</span>",
            median,
            runs.least(),
            runs.most());
  }

  /** An error that falls without more steps does not show the order. */
  private static String order(OptionalDouble order) {
    if (order.isEmpty()) {
      return "–";
    }
    return order.getAsDouble() > HIGHEST_ORDER
        ? "steps do not depend on the tolerance"
        : Html.digits(order.getAsDouble());
  }

  private static String bar(@org.jspecify.annotations.Nullable TimeShares shares) {
    if (shares == null) {
      return "–";
    }
    StringBuilder svg = new StringBuilder("<svg class=\"bar\" viewBox=\"0 0 220 12\">");
    double x = 0;
    for (TimeShares.Part part : TimeShares.Part.values()) {
      double share = shares.parts().getOrDefault(part, 0.0);
      if (share > 0.002) {
        svg.append(
            String.format(
                Locale.ROOT,
                "<rect class=\"p%s\" x=\"%.1f\" y=\"0\" width=\"%.1f\" height=\"12\""
                    + " data-t=\"%s: %.0f %%\"/>",
                part.css(),
                x,
                share * BAR_WIDTH,
                part.label(),
                100 * share));
        x += share * BAR_WIDTH;
      }
    }
    return svg.append("</svg>").toString();
  }

  private String partLegend() {
    StringBuilder html = new StringBuilder("<p class=\"legend\">");
    for (TimeShares.Part part : TimeShares.Part.values()) {
      boolean met =
          found.shares().values().stream()
              .anyMatch(shares -> shares.parts().getOrDefault(part, 0.0) > 0.002);
      if (met) {
        html.append(
            String.format(
                Locale.ROOT,
                "<span><svg class=\"swatch\" viewBox=\"0 0 26 12\"><rect class=\"p%s\" x=\"6\""
                    + " width=\"12\" height=\"12\"/></svg>%s</span>",
                part.css(),
                part.label()));
      }
    }
    return html.append("</p>").toString();
  }

  /** Every point with all its numbers. */
  String points() {
    boolean energy =
        found.points().stream().anyMatch(point -> !Double.isNaN(point.first().energyDrift()));
    boolean implicit = found.points().stream().anyMatch(point -> point.first().jacobians() > 0);
    boolean loops =
        found.points().stream().anyMatch(point -> !Double.isNaN(point.first().errors().residual()));
    StringBuilder html = new StringBuilder();
    html.append("<details><summary>All points</summary><div class=\"wide\"><table>");
    html.append("<tr><th>method<th>asked<th>error<th>÷ asked<th>at the end<th>positions");
    html.append("<th>velocities").append(loops ? "<th>multipliers<th>loops open, m" : "");
    html.append(energy ? "<th>energy drift" : "");
    html.append("<th>steps<th>rejected<th>evaluations");
    html.append(implicit ? "<th>Jacobians<th>factorisations" : "");
    html.append("<th>time<th>quartiles<th>runs<th>allocated");
    for (SimulationMethod method : found.methods()) {
      for (Point point : found.pointsOf(method.name())) {
        html.append("\n<tr>").append(styles.name(method));
        html.append(row(point, loops, energy, implicit));
      }
    }
    return html.append("</table></div></details>").toString();
  }

  private String row(Point point, boolean loops, boolean energy, boolean implicit) {
    var run = point.first();
    StringBuilder row = new StringBuilder();
    row.append("<td>").append(Html.tolerance(point.tolerance()));
    if (!point.completed()) {
      int columns = 12 + (loops ? 2 : 0) + (energy ? 1 : 0) + (implicit ? 2 : 0);
      return row.append("<td class=\"text ")
          .append(ScenePage.leftOut(point) ? "none" : "failed")
          .append("\" colspan=\"")
          .append(columns)
          .append("\">")
          .append(Html.escape(run.cause()))
          .toString();
    }
    boolean grey = point.error() <= found.floor();
    boolean flagged = ReliabilityWarnings.isNotKept(point, found.floor());
    row.append(grey ? "<td class=\"none\">" : "<td>").append(Html.error(point.error()));
    row.append(flagged ? "<td class=\"flag\">" : "<td>");
    row.append(grey ? "" : Html.number(point.error() / point.tolerance()));
    row.append("<td>").append(Html.error(run.errors().atEnd()));
    row.append("<td>").append(Html.error(run.errors().ofPositions()));
    row.append("<td>").append(Html.error(run.errors().ofVelocities()));
    if (loops) {
      row.append("<td>").append(Html.error(run.errors().ofMultipliers()));
      row.append("<td>").append(Html.error(run.errors().residual()));
    }
    if (energy) {
      row.append("<td>").append(Html.error(run.energyDrift()));
    }
    row.append("<td>").append(run.steps());
    row.append("<td>").append(run.rejected());
    row.append("<td>").append(run.evaluations());
    if (implicit) {
      row.append("<td>").append(run.jacobians()).append("<td>").append(run.factorisations());
    }
    row.append("<td>").append(Html.seconds(point.seconds()));
    row.append("<td>");
    if (point.isRepeated()) {
      row.append(Html.seconds(point.lowSeconds())).append(" – ");
      row.append(Html.seconds(point.highSeconds()));
    } else {
      row.append("–");
    }
    row.append("<td>").append(point.repeats());
    row.append("<td>").append(Html.bytes((double) run.bytes()));
    return row.toString();
  }
}
