package org.mechservice.report.page;

import java.util.ArrayList;
import java.util.List;

/** Error against cost of any solvers by name: a diagram with its legend. */
public final class SolverChart {
  private static final int COLOURS = 8;

  private final LogLogChart chart;
  private final StringBuilder legend = new StringBuilder("<p class=\"legend\">");
  private int curves;

  /**
   * @param cost title of the horizontal axis
   * @param error title of the vertical axis
   */
  public SolverChart(String cost, String error) {
    chart = new LogLogChart(cost, error);
  }

  /**
   * A point.
   *
   * @param cost positive
   * @param error positive
   * @param hover shown when pointed at
   */
  public record Value(double cost, double error, String hover) {}

  /** Adds a solver. */
  public void add(String solver, List<Value> values) {
    CurveStyle style = new CurveStyle(curves % COLOURS, curves / 2 % 4, 0);
    curves++;
    List<LogLogChart.Mark> marks = new ArrayList<>();
    for (Value value : values) {
      marks.add(new LogLogChart.Mark(value.cost(), value.error(), "", value.hover(), false));
    }
    chart.add(new LogLogChart.Curve(style, marks, List.of()));
    legend.append("<span>").append(style.swatch()).append(Html.escape(solver)).append("</span>");
  }

  /** Returns legend and diagram. */
  public String html() {
    return legend + "</p>" + chart.svg();
  }
}
