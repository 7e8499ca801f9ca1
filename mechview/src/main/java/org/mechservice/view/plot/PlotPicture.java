package org.mechservice.view.plot;

import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.mechservice.view.drawing.Canvas;
import org.mechservice.view.drawing.Ink;
import org.mechservice.view.drawing.Label;
import org.mechservice.view.drawing.Label.Anchoring;
import org.mechservice.view.drawing.Pen;

/** Draws a diagram: panels above each other, each with its legend at the right. */
public final class PlotPicture {
  private static final double WIDTH = 880;
  private static final double MARGIN = 16;
  private static final double FONT = 12;
  private static final double LINE = 17;
  private static final double SAMPLE = 24;
  private static final double GAP = 8;
  private static final double WIDEST_NAME = 190;
  private static final double SINGLE = 360;
  private static final double STACKED = 190;
  private static final double BETWEEN = 22;
  private static final double CURVE = 1.6;

  /** Points nearer to the last one than this are not drawn, px. */
  private static final double INVISIBLE = 0.25;

  private final Plot plot;
  private final Ticks x;
  private final List<Ticks> ys = new ArrayList<>();
  private final List<Double> heights = new ArrayList<>();
  private final boolean inTime;
  private final double left;
  private final double right;
  private final double top;
  private final double bottom;
  private final double height;

  private PlotPicture(Plot plot) {
    this.plot = plot;
    List<Plot.Curve> all = plot.panels().stream().flatMap(p -> p.curves().stream()).toList();
    inTime = all.stream().allMatch(PlotPicture::advances);
    double[] xs = range(all, true);
    x = new Ticks(xs[0], xs[1], inTime ? 0 : 0.04, 9);
    double widestTick = 0;
    double widestName = 0;
    double panels = 0;
    for (Plot.Panel panel : plot.panels()) {
      int entries = legend(panel).size();
      double base = plot.panels().size() == 1 ? SINGLE : STACKED;
      double one = Math.max(base, entries * LINE + 4);
      heights.add(one);
      panels += one;
      double[] range = range(panel.curves(), false);
      Ticks ticks = new Ticks(range[0], range[1], 0.05, (int) Math.max(4, one / 36));
      ys.add(ticks);
      for (String label : ticks.labels()) {
        widestTick = Math.max(widestTick, Label.width(label, FONT));
      }
      for (String name : legend(panel).keySet()) {
        widestName = Math.max(widestName, Math.min(WIDEST_NAME, Label.width(name, FONT)));
      }
    }
    left = MARGIN + FONT + GAP + widestTick + GAP;
    right = WIDTH - MARGIN - widestName - SAMPLE - 3 * GAP;
    top = MARGIN + 26 + (plot.runs().size() > 1 ? runRows().size() * LINE + 4 : 0);
    bottom = top + panels + BETWEEN * (plot.panels().size() - 1);
    height = bottom + 46 + (plot.notes().isEmpty() ? 0 : plot.notes().size() * LINE + 2) + 6;
  }

  /** Draws a diagram. */
  public static Canvas draw(Plot plot) {
    return new PlotPicture(plot).canvas();
  }

  /** Returns in words what a diagram shows, for readers that cannot see it. */
  static String description(Plot plot) {
    StringBuilder text = new StringBuilder();
    for (Plot.Panel panel : plot.panels()) {
      List<String> names = panel.curves().stream().map(Plot.Curve::name).distinct().toList();
      text.append(String.join(", ", names));
      text.append(panel.unit().isEmpty() ? "" : " in " + panel.unit());
      double[] range = range(panel.curves(), false);
      text.append(", from ").append(shortNumber(range[0])).append(" to ");
      text.append(shortNumber(range[1])).append("; ");
    }
    text.append("over ").append(plot.xName());
    return text.append(plot.xUnit().isEmpty() ? "" : " in " + plot.xUnit()).append('.').toString();
  }

  private static String shortNumber(double value) {
    return String.format(Locale.ROOT, "%.4g", value);
  }

  static boolean advances(Plot.Curve curve) {
    for (int i = 1; i < curve.size(); i++) {
      if (curve.x(i) < curve.x(i - 1)) {
        return false;
      }
    }
    return true;
  }

  /** Returns least and greatest number; 0 and 1 if there are none. */
  private static double[] range(List<Plot.Curve> curves, boolean ofX) {
    double least = Double.POSITIVE_INFINITY;
    double greatest = Double.NEGATIVE_INFINITY;
    for (Plot.Curve curve : curves) {
      for (int i = 0; i < curve.size(); i++) {
        double value = ofX ? curve.x(i) : curve.y(i);
        if (!Double.isNaN(value)) {
          least = Math.min(least, value);
          greatest = Math.max(greatest, value);
        }
      }
    }
    return least > greatest ? new double[] {0, 1} : new double[] {least, greatest};
  }

