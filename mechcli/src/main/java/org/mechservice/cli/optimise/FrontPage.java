package org.mechservice.cli.optimise;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.report.page.PageFrame;
import org.mechservice.study.optimise.Aim;
import org.mechservice.study.optimise.DesignProblem;
import org.mechservice.study.optimise.Front;
import org.mechservice.view.plot.Plot;

/** The page of a front: one objective over the other, the parameters along it, and the table. */
final class FrontPage {
  private FrontPage() {}

  static String of(String model, FrontText text) {
    String title = "Front of " + model;
    return PageFrame.of(
        title,
        "<h1>"
            + OptimumPage.escaped(title)
            + "</h1>\n<p>"
            + OptimumPage.escaped(sentence(text.summary()))
            + " At no point of it can one objective become better unless the other gets worse.</p>\n"
            + "<h2>One objective against the other</h2>\n"
            + OptimumPage.picture(objectives(text.front()))
            + "<h2>Parameters along the front</h2>\n"
            + OptimumPage.picture(parameters(text.front()))
            + "<h2>Points</h2>\n"
            + OptimumPage.table(text.columns(), text.shown()));
  }

  private static String sentence(String summary) {
    return Character.toUpperCase(summary.charAt(0)) + summary.substring(1) + ".";
  }

  private static Plot objectives(Front front) {
    List<double[]> rows = new ArrayList<>();
    int[] objectives = front.objectives();
    for (Front.Point point : front.points()) {
      rows.add(new double[] {point.values()[objectives[0]], point.values()[objectives[1]]});
    }
    Aim first = front.problem().aims().get(objectives[0]);
    Aim second = front.problem().aims().get(objectives[1]);
    return OptimumPage.plot(
        second.text() + " over " + first.text(),
        first.text(),
        List.of(
            new Plot.Panel(
                second.text(), "", List.of(new Plot.Curve(second.text(), 0, 0, rows, 1)))));
  }

  private static Plot parameters(Front front) {
    DesignProblem problem = front.problem();
    int first = front.objectives()[0];
    List<Plot.Panel> panels = new ArrayList<>();
    for (int j = 0; j < problem.variables().size(); j++) {
      List<double[]> rows = new ArrayList<>();
      for (Front.Point point : front.points()) {
        rows.add(new double[] {point.values()[first], point.point()[j]});
      }
      String name = problem.variables().get(j).name();
      panels.add(new Plot.Panel(name, "", List.of(new Plot.Curve(name, 0, j, rows, 1))));
    }
    String over = problem.aims().get(first).text();
    return OptimumPage.plot("Parameters over " + over, over, panels);
  }
}
