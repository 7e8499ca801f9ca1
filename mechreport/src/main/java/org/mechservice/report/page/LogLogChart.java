package org.mechservice.report.page;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * A diagram with logarithmic axes: one curve per method, as SVG that takes its colours from CSS.
 */
final class LogLogChart {
  private static final int WIDTH = 760;
  private static final int HEIGHT = 430;
  private static final int LEFT = 66;
  private static final int RIGHT = 48;
  private static final int TOP = 14;
  private static final int BOTTOM = 46;
  private static final double MARK = 4.2;

  /**
   * A point of a curve.
   *
   * @param x position
   * @param y position
   * @param label written beside it; may be empty
   * @param hover shown when pointed at
   * @param grey whether it means nothing
   * @param low lower end of its spread along x
   * @param high upper end
   */
  record Mark(
      double x, double y, String label, String hover, boolean grey, double low, double high) {
    /** A point without a spread. */
    Mark(double x, double y, String label, String hover, boolean grey) {
      this(x, y, label, hover, grey, x, x);
    }
  }

  /**
   * A curve.
   *
   * @param style how it is drawn
   * @param marks in order; consecutive ones are joined
   * @param failures at the right edge; their x is not used
   */
  record Curve(CurveStyle style, List<Mark> marks, List<Mark> failures) {
    Curve {
      marks = List.copyOf(marks);
      failures = List.copyOf(failures);
    }
  }

  private final String xTitle;
  private final String yTitle;
  private final List<Curve> curves = new ArrayList<>();
  private final StringBuilder under = new StringBuilder();
  private double floor = Double.NaN;
  private boolean honest;
  private double lowX = Double.POSITIVE_INFINITY;
  private double highX = Double.NEGATIVE_INFINITY;
  private double lowY = Double.POSITIVE_INFINITY;
  private double highY = Double.NEGATIVE_INFINITY;

  LogLogChart(String xTitle, String yTitle) {
    this.xTitle = xTitle;
    this.yTitle = yTitle;
  }

  /** Adds a curve. */
  LogLogChart add(Curve curve) {
    curves.add(curve);
    for (Mark mark : curve.marks()) {
      includeX(mark.low());
      includeX(mark.x());
      includeX(mark.high());
      includeY(mark.y());
    }
    for (Mark mark : curve.failures()) {
      includeY(mark.y());
    }
    return this;
  }

  /** Shades the area below a value of y. */
  LogLogChart floor(double value) {
    floor = value;
    return this;
  }

  /** Marks y = x, and the band from a hundredth to a hundred times that. */
  LogLogChart honestBand() {
    honest = true;
    return this;
  }

  private void includeX(double x) {
    if (x > 0 && Double.isFinite(x)) {
      lowX = Math.min(lowX, Math.log10(x));
      highX = Math.max(highX, Math.log10(x));
    }
  }

  private void includeY(double y) {
    if (y > 0 && Double.isFinite(y)) {
      lowY = Math.min(lowY, Math.log10(y));
      highY = Math.max(highY, Math.log10(y));
    }
  }

  /** Returns the diagram. */
  String svg() {
    if (lowX > highX) {
      lowX = 0;
      highX = 1;
    }
    if (lowY > highY) {
      lowY = 0;
      highY = 1;
    }
    lowX = lowX - 0.1;
    highX = highX + 0.1;
    lowY = Math.floor(lowY - 0.1);
    highY = Math.ceil(highY + 0.1);
    StringBuilder svg = new StringBuilder();
    svg.append(
        String.format(
            Locale.ROOT,
            "<svg class=\"chart\" viewBox=\"0 0 %d %d\" role=\"img\" aria-label=\"%s over %s\">",
            WIDTH,
            HEIGHT,
            yTitle,
            xTitle));
    band();
    svg.append(under);
    axes(svg);
    shadeFloor(svg);
    curves.forEach(curve -> draw(svg, curve));
    return svg.append("</svg>\n").toString();
  }

  private double px(double x) {
    double part = (Math.log10(x) - lowX) / (highX - lowX);
    return LEFT + Math.max(0, Math.min(1, part)) * (WIDTH - LEFT - RIGHT);
  }

  private double py(double y) {
    double part = y <= 0 ? 0 : (Math.log10(y) - lowY) / (highY - lowY);
    return HEIGHT - BOTTOM - Math.max(0, Math.min(1, part)) * (HEIGHT - TOP - BOTTOM);
  }

  private void axes(StringBuilder svg) {
    double right = WIDTH - RIGHT;
    double bottom = HEIGHT - BOTTOM;
    int xEvery = (int) Math.max(1, Math.ceil((highX - lowX) / 9));
    for (int k = (int) Math.ceil(lowX); k <= highX; k++) {
      double at = px(Math.pow(10, k));
      line(svg, "grid", at, TOP, at, bottom);
      if (k % xEvery == 0) {
        text(svg, "tick", at, bottom + 16, "middle", power(k));
      }
    }
    if (highX - lowX < 2.2) {
      minorTicks(svg, bottom);
    }
    int yEvery = (int) Math.max(1, Math.ceil((highY - lowY) / 12));
    for (int k = (int) Math.ceil(lowY); k <= highY; k++) {
      double at = py(Math.pow(10, k));
      line(svg, "grid", LEFT, at, right, at);
      if (k % yEvery == 0) {
        text(svg, "tick", LEFT - 7, at + 4, "end", power(k));
      }
    }
    line(svg, "axis", LEFT, bottom, right, bottom);
    line(svg, "axis", LEFT, TOP, LEFT, bottom);
    text(svg, "title", (LEFT + right) / 2, HEIGHT - 8, "middle", xTitle);
    svg.append(
        String.format(
            Locale.ROOT,
            "<text class=\"title\" text-anchor=\"middle\" transform=\"translate(14 %.0f)"
                + " rotate(-90)\">%s</text>",
            (TOP + bottom) / 2,
            yTitle));
  }

