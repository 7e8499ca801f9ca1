package org.mechservice.cli.optimise;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import org.mechservice.report.page.PageFrame;
import org.mechservice.study.Reduction;
import org.mechservice.study.gradient.Gradient;
import org.mechservice.view.plot.Plot;

/**
 * The page of a gradient: each output with its derivatives as bars, each derivative times the range
 * of its parameter; for a series the derivatives over time.
 */
final class GradientPage {
  /** Part of its value by which a parameter without a range is taken to change. */
  private static final double PART = 0.1;

  private static final int WIDTH = 760;
  private static final int ROW = 46;
  private static final int MOST_CURVES = 8;

  private final Gradient found;
  private final Gradient finer;
  private final List<Change> changes;
  private final List<Reduction> values;

  /**
   * By how much a parameter is taken to change.
   *
   * @param by in the unit of its derivatives
   * @param words what this is of it
   */
  record Change(double by, String words) {
    /** Of a range that was given. */
    static Change range(double from, double to, String unit) {
      return new Change(
          to - from, OptimiseCommand.shown(from) + " to " + OptimiseCommand.shown(to) + unit(unit));
    }

    /** Of a value. */
    static Change part(double value, String unit) {
      return value == 0
          ? new Change(1, "by 1" + unit(unit))
          : new Change(
              PART * Math.abs(value),
              "by 10 %, " + OptimiseCommand.shown(PART * Math.abs(value)) + unit(unit));
    }
  }

  /** Values of one output, from its first to before its last index. */
  private record Group(Reduction asked, int from, int to) {
    boolean isSeries() {
      return to > from + 1;
    }
  }

  private GradientPage(
      Gradient found, Gradient finer, List<Change> changes, List<Reduction> values) {
    this.found = found;
    this.finer = finer;
    this.changes = changes;
    this.values = values;
  }

  /**
   * Returns the page.
   *
   * @param asked outputs as they were asked for
   * @param values outputs with single values for series, as the gradient has them
   * @param finer the same gradient at a tenth of the tolerances
   * @param changes of the parameters
   */
  static String of(
      String model,
      Gradient found,
      Gradient finer,
      List<Reduction> asked,
      List<Reduction> values,
      List<Change> changes) {
    return new GradientPage(found, finer, changes, values).page(model, groups(asked, values));
  }

  private static List<Group> groups(List<Reduction> asked, List<Reduction> values) {
    List<Group> groups = new ArrayList<>();
    int next = 0;
    for (Reduction one : asked) {
      int end = next + 1;
      while (one.kind() == Reduction.Kind.SERIES
          && end < values.size()
          && values.get(end).column().equals(one.column())
          && values.get(end).argument() > values.get(end - 1).argument()) {
        end++;
      }
      groups.add(new Group(one, next, end));
      next = end;
    }
    return groups;
  }

  private String page(String model, List<Group> groups) {
    String title = "Gradient of " + model;
    StringBuilder html = new StringBuilder("<h1>" + PageFrame.escaped(title) + "</h1>\n");
    html.append("<p class=\"sub\">").append(PageFrame.escaped(cost())).append("</p>\n");
    if (!found.differenced().isEmpty()) {
      html.append("<p class=\"note\">The equations were differenced, at fixed states, by ")
          .append(PageFrame.escaped(String.join(", ", found.differenced())))
          .append(": masses, points or settings depend on them.</p>\n");
    }
    html.append("<p>A bar is the change of the output if the parameter alone changes along its ")
        .append("range, as the derivative at the present values tells it. ");
    html.append("The error is the difference from the same gradient at a tenth of the ")
        .append("tolerances.</p>\n");
    for (Group group : groups) {
      html.append("<h2>").append(PageFrame.escaped(group.asked.toString())).append("</h2>\n");
      html.append(group.isSeries() ? series(group) : single(group.from));
    }
    return PageFrame.of(title, html.toString());
  }

  private String cost() {
    return (found.method().label().equals("forward") ? "Forward" : "Adjoint")
        + " ("
        + found.reason()
        + "), "
        + found.steps()
        + " steps of the motion";
  }

  private String single(int output) {
    return "<p>"
        + PageFrame.escaped(
            "The value is "
                + OptimiseCommand.shown(found.values()[output])
                + unit(found.units().get(output))
                + ", with an error of "
                + digits(Math.abs(found.values()[output] - finer.values()[output]))
                + unit(found.units().get(output))
                + ".")
        + "</p>\n"
        + bars(output)
        + table(output);
  }

  private String table(int output) {
    List<List<String>> rows = new ArrayList<>();
    for (int k : byEffect(output)) {
      double slope = found.derivatives()[output][k];
      rows.add(
          List.of(
              found.parameters().get(k),
              OptimiseCommand.shown(slope),
              "per "
                  + (found.parameterUnits().get(k).equals("1")
                      ? "1"
                      : found.parameterUnits().get(k)),
              digits(Math.abs(slope - finer.derivatives()[output][k])),
              changes.get(k).words,
              OptimiseCommand.shown(effect(output, k)) + unit(found.units().get(output))));
    }
    return OptimumPage.table(
        List.of("parameter", "derivative", "", "error", "range", "change of the output"), rows);
  }

