package org.mechservice.cli.optimise;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.mechservice.report.page.PageFrame;
import org.mechservice.study.identify.Identification;
import org.mechservice.study.identify.Measurements;
import org.mechservice.study.identify.Measurements.Sample;
import org.mechservice.study.identify.Profile;
import org.mechservice.study.optimise.DesignVariable;
import org.mechservice.view.plot.Plot;

/** The page of an identification: parameters with intervals, correlations, fit and residuals. */
final class FitPage {
  private FitPage() {}

  static String of(
      String model,
      Identification found,
      Measurements measured,
      List<Profile> profiles,
      double level) {
    String title = "Parameters of " + model + " from measurements";
    StringBuilder open = new StringBuilder();
    found
        .undetermined()
        .forEach(
            words ->
                open.append("<p><b>").append(OptimumPage.escaped(words)).append(".</b></p>\n"));
    return PageFrame.of(
        title,
        "<h1>"
            + OptimumPage.escaped(title)
            + "</h1>\n<p>"
            + OptimiseCommand.counted(found.residuals().length, "measured value")
            + ", "
            + OptimiseCommand.counted(found.runs(), "run")
            + ". The residuals have a size of "
            + OptimiseCommand.shown(found.noise())
            + " standard deviations: 1 if the given standard deviations and the model are right."
            + "</p>\n"
            + open
            + "<h2>Parameters</h2>\n"
            + parameters(found, level)
            + profiles(found, profiles, level)
            + "<h2>Correlation</h2>\n"
            + correlation(found)
            + "<h2>Fit</h2>\n"
            + OptimumPage.picture(fit(found, measured))
            + "<h2>Residuals in standard deviations</h2>\n"
            + OptimumPage.picture(residuals(found, measured)));
  }

  private static String parameters(Identification found, double level) {
    List<List<String>> rows = new ArrayList<>();
    for (int j = 0; j < found.values().length; j++) {
      DesignVariable variable = found.variables().get(j);
      rows.add(
          List.of(
              variable.name(),
              OptimiseCommand.shown(found.values()[j]),
              IdentifyCommand.interval(found, j, level).strip(),
              OptimiseCommand.shown(variable.lower())
                  + " to "
                  + OptimiseCommand.shown(variable.upper()),
              OptimiseCommand.place(found.bound(j))));
    }
    String interval = "interval of " + OptimiseCommand.shown(100 * level) + " %";
    return OptimumPage.table(List.of("parameter", "value", interval, "bounds", ""), rows);
  }

  /** τ over each parameter, with the linear theory beside it. */
  private static String profiles(Identification found, List<Profile> profiles, double level) {
    if (profiles.isEmpty()) {
      return "";
    }
    StringBuilder html = new StringBuilder("<h2>Profiles</h2>\n");
    html.append("<p>Each parameter is held beside its value, and the others are fitted anew: ");
    html.append("&tau; counts the standard deviations by which the fit gets worse. The straight ");
    html.append("line is what a model would do that is linear in its parameters.</p>\n");
    for (Profile profile : profiles) {
      String name = found.variables().get(profile.variable()).name();
      double value = found.values()[profile.variable()];
      double deviation = found.deviations()[profile.variable()];
      List<double[]> linear = new ArrayList<>();
      if (Double.isFinite(deviation)) {
        profile.points().forEach(p -> linear.add(new double[] {p[0], (p[0] - value) / deviation}));
      }
      List<Plot.Curve> curves = new ArrayList<>();
      curves.add(new Plot.Curve("profile", 0, 0, profile.points(), 1));
      if (!linear.isEmpty()) {
        curves.add(new Plot.Curve("linear", 0, 1, linear, 1));
      }
      html.append(
          OptimumPage.picture(
              OptimumPage.plot(
                  "Profile of " + name, name, List.of(new Plot.Panel("τ", "", curves)))));
      html.append("<p>");
      html.append(OptimumPage.escaped(sentence(IdentifyCommand.sentence(found, profile), level)));
      html.append("</p>\n");
    }
    return html.toString();
  }

  private static String sentence(String words, double level) {
    return "Interval of " + OptimiseCommand.shown(100 * level) + " % by the " + words + ".";
  }

  private static String correlation(Identification found) {
    List<String> head = new ArrayList<>(List.of(""));
    found.variables().forEach(variable -> head.add(variable.name()));
    List<List<String>> rows = new ArrayList<>();
    for (int i = 0; i < found.values().length; i++) {
      List<String> row = new ArrayList<>(List.of(found.variables().get(i).name()));
      for (double cell : found.correlation()[i]) {
        row.add(Double.isNaN(cell) ? "–" : String.format(Locale.ROOT, "%.3f", cell));
      }
      rows.add(row);
    }
    return "<div style=\"overflow-x:auto\">" + OptimumPage.table(head, rows) + "</div>\n";
  }

  /** Rows of time, measured value, computed value and residual for each output. */
  private static Map<String, List<double[]>> byOutput(Identification found, Measurements measured) {
    Map<String, List<double[]>> rows = new LinkedHashMap<>();
    for (int i = 0; i < found.residuals().length; i++) {
      Sample sample = measured.samples().get(i);
      double residual = found.residuals()[i];
      rows.computeIfAbsent(sample.output(), name -> new ArrayList<>())
          .add(
              new double[] {
                sample.time(),
                sample.value(),
                sample.value() + residual * sample.deviation(),
                residual
              });
    }
    return rows;
  }

  private static Plot fit(Identification found, Measurements measured) {
    List<Plot.Panel> panels = new ArrayList<>();
    byOutput(found, measured)
        .forEach(
            (output, rows) ->
                panels.add(
                    new Plot.Panel(
                        output,
                        "",
                        List.of(
                            new Plot.Curve("measured", 0, 0, rows, 1),
                            new Plot.Curve("computed", 0, 1, rows, 2)))));
    return OptimumPage.plot("Measured and computed", "t", panels);
  }

  private static Plot residuals(Identification found, Measurements measured) {
    List<Plot.Panel> panels = new ArrayList<>();
    byOutput(found, measured)
        .forEach(
            (output, rows) ->
                panels.add(
                    new Plot.Panel(output, "", List.of(new Plot.Curve(output, 0, 0, rows, 3)))));
    return OptimumPage.plot("Residuals", "t", panels);
  }
}