  /** Returns the pens of a panel's columns by name. */
  private Map<String, Pen> legend(Plot.Panel panel) {
    Map<String, Pen> pens = new LinkedHashMap<>();
    for (Plot.Curve curve : panel.curves()) {
      int dash = plot.runs().size() > 1 ? 0 : curve.colour() / Ink.CURVE_COUNT;
      pens.putIfAbsent(curve.name(), new Pen(Ink.curve(curve.colour()), 2.2).dashed(dash));
    }
    return pens;
  }

  private Pen pen(Plot.Curve curve, int run) {
    Pen pen = new Pen(Ink.curve(curve.colour()), CURVE);
    return plot.runs().size() > 1 ? ofRun(pen, run) : pen.dashed(curve.colour() / Ink.CURVE_COUNT);
  }

  /** The first run is drawn broad, so that others that run along it do not hide it. */
  private static Pen ofRun(Pen pen, int run) {
    return run == 0 ? pen.broad() : pen.dashed(run - 1);
  }

  /** Returns the names of the runs in lines that fit the picture. */
  private List<List<Integer>> runRows() {
    List<List<Integer>> rows = new ArrayList<>();
    double used = WIDTH;
    for (int run = 0; run < plot.runs().size(); run++) {
      double needed = SAMPLE + 3 * GAP + runWidth(run);
      if (used + needed > WIDTH - 2 * MARGIN) {
        rows.add(new ArrayList<>());
        used = 0;
      }
      rows.get(rows.size() - 1).add(run);
      used += needed;
    }
    return rows;
  }

  private double runWidth(int run) {
    return Math.min(2 * WIDEST_NAME, Label.width(plot.runs().get(run), FONT));
  }

  private Canvas canvas() {
    Canvas canvas = new Canvas(WIDTH, height, plot.title(), description(plot));
    String title = Label.shortened(plot.title(), FONT + 2, 0.9 * (WIDTH - 2 * MARGIN));
    canvas.write(
        new Label(MARGIN, MARGIN + 12, title, FONT + 2, Anchoring.START, Ink.TEXT).inBold());
    if (plot.runs().size() > 1) {
      runs(canvas);
    }
    double y = top;
    for (int i = 0; i < plot.panels().size(); i++) {
      panel(canvas, i, y);
      y += heights.get(i) + BETWEEN;
    }
    horizontalAxis(canvas);
    double note = bottom + 46 + FONT;
    for (String text : plot.notes()) {
      String fitting = Label.shortened(text, FONT - 1, WIDTH - 2 * MARGIN);
      canvas.write(new Label(MARGIN, note, fitting, FONT - 1, Anchoring.START, Ink.MUTED));
      note += LINE;
    }
    return canvas;
  }

  private void runs(Canvas canvas) {
    double y = MARGIN + 34;
    for (List<Integer> row : runRows()) {
      double at = MARGIN;
      for (int run : row) {
        Pen pen = ofRun(new Pen(Ink.MUTED, CURVE), run);
        canvas.draw(new Line2D.Double(at, y - 4, at + SAMPLE + GAP, y - 4), pen);
        at += SAMPLE + 2 * GAP;
        String name = Label.shortened(plot.runs().get(run), FONT, 2 * WIDEST_NAME);
        canvas.write(new Label(at, y, name, FONT, Anchoring.START, Ink.TEXT));
        at += runWidth(run) + GAP;
      }
      y += LINE;
    }
  }

