package org.mechservice.report.page;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import org.mechservice.report.measure.Campaign;
import org.mechservice.report.measure.Effort;
import org.mechservice.report.measure.Point;
import org.mechservice.report.measure.SceneFindings;
import org.mechservice.report.measure.Spectrum;
import org.mechservice.report.method.OmittedMethod;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.report.solution.Reference;
import org.mechservice.solver.api.run.Stiffness;
import org.mechservice.solver.catalogue.MethodNames;

/** The page of one scene, without parts that do not apply to the scene. */
public final class ScenePage {
  /** Labels on a curve beyond which they cover each other. */
  private static final int MOST_LABELS = 5;

  private final SceneFindings found;
  private final CurveStyles styles;
  private final StringBuilder page = new StringBuilder();

  private ScenePage(SceneFindings found) {
    this.found = found;
    styles = new CurveStyles(found.methods());
  }

  /** Returns the page as HTML. */
  public static String of(SceneFindings found) {
    ScenePage scene = new ScenePage(found);
    scene.write();
    return PageFrame.of(found.scene().model() + ": error against run time", scene.page.toString());
  }

  private void write() {
    head();
    ReliabilityWarnings.of(found)
        .forEach(doubt -> add("<p class=\"doubt\">" + Html.escape(doubt) + "</p>"));
    recommendation();
    if (!found.points().isEmpty()) {
      diagrams();
      MethodTables tables = new MethodTables(found, styles);
      add(tables.equalError());
      add(tables.methods());
      failures();
      notMeasured();
    }
    spectrum();
    add(new LimitsTable(found).html());
    if (!found.points().isEmpty()) {
      add(new MethodTables(found, styles).points());
    }
    leftOut();
    add(new HowMeasured(found).html());
  }

  private void add(String html) {
    page.append(html).append('\n');
  }

  private void head() {
    double end = found.judge().reference().map(Reference::end).orElse(found.scene().end());
    // what was left out counts too: all methods of one closure may have been
    boolean closes =
        Stream.concat(found.methods().stream(), found.leftOut().stream().map(OmittedMethod::method))
            .anyMatch(method -> !method.closure().equals(MethodNames.NONE));
    String loops = closes ? "closed loops" : "open chain";
    add("<h1>" + Html.escape(found.scene().model()) + "</h1>");
    add(
        String.format(
            Locale.ROOT,
            "<p class=\"sub\">%s · %d degree%s of freedom · %s · %s%s · %d methods%s · %s</p>",
            Html.escape(found.scene().file()),
            found.scene().freedoms(),
            found.scene().freedoms() == 1 ? "" : "s",
            loops,
            interval(end),
            jumps(),
            found.methods().size(),
            found.effort().name().equals(Effort.QUICK.name()) ? " · quick report" : "",
            Html.escape(found.versions().get(0))));
  }

  private String jumps() {
    int jumps = found.judge().reference().map(reference -> reference.jumps().size()).orElse(0);
    return jumps == 0 ? "" : " · the state jumps " + (jumps == 1 ? "once" : jumps + " times");
  }

  /** Returns the interval, with a remark if only its beginning can be judged. */
  private String interval(double end) {
    String judged = Html.number(end) + " s";
    return end < found.scene().end()
        ? "the first " + judged + " of " + Html.number(found.scene().end()) + " s (see below)"
        : judged;
  }

  private void recommendation() {
    Advice advice = new Advice(found);
    List<String> sentences = advice.sentences();
    add("<section class=\"advice\"><h2>Recommendation</h2>");
    if (sentences.isEmpty()) {
      add("<p>No method reached an error that the reference can tell; see below why.</p>");
    }
    sentences.forEach(sentence -> add("<p>" + sentence + "</p>"));
    advice.stiffness().ifPresent(text -> add("<p>" + text + "</p>"));
    add("</section>");
  }

  private void diagrams() {
    add("<section><h2>Error against run time</h2>");
    add(legend());
    add(
        "<p class=\"note\">The number at a point is the exponent of the tolerance asked for (3:"
            + " 1e-3); the line through it spans the quartiles of its times where that is wider"
            + " than the mark. "
            + HowMeasured.definition(found)
            + "</p>");
    add(timeChart());
    add("<h2>Error against evaluations</h2>");
    add(
        chart(
            "evaluations of right-hand side or residual",
            point -> (double) point.first().evaluations(),
            false));
    add("<h2>Error achieved against tolerance asked for</h2>");
    add(
        "<p class=\"note\">On the line the error is the tolerance. Above the upper dotted line, 100"
            + " times as large, the tolerance is not kept; below the lower one, a hundredth, a run"
            + " is more exact than asked for.</p>");
    add(honesty());
    add(new ToleranceTable(found, styles).html());
    add("</section>");
  }

