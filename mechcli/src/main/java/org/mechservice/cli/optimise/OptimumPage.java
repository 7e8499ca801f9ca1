package org.mechservice.cli.optimise;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.report.page.PageFrame;
import org.mechservice.study.optimise.DesignVariable;
import org.mechservice.study.optimise.Optimum;
import org.mechservice.study.optimise.Trial;
import org.mechservice.view.drawing.Svg;
import org.mechservice.view.drawing.Theme;
import org.mechservice.view.plot.Plot;
import org.mechservice.view.plot.PlotPicture;

/** The page of an optimisation: the optimum in tables, the way to it in pictures. */
final class OptimumPage {
  private OptimumPage() {}

  static String of(String model, Optimum optimum) {
    String title = "Optimum of " + model;
    return PageFrame.of(
        title,
        "<h1>"
            + escaped(title)
            + "</h1>\n<p>Method "
            + optimum.method().label()
            + ", "
            + OptimiseCommand.counted(optimum.starts().size(), "start")
            + ", "
            + OptimiseCommand.counted(optimum.runs(), "run")
            + ", "
            + optimum.failures()
            + " failed."
            + (optimum.best().isFeasible() ? "" : " <b>No point satisfies all constraints.</b>")
            + OptimiseCommand.optimality(optimum)
                .map(said -> "</p>\n<p>The best point is " + escaped(said) + ".")
                .orElse("")
            + "</p>\n<h2>Parameters</h2>\n"
            + variables(optimum)
            + "<h2>What was asked</h2>\n"
            + aims(optimum)
            + "<h2>Best point so far</h2>\n"
            + picture(convergence(optimum))
            + "<h2>Points tried</h2>\n"
            + picture(points(optimum))
            + starts(optimum));
  }

  private static String variables(Optimum optimum) {
    List<List<String>> rows = new ArrayList<>();
    for (int j = 0; j < optimum.best().point().length; j++) {
      DesignVariable variable = optimum.problem().variables().get(j);
      rows.add(
          List.of(
              variable.name(),
              OptimiseCommand.shown(variable.start()),
              OptimiseCommand.shown(optimum.best().point()[j]),
              OptimiseCommand.shown(variable.lower())
                  + " to "
                  + OptimiseCommand.shown(variable.upper()),
              OptimiseCommand.place(optimum.bound(j))));
    }
    return table(List.of("parameter", "first value", "optimum", "bounds", ""), rows);
  }

  private static String aims(Optimum optimum) {
    List<List<String>> rows = new ArrayList<>();
    for (int i = 0; i < optimum.best().values().length; i++) {
      rows.add(
          List.of(
              optimum.problem().aims().get(i).text(),
              OptimiseCommand.shown(optimum.best().values()[i]),
              OptimiseCommand.standing(optimum, i)));
    }
    return table(List.of("formula", "value (of a constraint: left - right)", ""), rows);
  }

  private static String starts(Optimum optimum) {
    List<List<String>> rows = new ArrayList<>();
    for (int k = 0; k < optimum.starts().size(); k++) {
      Optimum.Start start = optimum.starts().get(k);
      Optional<Trial> best = start.best();
      rows.add(
          List.of(
              String.valueOf(k + 1),
              String.valueOf(start.trials().size()),
              best.map(trial -> OptimiseCommand.shown(trial.objective())).orElse(""),
              best.map(trial -> trial.isFeasible() ? "yes" : "no").orElse(""),
              start.ended().orElse("the method was done")));
    }
    return "<h2>Starts</h2>\n"
        + table(List.of("start", "runs", "best objective", "feasible", "ended"), rows);
  }

  /** Objective of the best point so far over the runs, one curve for each start. */
  private static Plot convergence(Optimum optimum) {
    List<Plot.Curve> curves = new ArrayList<>();
    for (int k = 0; k < optimum.starts().size(); k++) {
      List<double[]> rows = new ArrayList<>();
      Optional<Trial> best = Optional.empty();
      List<Trial> trials = optimum.starts().get(k).trials();
      boolean anyFeasible = trials.stream().anyMatch(Trial::isFeasible);
      for (Trial trial : trials) {
        boolean counts = trial.failure().isEmpty() && (trial.isFeasible() || !anyFeasible);
        if (counts && (best.isEmpty() || trial.objective() < best.get().objective())) {
          best = Optional.of(trial);
        }
        if (best.isPresent()) {
          rows.add(new double[] {trial.run(), best.get().objective()});
        }
      }
      curves.add(new Plot.Curve("start " + (k + 1), 0, k, rows, 1));
    }
    return plot(
        "Objective of the best point so far",
        "run",
        List.of(new Plot.Panel("objective", "", curves)));
  }

  /** Each parameter over the runs of the start with the optimum. */
  private static Plot points(Optimum optimum) {
    List<Trial> trials = optimum.starts().get(optimum.best().start() - 1).trials();
    List<Plot.Panel> panels = new ArrayList<>();
    List<DesignVariable> variables = optimum.problem().variables();
    for (int j = 0; j < variables.size(); j++) {
      List<double[]> rows = new ArrayList<>();
      for (Trial trial : trials) {
        rows.add(new double[] {trial.run(), trial.point()[j]});
      }
      String name = variables.get(j).name();
      panels.add(new Plot.Panel(name, "", List.of(new Plot.Curve(name, 0, j, rows, 1))));
    }
    return plot("Parameters of start " + optimum.best().start(), "run", panels);
  }

  static Plot plot(String title, String x, List<Plot.Panel> panels) {
    return new Plot(title, x, "", List.of(""), panels, List.of());
  }

  /** A picture keeps its size: on a phone it is moved sideways, not the page. */
  static String picture(Plot plot) {
    return "<div class=\"wide\">" + Svg.of(PlotPicture.draw(plot), Theme.AUTOMATIC) + "</div>\n";
  }

  static String table(List<String> head, List<List<String>> rows) {
    StringBuilder html = new StringBuilder("<table><thead><tr>");
    head.forEach(cell -> html.append("<th>").append(escaped(cell)).append("</th>"));
    html.append("</tr></thead><tbody>\n");
    for (List<String> row : rows) {
      html.append("<tr>");
      row.forEach(cell -> html.append("<td>").append(escaped(cell)).append("</td>"));
      html.append("</tr>\n");
    }
    return html.append("</tbody></table>\n").toString();
  }

  static String escaped(String text) {
    return PageFrame.escaped(text);
  }
}
