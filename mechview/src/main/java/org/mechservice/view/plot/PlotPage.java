package org.mechservice.view.plot;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.mechservice.view.drawing.Ink;
import org.mechservice.view.drawing.Pen;
import org.mechservice.view.drawing.Svg;
import org.mechservice.view.drawing.Theme;

/**
 * Writes a diagram as one HTML page that needs no network: zoom by dragging, values at the cursor,
 * the same section of time in all panels. Its content security policy allows the page's own scripts
 * by their digests and nothing else.
 */
public final class PlotPage {
  private static final String UPLOT = "/META-INF/resources/webjars/uplot/1.6.30/dist/uPlot.";

  /** Escapes what could end a script element. */
  private static final Gson JSON = new GsonBuilder().serializeNulls().create();

  private PlotPage() {}

  /**
   * Returns the page.
   *
   * @param theme colours; those of the reader's preference for {@link Theme#AUTOMATIC}
   */
  public static String of(Plot plot, Theme theme) {
    String uplot = resource(UPLOT + "iife.min.js");
    String script = resource("plot.js");
    StringBuilder panels = new StringBuilder();
    for (int i = 0; i < plot.panels().size(); i++) {
      Plot.Panel panel = plot.panels().get(i);
      List<String> names = panel.curves().stream().map(Plot.Curve::name).distinct().toList();
      panels
          .append("<div class=\"panel\" id=\"panel-")
          .append(i)
          .append("\" tabindex=\"0\" role=\"img\" aria-label=\"")
          .append(Svg.escape(title(panel) + ": " + String.join(", ", names)))
          .append("\"></div>\n");
    }
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
        + "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none';"
        + " script-src "
        + digest(uplot)
        + " "
        + digest(script)
        + "; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'\">\n"
        + "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>"
        + Svg.escape(plot.title())
        + "</title>\n<style>"
        + colours(theme)
        + resource(UPLOT + "min.css")
        + resource("plot.css")
        + "</style></head><body><main>\n<h1>"
        + Svg.escape(plot.title())
        + "</h1>\n"
        + runs(plot)
        + "<p>"
        + (inTime(plot)
            ? "Drag over a part to see it larger; <kbd>Esc</kbd> shows the whole. Arrow keys move"
                + " the cursor in the panel that has the focus; a name in the legend hides its"
                + " curve."
            : "Drag over a part to see it larger; <kbd>Esc</kbd> shows the whole.")
        + " <button type=\"button\" id=\"whole\">Show the whole</button></p>\n"
        + panels
        + notes(plot)
        + "<noscript><p>"
        + Svg.escape(PlotPicture.description(plot))
        + " The curves need JavaScript.</p></noscript>\n</main>\n"
        + "<script type=\"application/json\" id=\"data\">"
        + JSON.toJson(data(plot))
        + "</script>\n<script>"
        + uplot
        + "</script>\n<script>"
        + script
        + "</script>\n</body></html>\n";
  }

  private static String colours(Theme theme) {
    String base = variables(theme);
    String dark = "@media (prefers-color-scheme:dark){" + variables(Theme.DARK) + "}\n";
    return theme == Theme.AUTOMATIC ? base + dark : base;
  }

  private static String variables(Theme theme) {
    StringBuilder css = new StringBuilder(":root{");
    for (Ink ink : List.of(Ink.PAGE, Ink.TEXT, Ink.MUTED, Ink.GRID, Ink.AXIS, Ink.BODY)) {
      css.append("--").append(ink.name().toLowerCase(Locale.ROOT)).append(':');
      css.append(ink.hex(theme)).append(';');
    }
    for (int i = 0; i < Ink.CURVE_COUNT; i++) {
      css.append("--c").append(i).append(':').append(Ink.curve(i).hex(theme)).append(';');
    }
    return css.append("}\n").toString();
  }

  private static String runs(Plot plot) {
    if (plot.runs().size() < 2) {
      return "";
    }
    StringBuilder html = new StringBuilder("<p class=\"runs\">");
    for (int run = 0; run < plot.runs().size(); run++) {
      html.append("<span><i class=\"run")
          .append(run == 0 ? "0" : 1 + (run - 1) % Pen.DASH_COUNT)
          .append("\"></i>")
          .append(Svg.escape(plot.runs().get(run)))
          .append("</span>");
    }
    return html.append("</p>\n").toString();
  }

  private static String notes(Plot plot) {
    StringBuilder html = new StringBuilder();
    for (String note : plot.notes()) {
      html.append("<p>").append(Svg.escape(note)).append(".</p>\n");
    }
    return html.toString();
  }

  private static String title(Plot.Panel panel) {
    return named(panel.quantity(), panel.unit());
  }

  private static String named(String name, String unit) {
    return name.isEmpty() ? unit : unit.isEmpty() ? name : name + " (" + unit + ")";
  }

  private static boolean inTime(Plot plot) {
    return plot.panels().stream()
        .flatMap(panel -> panel.curves().stream())
        .allMatch(PlotPicture::advances);
  }

  private static Map<String, Object> data(Plot plot) {
    Map<Integer, List<double[]>> rows = new LinkedHashMap<>();
    List<Object> panels = new ArrayList<>();
    for (Plot.Panel panel : plot.panels()) {
      List<Object> curves = new ArrayList<>();
      for (Plot.Curve curve : panel.curves()) {
        rows.put(curve.run(), curve.table());
        curves.add(
            Map.of(
                "name", curve.name(),
                "run", curve.run(),
                "colour", curve.colour(),
                "column", curve.column()));
      }
      panels.add(Map.of("title", title(panel), "curves", curves));
    }
    List<Object> tables = new ArrayList<>();
    for (int run = 0; run < plot.runs().size(); run++) {
      tables.add(columns(rows.getOrDefault(run, List.of())));
    }
    return Map.of(
        "x", named(plot.xName(), plot.xUnit()),
        "xName", plot.xName(),
        "inTime", inTime(plot),
        "runs", plot.runs(),
        "tables", tables,
        "panels", panels);
  }

  /** Returns one list for each column, with null for a gap. */
  private static List<List<Number>> columns(List<double[]> rows) {
    List<List<Number>> columns = new ArrayList<>();
    int count = rows.isEmpty() ? 0 : rows.get(0).length;
    for (int c = 0; c < count; c++) {
      List<Number> column = new ArrayList<>();
      for (double[] row : rows) {
        column.add(Double.isNaN(row[c]) ? null : row[c]);
      }
      columns.add(column);
    }
    return columns;
  }

  private static String digest(String script) {
    try {
      byte[] sha =
          MessageDigest.getInstance("SHA-256").digest(script.getBytes(StandardCharsets.UTF_8));
      return "'sha256-" + Base64.getEncoder().encodeToString(sha) + "'";
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java platform has SHA-256", e);
    }
  }

  private static String resource(String name) {
    try (InputStream in = PlotPage.class.getResourceAsStream(name)) {
      if (in == null) {
        throw new IllegalStateException("resource " + name + " is missing");
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
