package org.mechservice.benchmarks.suite;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import org.mechservice.report.Machine;
import org.mechservice.report.measure.EqualError;
import org.mechservice.report.page.PageFrame;
import org.mechservice.report.page.SolverChart;

/** The page of the suite: what each integrator pays for its digits. */
final class SuitePage {
  /** The file with every run. */
  static final String CSV = "integrators.csv";

  private static final double[] LEVELS = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};

  private final List<ProblemFile> problems;
  private final List<SuiteRun> runs;
  private final StringBuilder html = new StringBuilder();

  private SuitePage(List<ProblemFile> problems, List<SuiteRun> runs) {
    this.problems = problems;
    this.runs = runs;
  }

  static String of(List<ProblemFile> problems, List<SuiteRun> runs, String peers) {
    SuitePage page = new SuitePage(problems, runs);
    page.write(peers);
    return PageFrame.of("Integrators on verified problems", page.html.toString());
  }

  private void write(String peers) {
    html.append("<h1>Integrators on verified problems</h1><p class=\"sub\">");
    html.append(problems.size()).append(" problems");
    html.append(
        peers.isEmpty()
            ? " · Hipparchus in the same run"
            : " · Hipparchus, " + PageFrame.escaped(peers) + " in the same run");
    html.append("</p>");
    comparison(false);
    comparison(true);
    problems.forEach(this::problem);
    html.append("<p class=\"note\">Error: the largest |y − ref| / (|ref| + scale) at the end over");
    html.append(" the components that count, against references verified to 13 digits and more.");
    html.append(" Evaluations include those for Jacobians by differences. ");
    html.append("Peers' failures are shown as their own. Every run: <a href=\"").append(CSV);
    html.append("\">").append(CSV).append("</a>. ");
    html.append(String.join(" · ", Machine.facts())).append("</p>");
  }

  /** Evaluations at equal error against those of our own integrator for the kind. */
  private void comparison(boolean stiff) {
    String own = stiff ? "ode15s" : "ode113";
    html.append("<section class=\"advice\"><h2>").append(stiff ? "Stiff" : "Nonstiff");
    html.append(" problems at equal error, ").append(own).append(" = 1</h2><table>");
    html.append("<tr><th>integrator<th>evaluations<th>").append(own).append(" needs fewer");
    html.append("<th>time<th>").append(own).append(" is faster");
    for (String solver : solvers(stiff)) {
      if (!solver.equals(own)) {
        html.append("<tr><td>").append(solver);
        html.append(ratios(solver, own, stiff, run -> (double) run.evaluations()));
        html.append(ratios(solver, own, stiff, SuiteRun::seconds));
      }
    }
    html.append(
        "</table><p class=\"note\">Geometric means over the problems and the errors 1e-3 to");
    html.append(
        " 1e-8 that both reach. Times: of those whose equations are evaluated by the same Java;");
    html.append(" processor time, median of ").append(SuiteRunner.REPEATS);
    html.append(" warm runs in turns (one run where it takes over ");
    html.append(format("%.0f", SuiteRunner.LONG)).append(" s).</p></section>");
  }

  private Set<String> solvers(boolean stiff) {
    Set<String> names = new LinkedHashSet<>();
    for (ProblemFile problem : ofKind(stiff)) {
      runs.stream()
          .filter(run -> run.problem().equals(problem.id))
          .forEach(r -> names.add(r.solver()));
    }
    return names;
  }

  private List<ProblemFile> ofKind(boolean stiff) {
    return problems.stream().filter(p -> p.isExplicit() && p.isStiff() == stiff).toList();
  }

  private String ratios(String solver, String own, boolean stiff, ToDoubleFunction<SuiteRun> cost) {
    double logs = 0;
    int count = 0;
    int wins = 0;
    for (ProblemFile problem : ofKind(stiff)) {
      OptionalDouble ratio = ratio(problem, solver, own, cost);
      if (ratio.isPresent()) {
        logs += Math.log(ratio.getAsDouble());
        wins += ratio.getAsDouble() > 1 ? 1 : 0;
        count++;
      }
    }
    return count == 0
        ? "<td class=\"none\">–<td class=\"none\">–"
        : format("<td>%.2f<td>%d of %d", Math.exp(logs / count), wins, count);
  }

  /** Mean over the errors both reach. */
  private OptionalDouble ratio(
      ProblemFile problem, String solver, String own, ToDoubleFunction<SuiteRun> cost) {
    double logs = 0;
    int count = 0;
    for (double level : LEVELS) {
      OptionalDouble theirs = cost(problem, solver, level, cost);
      OptionalDouble ours = cost(problem, own, level, cost);
      if (theirs.isPresent() && ours.isPresent()) {
        logs += Math.log(theirs.getAsDouble() / ours.getAsDouble());
        count++;
      }
    }
    return count == 0 ? OptionalDouble.empty() : OptionalDouble.of(Math.exp(logs / count));
  }

  /** Between two tolerances whose errors enclose the one wanted, in logarithms. */
  private OptionalDouble cost(
      ProblemFile problem, String solver, double level, ToDoubleFunction<SuiteRun> cost) {
    List<SuiteRun> mine = ofSolver(problem, solver);
    double least = Double.POSITIVE_INFINITY;
    for (int i = 1; i < mine.size(); i++) {
      SuiteRun worse = mine.get(i - 1);
      SuiteRun better = mine.get(i);
      boolean known = cost.applyAsDouble(worse) > 0 && cost.applyAsDouble(better) > 0;
      if (known && worse.error() > level && better.error() <= level && better.error() > 0) {
        least =
            Math.min(
                least,
                EqualError.between(
                    worse.error(),
                    cost.applyAsDouble(worse),
                    better.error(),
                    cost.applyAsDouble(better),
                    level));
      }
    }
    return Double.isInfinite(least) ? OptionalDouble.empty() : OptionalDouble.of(least);
  }

  private List<SuiteRun> ofSolver(ProblemFile problem, String solver) {
    return runs.stream()
        .filter(run -> run.problem().equals(problem.id) && run.solver().equals(solver))
        .filter(run -> run.cause().isEmpty())
        .toList();
  }

  private void problem(ProblemFile problem) {
    Set<String> names = new LinkedHashSet<>();
    runs.stream().filter(r -> r.problem().equals(problem.id)).forEach(r -> names.add(r.solver()));
    html.append("<details><summary>").append(problem.id).append(" – ");
    html.append(PageFrame.escaped(problem.title)).append(" (").append(problem.klass);
    html.append(")</summary>");
    SolverChart chart = new SolverChart("evaluations", "error at the end");
    for (String name : names) {
      List<SolverChart.Value> values = new ArrayList<>();
      for (SuiteRun run : ofSolver(problem, name)) {
        values.add(
            new SolverChart.Value(
                (double) run.evaluations(),
                Math.max(run.error(), 1e-17),
                format(
                    "%s, tolerance %.0e%nerror %.1e, %d evaluations, %d steps",
                    name, run.tolerance(), run.error(), run.evaluations(), run.steps())));
      }
      chart.add(name, values);
    }
    html.append(chart.html());
    failures(problem);
    html.append("</details>\n");
  }

  private void failures(ProblemFile problem) {
    List<SuiteRun> failed =
        runs.stream()
            .filter(run -> run.problem().equals(problem.id) && !run.cause().isEmpty())
            .toList();
    if (failed.isEmpty()) {
      return;
    }
    html.append("<table><tr><th>failed<th>tolerance<th>after evaluations<th>cause");
    for (SuiteRun run : failed) {
      html.append(
          format(
              "<tr><td>%s<td>%.0e<td>%d<td class=\"text\">%s",
              run.solver(), run.tolerance(), run.evaluations(), PageFrame.escaped(run.cause())));
    }
    html.append("</table>");
  }

  private static String format(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }
}