  private String timeChart() {
    return chart("run time, s (processor, median)", Point::seconds, true);
  }

  /** Returns the diagram of error over run time as an SVG file of its own. */
  public static String diagram(SceneFindings found) {
    return PageFrame.svg(new ScenePage(found).timeChart());
  }

  private String legend() {
    StringBuilder legend = new StringBuilder("<p class=\"legend\">");
    for (SimulationMethod method : found.methods()) {
      if (found.pointsOf(method.name()).stream().allMatch(ScenePage::leftOut)) {
        continue;
      }
      legend
          .append("<span data-m=\"")
          .append(Html.escape(method.name()))
          .append("\">")
          .append(styles.of(method).swatch())
          .append(Html.escape(method.name()))
          .append("</span>");
    }
    boolean failed = found.points().stream().anyMatch(ScenePage::failed);
    if (failed) {
      legend.append(
          "<span><svg class=\"swatch\" viewBox=\"0 0 26 12\"><path class=\"fail\" d=\"M9 2l8 8m0"
              + " -8l-8 8\"/></svg>failed, at the tolerance asked for</span>");
    }
    return legend.append("</p>").toString();
  }

  private String chart(String xTitle, ToDoubleFunction<Point> x, boolean timed) {
    LogLogChart chart = new LogLogChart(xTitle, "largest error over time").floor(found.floor());
    for (SimulationMethod method : found.methods()) {
      chart.add(curve(method, x, timed));
    }
    return chart.svg();
  }

  private LogLogChart.Curve curve(
      SimulationMethod method, ToDoubleFunction<Point> x, boolean timed) {
    List<LogLogChart.Mark> marks = new ArrayList<>();
    List<LogLogChart.Mark> failures = new ArrayList<>();
    for (Point point : found.pointsOf(method.name())) {
      if (failed(point)) {
        failures.add(new LogLogChart.Mark(0, point.tolerance(), "", hover(method, point), false));
      } else if (point.completed()
          && x.applyAsDouble(point) > 0
          && Double.isFinite(point.error())) {
        marks.add(
            new LogLogChart.Mark(
                x.applyAsDouble(point),
                Math.max(point.error(), 1e-17),
                label(point),
                hover(method, point),
                point.error() <= found.floor(),
                timed ? point.lowSeconds() : x.applyAsDouble(point),
                timed ? point.highSeconds() : x.applyAsDouble(point)));
      }
    }
    return new LogLogChart.Curve(styles.of(method), marks, failures);
  }

  /** Returns the exponent of the requested tolerance; of many tolerances, every third has one. */
  private String label(Point point) {
    long exponent = Math.round(-Math.log10(point.tolerance()));
    boolean crowded = found.effort().tolerances().length > MOST_LABELS;
    return crowded && exponent % 3 != 0 ? "" : Long.toString(exponent);
  }

  private String hover(SimulationMethod method, Point point) {
    if (!point.completed()) {
      return method.name()
          + "\nasked "
          + Html.tolerance(point.tolerance())
          + "\n"
          + point.first().cause();
    }
    return method.name()
        + "\nasked "
        + Html.tolerance(point.tolerance())
        + ", error "
        + Html.error(point.error())
        + (point.error() <= found.floor() ? " (below the reference's floor)" : "")
        + "\n"
        + Html.seconds(point.seconds())
        + (point.isRepeated()
            ? " ("
                + Html.seconds(point.lowSeconds())
                + " – "
                + Html.seconds(point.highSeconds())
                + ", "
                + point.repeats()
                + " runs)\n"
            : " (a single run)\n")
        + point.first().steps()
        + " steps, "
        + point.first().evaluations()
        + " evaluations";
  }