  /** An axis of hardly more than a decade needs numbers between the powers. */
  private void minorTicks(StringBuilder svg, double bottom) {
    for (int k = (int) Math.floor(lowX); k <= highX; k++) {
      for (int digit = 2; digit <= 5; digit += 3) {
        double value = digit * Math.pow(10, k);
        if (Math.log10(value) > lowX && Math.log10(value) < highX) {
          line(svg, "grid", px(value), TOP, px(value), bottom);
          text(svg, "tick", px(value), bottom + 16, "middle", digit + "·" + power(k));
        }
      }
    }
  }

  private static String power(int k) {
    return "10<tspan dy=\"-5\" font-size=\"8\">" + (k < 0 ? "−" + -k : "" + k) + "</tspan>";
  }

  private void shadeFloor(StringBuilder svg) {
    if (!(floor > 0) || Math.log10(floor) <= lowY) {
      return;
    }
    double top = py(floor);
    svg.append(
        String.format(
            Locale.ROOT,
            "<rect class=\"floor\" x=\"%d\" y=\"%.1f\" width=\"%d\" height=\"%.1f\"/>",
            LEFT,
            top,
            WIDTH - LEFT - RIGHT,
            HEIGHT - BOTTOM - top));
    text(
        svg,
        "note",
        LEFT + 8,
        HEIGHT - BOTTOM - 6,
        "start",
        "below " + Html.error(floor) + ": the reference cannot tell");
  }

  private void band() {
    if (!honest) {
      return;
    }
    for (double factor : new double[] {0.01, 1, 100}) {
      // Both ends lie within the diagram: y = factor x, in logarithms.
      double shift = Math.log10(factor);
      double from = Math.max(lowX, lowY - shift);
      double to = Math.min(highX, highY - shift);
      if (from < to) {
        line(
            under,
            factor == 1 ? "asked" : "bound",
            px(Math.pow(10, from)),
            py(Math.pow(10, from + shift)),
            px(Math.pow(10, to)),
            py(Math.pow(10, to + shift)));
      }
    }
  }

  private void draw(StringBuilder svg, Curve curve) {
    svg.append("<g class=\"curve ").append(curve.style().css()).append("\">");
    Mark before = null;
    for (Mark mark : curve.marks()) {
      if (before != null) {
        String css = mark.grey() || before.grey() ? "path grey" : "path";
        line(svg, css, px(before.x()), py(before.y()), px(mark.x()), py(mark.y()));
      }
      before = mark;
    }
    for (Mark mark : curve.marks()) {
      point(svg, curve.style(), mark);
    }
    for (int i = 0; i < curve.failures().size(); i++) {
      cross(svg, curve.failures().get(i), curve.style().offset());
    }
    svg.append("</g>\n");
  }

  private void point(StringBuilder svg, CurveStyle style, Mark mark) {
    double x = px(mark.x());
    double y = py(mark.y());
    if (px(mark.high()) - px(mark.low()) > MARK) {
      line(svg, "spread", px(mark.low()), y, px(mark.high()), y);
    }
    svg.append("<path class=\"mark").append(mark.grey() ? " grey" : "").append("\" d=\"");
    svg.append(style.outline(x, y, MARK));
    svg.append("\" data-t=\"").append(Html.escape(mark.hover())).append("\"/>");
    if (!mark.label().isEmpty()) {
      text(svg, "asked-at", x + 6, y - 5, "start", mark.label());
    }
  }

  private void cross(StringBuilder svg, Mark mark, double offset) {
    double x = WIDTH - RIGHT + 10 + offset;
    double y = py(mark.y());
    svg.append(
        String.format(
            Locale.ROOT,
            "<path class=\"fail\" d=\"M%.1f %.1fl7 7m0 -7l-7 7\" data-t=\"%s\"/>",
            x - 3.5,
            y - 3.5,
            Html.escape(mark.hover())));
  }

  private static void line(
      StringBuilder svg, String css, double x1, double y1, double x2, double y2) {
    svg.append(
        String.format(
            Locale.ROOT, "<path class=\"%s\" d=\"M%.1f %.1fL%.1f %.1f\"/>", css, x1, y1, x2, y2));
  }

  private static void text(
      StringBuilder svg, String css, double x, double y, String anchor, String text) {
    svg.append(
        String.format(
            Locale.ROOT,
            "<text class=\"%s\" x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">%s</text>",
            css,
            x,
            y,
            anchor,
            text));
  }
}