  private double effect(int output, int parameter) {
    return found.derivatives()[output][parameter] * changes.get(parameter).by;
  }

  /** Returns the parameters, those with the largest effect first. */
  private List<Integer> byEffect(int output) {
    return IntStream.range(0, found.parameters().size())
        .boxed()
        .sorted(Comparator.comparingDouble(k -> -Math.abs(effect(output, k))))
        .toList();
  }

  private String bars(int output) {
    List<Integer> order = byEffect(output);
    double most = Math.abs(effect(output, order.get(0)));
    double middle = WIDTH / 2.0;
    StringBuilder svg = new StringBuilder();
    int height = order.size() * ROW + 6;
    svg.append("<svg class=\"chart\" role=\"img\" viewBox=\"0 0 ")
        .append(WIDTH + " " + height)
        .append("\" aria-label=\"Effects of the parameters on ")
        .append(PageFrame.escaped(found.outputs().get(output)))
        .append("\">\n");
    for (int i = 0; i < order.size(); i++) {
      int k = order.get(i);
      double effect = effect(output, k);
      double length = most > 0 ? Math.abs(effect) / most * (middle - 2) : 0;
      double left = effect < 0 ? middle - length : middle;
      int top = i * ROW;
      svg.append(text("start", 0, top + 17, found.parameters().get(k), "title"))
          .append(
              text(
                  "end",
                  WIDTH,
                  top + 17,
                  OptimiseCommand.shown(effect) + unit(found.units().get(output)),
                  "title"))
          .append(
              String.format(
                  Locale.ROOT,
                  "<rect class=\"%s\" style=\"fill:var(--c)\" x=\"%.1f\" y=\"%d\" width=\"%.1f\""
                      + " height=\"14\"><title>%s</title></rect>%n",
                  effect < 0 ? "c1" : "c0",
                  left,
                  top + 24,
                  length,
                  PageFrame.escaped(found.parameters().get(k) + ": " + changes.get(k).words)));
    }
    return svg.append(
            String.format(
                Locale.ROOT,
                "<line class=\"axis\" x1=\"%.1f\" x2=\"%.1f\" y1=\"20\" y2=\"%d\"/></svg>%n",
                middle,
                middle,
                height))
        .toString();
  }

  private static String text(String anchor, int x, int y, String words, String kind) {
    return "<text class=\""
        + kind
        + "\" text-anchor=\""
        + anchor
        + "\" x=\""
        + x
        + "\" y=\""
        + y
        + "\">"
        + PageFrame.escaped(words)
        + "</text>\n";
  }

  /** Value and effects over time, the parameters with the largest ones. */
  private String series(Group group) {
    double[] times = new double[group.to - group.from];
    List<double[]> value = new ArrayList<>();
    double worst = 0;
    for (int i = 0; i < times.length; i++) {
      int output = group.from + i;
      times[i] = values.get(output).argument();
      value.add(new double[] {times[i], found.values()[output]});
      for (int k = 0; k < found.parameters().size(); k++) {
        double error = found.derivatives()[output][k] - finer.derivatives()[output][k];
        worst = Math.max(worst, Math.abs(error * changes.get(k).by));
      }
    }
    List<Integer> shown =
        IntStream.range(0, found.parameters().size())
            .boxed()
            .sorted(Comparator.comparingDouble(k -> -largest(group, k)))
            .limit(MOST_CURVES)
            .toList();
    List<Plot.Curve> curves = new ArrayList<>();
    for (int k : shown) {
      List<double[]> rows = new ArrayList<>();
      for (int i = 0; i < times.length; i++) {
        rows.add(new double[] {times[i], effect(group.from + i, k)});
      }
      curves.add(new Plot.Curve(found.parameters().get(k), 0, curves.size(), rows, 1));
    }
    String unit = found.units().get(group.from);
    String column = group.asked.column();
    Plot plot =
        new Plot(
            column + ", and its change by each parameter along its range",
            "t",
            "s",
            List.of(""),
            List.of(
                new Plot.Panel(column, unit, List.of(new Plot.Curve(column, 0, 0, value, 1))),
                new Plot.Panel("change", unit, curves)),
            List.of());
    List<List<String>> ranges = new ArrayList<>();
    for (int k = 0; k < changes.size(); k++) {
      ranges.add(
          List.of(
              found.parameters().get(k),
              changes.get(k).words,
              OptimiseCommand.shown(largest(group, k)) + unit(unit)));
    }
    int left = found.parameters().size() - shown.size();
    return OptimumPage.picture(plot)
        + "<p class=\"note\">"
        + PageFrame.escaped(
            "Errors of the changes are "
                + digits(worst)
                + unit(unit)
                + " at most"
                + (left > 0
                    ? "; " + left + " parameters with smaller effects have no curve."
                    : "."))
        + "</p>\n"
        + OptimumPage.table(List.of("parameter", "range", "largest change"), ranges);
  }

  private double largest(Group group, int parameter) {
    return IntStream.range(group.from, group.to)
        .mapToDouble(output -> Math.abs(effect(output, parameter)))
        .max()
        .orElse(0);
  }

  private static String digits(double error) {
    return String.format(Locale.ROOT, "%.1e", error);
  }

  private static String unit(String unit) {
    return unit.equals("1") ? "" : " " + unit;
  }
}