  private String honesty() {
    LogLogChart chart =
        new LogLogChart("relative tolerance asked for", "largest error over time")
            .floor(found.floor())
            .honestBand();
    for (SimulationMethod method : found.methods()) {
      List<LogLogChart.Mark> marks = new ArrayList<>();
      for (Point point : found.pointsOf(method.name())) {
        if (point.completed() && Double.isFinite(point.error())) {
          marks.add(
              new LogLogChart.Mark(
                  point.tolerance(),
                  Math.max(point.error(), 1e-17),
                  "",
                  hover(method, point),
                  point.error() <= found.floor()));
        }
      }
      chart.add(new LogLogChart.Curve(styles.of(method), marks, List.of()));
    }
    return chart.svg();
  }

  private void failures() {
    table("Failures", "cause (of the first)", ScenePage::failed);
  }

  private static boolean failed(Point point) {
    return !point.completed() && !leftOut(point);
  }

  /** Returns whether the time for the report did not allow the point. */
  static boolean leftOut(Point point) {
    return point.first().cause().startsWith(Campaign.LEFT_OUT);
  }

  private void notMeasured() {
    table(
        "Not measured, to keep the time for the report", "why (of the first)", ScenePage::leftOut);
  }

  private void table(String title, String why, Predicate<Point> which) {
    List<Point> failed = found.points().stream().filter(which).toList();
    if (failed.isEmpty()) {
      return;
    }
    add("<section><h2>" + title + "</h2><table><tr><th>method<th>tolerances<th>" + why);
    Map<String, List<List<Point>>> alike = new LinkedHashMap<>();
    for (List<Point> same : byCause(failed).values()) {
      String key = kind(same.get(0).first().cause()) + "\n" + tolerances(same);
      alike.computeIfAbsent(key, k -> new ArrayList<>()).add(same);
    }
    for (List<List<Point>> methods : alike.values()) {
      Point first = methods.get(0).get(0);
      add(
          "<tr><td class=\"text\">"
              + String.join(", ", methods.stream().map(same -> method(same.get(0))).toList())
              + "<td>"
              + tolerances(methods.get(0))
              + "<td class=\"text\">"
              + Html.escape(first.first().cause().replaceFirst("^" + Campaign.LEFT_OUT, "")));
    }
    add("</table></section>");
  }

  /** Returns points by their method and the kind of their cause. */
  private static Map<String, List<Point>> byCause(List<Point> points) {
    Map<String, List<Point>> byCause = new LinkedHashMap<>();
    for (Point point : points) {
      byCause
          .computeIfAbsent(
              point.first().method() + "\n" + kind(point.first().cause()), k -> new ArrayList<>())
          .add(point);
    }
    return byCause;
  }

  private static String method(Point point) {
    return "<span class=\"name\">" + Html.escape(point.first().method()) + "</span>";
  }

  private static String tolerances(List<Point> points) {
    return String.join(", ", points.stream().map(p -> Html.tolerance(p.tolerance())).toList());
  }

  /**
   * Returns what tells a cause from others, by which they are counted in one line: the code of a
   * message, or the first words.
   */
  private static String kind(String cause) {
    int length = cause.startsWith(Campaign.LEFT_OUT) ? Campaign.LEFT_OUT.length() : 5;
    return cause.substring(0, Math.min(cause.length(), length));
  }

  private void spectrum() {
    Optional<Spectrum> spectrum = found.spectrum();
    boolean matters =
        spectrum.isPresent() && spectrum.get().verdict() != Stiffness.Verdict.NOT_STIFF;
    if (matters) {
      add(SpectrumTable.of(spectrum.get()));
    }
  }

  private void leftOut() {
    if (found.leftOut().isEmpty()) {
      return;
    }
    Map<String, List<OmittedMethod>> byReason = new LinkedHashMap<>();
    for (OmittedMethod one : found.leftOut()) {
      String key = one.method().formulation() + one.method().closure();
      byReason.computeIfAbsent(key, k -> new ArrayList<>()).add(one);
    }
    add("<details><summary>Methods that do not fit this scene</summary><table>");
    for (List<OmittedMethod> same : byReason.values()) {
      String names =
          String.join(", ", same.stream().map(one -> one.method().integrator()).toList());
      SimulationMethod first = same.get(0).method();
      add(
          "<tr><td>"
              + new SimulationMethod(first.formulation(), first.closure(), "").name().strip()
              + " with "
              + names
              + "<td class=\"text\">"
              + Html.escape(same.get(0).reason()));
    }
    add("</table></details>");
  }
}
