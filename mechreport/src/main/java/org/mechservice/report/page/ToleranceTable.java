package org.mechservice.report.page;

import java.util.List;
import java.util.Locale;
import org.mechservice.report.measure.Point;
import org.mechservice.report.measure.SceneFindings;
import org.mechservice.report.method.SimulationMethod;

/**
 * Achieved error over requested tolerance, per method and tolerance; flagged where the tolerance is
 * not kept.
 */
final class ToleranceTable {
  private final SceneFindings found;
  private final CurveStyles styles;

  ToleranceTable(SceneFindings found, CurveStyles styles) {
    this.found = found;
    this.styles = styles;
  }

  String html() {
    double[] tolerances = found.effort().tolerances();
    StringBuilder html = new StringBuilder();
    html.append("<p class=\"note\">").append(summary()).append("</p>");
    html.append("<div class=\"wide\"><table><tr><th>error ÷ tolerance");
    for (double tolerance : tolerances) {
      html.append("<th>").append(Html.tolerance(tolerance));
    }
    for (SimulationMethod method : found.measured()) {
      html.append("\n<tr>").append(styles.name(method));
      for (double tolerance : tolerances) {
        html.append(cell(found.pointsOf(method.name()), tolerance));
      }
    }
    return html.append("</table></div>").toString();
  }

  private String cell(List<Point> points, double tolerance) {
    for (Point point : points) {
      if (point.tolerance() == tolerance && ScenePage.leftOut(point)) {
        return "<td class=\"none\">left out";
      }
      if (point.tolerance() == tolerance && point.completed()) {
        boolean grey = point.error() <= found.floor();
        boolean flagged = ReliabilityWarnings.isNotKept(point, found.floor());
        String css = grey ? "none" : flagged ? "flag" : "";
        return "<td class=\"" + css + "\">" + ratio(point.error() / tolerance);
      }
    }
    return "<td class=\"none\">failed";
  }

  private static String ratio(double ratio) {
    return ratio >= 1e4 || ratio < 1e-2
        ? Html.error(ratio)
        : String.format(Locale.ROOT, ratio < 9.95 ? "%.2g" : "%.0f", ratio);
  }

  private String summary() {
    List<Point> completed = found.points().stream().filter(Point::completed).toList();
    long flagged =
        completed.stream()
            .filter(point -> ReliabilityWarnings.isNotKept(point, found.floor()))
            .count();
    long cautious =
        completed.stream()
            .filter(point -> ReliabilityWarnings.isCautious(point, found.floor()))
            .count();
    String sum =
        flagged == 0
            ? "All "
                + completed.size()
                + " runs that reached the end keep their tolerance: no error is more than 100 times"
                + " as large."
            : "<b>"
                + flagged
                + " of "
                + completed.size()
                + "</b> runs that reached the end do not keep their tolerance: their errors are more"
                + " than 100 times as large (red).";
    if (cautious > 0) {
      sum += " " + cautious + (cautious == 1 ? " is" : " are") + " more exact than a hundredth.";
    }
    return sum + growth();
  }

  /** A scene that amplifies makes every method's errors larger than its tolerance. */
  private String growth() {
    double most = found.growth();
    return most > 10
        ? " The scene itself makes errors grow: a small change of the start up to "
            + Html.factor(most)
            + "."
        : "";
  }
}