  private void panel(Canvas canvas, int index, double y) {
    Plot.Panel panel = plot.panels().get(index);
    Ticks ticks = ys.get(index);
    double h = heights.get(index);
    Pen grid = new Pen(Ink.GRID, 1);
    for (double part : x.parts()) {
      double at = left + part * (right - left);
      canvas.draw(new Line2D.Double(at, y, at, y + h), grid);
    }
    for (int i = 0; i < ticks.parts().size(); i++) {
      double at = y + h * (1 - ticks.parts().get(i));
      canvas.draw(new Line2D.Double(left, at, right, at), grid);
      String label = ticks.labels().get(i);
      canvas.write(new Label(left - GAP, at + 4, label, FONT, Anchoring.END, Ink.MUTED));
    }
    canvas.draw(new Line2D.Double(left, y + h, right, y + h), new Pen(Ink.AXIS, 1));
    canvas.draw(new Line2D.Double(left, y, left, y + h), new Pen(Ink.AXIS, 1));
    String title = Label.shortened(ticks.title(panel.quantity(), panel.unit()), FONT, h);
    canvas.write(
        new Label(MARGIN + FONT - 2, y + h / 2, title, FONT, Anchoring.MIDDLE, Ink.TEXT)
            .runningUp());
    canvas.clipped(
        left,
        y - CURVE,
        right - left + CURVE,
        h + 2 * CURVE,
        () ->
            panel.curves().stream()
                .sorted(Comparator.comparingInt(Plot.Curve::run))
                .forEach(curve -> curve(canvas, curve, ticks, y, h)));
    double at = y + FONT - 2;
    for (Map.Entry<String, Pen> entry : legend(panel).entrySet()) {
      double sample = right + 2 * GAP;
      canvas.draw(new Line2D.Double(sample, at - 4, sample + SAMPLE, at - 4), entry.getValue());
      String name = Label.shortened(entry.getKey(), FONT, WIDEST_NAME);
      canvas.write(new Label(sample + SAMPLE + GAP, at, name, FONT, Anchoring.START, Ink.TEXT));
      at += LINE;
    }
  }

  private void horizontalAxis(Canvas canvas) {
    double free = 0;
    for (int i = 0; i < x.parts().size(); i++) {
      double at = left + x.parts().get(i) * (right - left);
      Label label =
          new Label(at, bottom + 17, x.labels().get(i), FONT, Anchoring.MIDDLE, Ink.MUTED);
      if (label.box().getMinX() > free) {
        canvas.write(label);
        free = label.box().getMaxX() + GAP / 2;
      }
    }
    String title = x.title(plot.xName(), plot.xUnit());
    canvas.write(
        new Label((left + right) / 2, bottom + 37, title, FONT, Anchoring.MIDDLE, Ink.TEXT));
  }

  private void curve(Canvas canvas, Plot.Curve curve, Ticks y, double above, double h) {
    Path2D path = new Path2D.Double();
    Path2D points = new Path2D.Double();
    Outline outline = new Outline(path, points, inTime);
    for (int i = 0; i < curve.size(); i++) {
      outline.add(left + x.part(curve.x(i)) * (right - left), above + h * (1 - y.part(curve.y(i))));
    }
    outline.end();
    String name =
        curve.name() + (plot.runs().size() > 1 ? ", " + plot.runs().get(curve.run()) : "");
    Pen pen = pen(curve, curve.run());
    canvas.part(
        name,
        () -> {
          if (path.getCurrentPoint() != null) {
            canvas.draw(path, pen);
          }
          if (points.getCurrentPoint() != null) {
            canvas.fill(points, pen.ink());
          }
        });
  }

  /** Points of a curve on their way to a path, without those that change nothing to be seen. */
  private static final class Outline {
    private static final double DOT = 2.5;

    private final Path2D path;
    private final Path2D points;
    private final boolean advancing;
    private final List<double[]> column = new ArrayList<>();
    private double[] last = {};
    private int inLine;

    Outline(Path2D path, Path2D points, boolean advancing) {
      this.path = path;
      this.points = points;
      this.advancing = advancing;
    }

    void add(double x, double y) {
      if (Double.isNaN(x) || Double.isNaN(y)) {
        end();
        return;
      }
      if (advancing && !column.isEmpty() && x - column.get(0)[0] < 2 * INVISIBLE) {
        column.add(new double[] {x, y});
        return;
      }
      flush();
      column.add(new double[] {x, y});
    }

    /** Ends a line: a gap follows, or nothing. A single point becomes a dot. */
    void end() {
      flush();
      if (inLine == 1) {
        points.append(new Ellipse2D.Double(last[0] - DOT, last[1] - DOT, 2 * DOT, 2 * DOT), false);
      }
      inLine = 0;
      last = new double[0];
    }

    /** Writes first, least, greatest and last of the points that lie above each other. */
    private void flush() {
      int least = 0;
      int greatest = 0;
      for (int i = 1; i < column.size(); i++) {
        least = column.get(i)[1] < column.get(least)[1] ? i : least;
        greatest = column.get(i)[1] > column.get(greatest)[1] ? i : greatest;
      }
      int end = column.size() - 1;
      for (int i = 0; i <= end; i++) {
        if (i == 0 || i == least || i == greatest || i == end) {
          put(column.get(i));
        }
      }
      column.clear();
    }

    private void put(double[] point) {
      if (inLine == 0) {
        path.moveTo(point[0], point[1]);
      } else if (Math.hypot(point[0] - last[0], point[1] - last[1]) < INVISIBLE) {
        inLine++;
        return;
      } else {
        path.lineTo(point[0], point[1]);
      }
      inLine++;
      last = point;
    }
  }
}
