package org.mechservice.benchmarks.suite;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.mechservice.report.measure.ReportProgress;

/**
 * Evaluations of ode15s and ode15sR over those of CVODE and IDA of SUNDIALS at equal errors, on the
 * stiff problems of the suite, on further ones, and on mechanisms with multipliers; differences for
 * all Jacobians, and counted.
 *
 * <p>Costs are interpolated, logarithm over logarithm, between tolerances half a decade apart to
 * errors of 1e-3 to 1e-8, of mechanisms from 1e-1 on; where errors do not fall with the tolerance,
 * the loosest tolerance that has the error counts.
 */
public final class EqualErrorRatios {
  private static final int FIRST_HALF = 6;
  private static final int LAST_HALF = 22;
  private static final int LAST_ERROR = 16;
  private static final int FIRST_ERROR_OF_MECHANISMS = 2;
  private static final double LIMIT = 60;

  /** Tolerances below this are not counted for digits, and errors may be so many times larger. */
  private static final double TIGHTEST_COUNTED = 0.9e-10;

  private static final double DIGITS_LEFT_OUT = 100;

  private static final List<String> OF_THE_SUITE =
      List.of(
          "robertson", "hires", "vdp1000", "bruss20", "stiffchain", "pend_i1", "crank_rigid_i1");

  private final ReportProgress progress;

  public EqualErrorRatios(ReportProgress progress) {
    this.progress = progress;
  }

  /**
   * Runs all and writes the page.
   *
   * @throws IOException if the page cannot be written
   */
  public Path write(Path folder) throws IOException {
    List<ProblemFile> known = new ArrayList<>();
    ProblemFile.all().stream().filter(one -> OF_THE_SUITE.contains(one.id)).forEach(known::add);
    known.addAll(ProblemFile.further());
    List<ProblemFile> problems = new ArrayList<>(known);
    problems.addAll(ProblemFile.unseen());
    problems.addAll(ProblemFile.fresh());
    problems.addAll(ProblemFile.flexible());
    problems.addAll(ProblemFile.heldOut());
    double[] tolerances =
        IntStream.rangeClosed(FIRST_HALF, LAST_HALF)
            .mapToDouble(half -> Math.pow(10, -0.5 * half))
            .toArray();
    PythonIntegrators peers =
        PythonIntegrators.of(
            problems, tolerances, LIMIT, PythonIntegrators.Which.STIFF_SUNDIALS, progress);
    Comparison onKnown = compare(known, peers, tolerances);
    Comparison onUnseen = compare(ProblemFile.unseen(), peers, tolerances);
    Comparison onFresh = compare(ProblemFile.fresh(), peers, tolerances);
    Comparison onFlexible = compare(ProblemFile.flexible(), peers, tolerances);
    Comparison onHeldOut = compare(ProblemFile.heldOut(), peers, tolerances);
    Files.createDirectories(folder);
    Path page = folder.resolve("equal-errors.md");
    String text = text(peers.version(), onKnown, onUnseen, onFresh, onFlexible, onHeldOut);
    Files.writeString(page, text, StandardCharsets.UTF_8);
    return page;
  }

  /**
   * The results of a set of problems.
   *
   * @param lines rows of the table
   * @param means of each problem by peer
   * @param digitsOfRuns share of ode15s' runs at 1e-3 to 1e-10 with the digits asked for but two
   */
  private record Comparison(
      List<String> lines, Map<String, List<Double>> means, double digitsOfRuns) {}

  private static Comparison compare(
      List<ProblemFile> problems, PythonIntegrators peers, double[] tolerances) {
    List<String> lines = new ArrayList<>();
    Map<String, List<Double>> means = new TreeMap<>();
    int counted = 0;
    int within = 0;
    for (ProblemFile problem : problems) {
      String ours = problem.algebraic.isEmpty() ? "ode15s" : "ode15sR";
      List<SuiteRun> own = SuiteRunner.runs(problem, ours, tolerances, LIMIT);
      for (SuiteRun run : own) {
        boolean counts = problem.algebraic.isEmpty() && run.tolerance() > TIGHTEST_COUNTED;
        counted += counts ? 1 : 0;
        within += counts && run.error() <= DIGITS_LEFT_OUT * run.tolerance() ? 1 : 0;
      }
      List<String> names =
          peers.runs().stream()
              .filter(run -> run.problem().equals(problem.id))
              .map(SuiteRun::solver)
              .distinct()
              .toList();
      for (String name : names) {
        List<SuiteRun> theirs =
            peers.runs().stream()
                .filter(run -> run.problem().equals(problem.id) && run.solver().equals(name))
                .toList();
        double[] ratios = ratios(own, theirs, problem.algebraic.isEmpty());
        if (ratios.length > 0) {
          double mean = geometricMean(ratios);
          means.computeIfAbsent(name, any -> new ArrayList<>()).add(mean);
          lines.add(line(problem, ours, name, mean, ratios));
        }
      }
    }
    return new Comparison(lines, means, (double) within / counted);
  }

  private static double[] ratios(List<SuiteRun> own, List<SuiteRun> theirs, boolean explicit) {
    return IntStream.rangeClosed(explicit ? FIRST_HALF : FIRST_ERROR_OF_MECHANISMS, LAST_ERROR)
        .mapToDouble(half -> Math.pow(10, -0.5 * half))
        .map(error -> cost(own, error) / cost(theirs, error))
        .filter(Double::isFinite)
        .toArray();
  }

  /** Returns the evaluations for an error, interpolated; NaN if no runs enclose it. */
  static double cost(List<SuiteRun> runs, double error) {
    List<SuiteRun> ended = runs.stream().filter(run -> run.error() > 0).toList();
    for (int i = 1; i < ended.size(); i++) {
      SuiteRun loose = ended.get(i - 1);
      SuiteRun tight = ended.get(i);
      if (loose.error() >= error && error >= tight.error()) {
        double part =
            loose.error() == tight.error()
                ? 1
                : Math.log(error / loose.error()) / Math.log(tight.error() / loose.error());
        double ratio = (double) tight.evaluations() / loose.evaluations();
        return loose.evaluations() * Math.pow(ratio, part);
      }
    }
    return Double.NaN;
  }

  private static double geometricMean(double[] values) {
    double sum = 0;
    for (double value : values) {
      sum += Math.log(value);
    }
    return Math.exp(sum / values.length);
  }

  private static String line(
      ProblemFile problem, String ours, String peer, double mean, double[] ratios) {
    double least = Double.POSITIVE_INFINITY;
    double most = 0;
    for (double ratio : ratios) {
      least = Math.min(least, ratio);
      most = Math.max(most, ratio);
    }
    return String.format(
        Locale.ROOT,
        "| %s | %d | %s | %s | %.2f | %.2f to %.2f | %d |",
        problem.title,
        problem.n,
        ours,
        peer.replace(";", ","),
        mean,
        least,
        most,
        ratios.length);
  }

  private static String text(
      String version,
      Comparison known,
      Comparison unseen,
      Comparison fresh,
      Comparison flexible,
      Comparison heldOut) {
    StringBuilder page = new StringBuilder();
    page.append("# ode15s and ode15sR beside CVODE and IDA\n\n");
    page.append("Evaluations over those of the peer at equal errors of the end, with differences");
    page.append(" for all Jacobians, counted for both; interpolated between tolerances half a");
    page.append(" decade apart to errors of 1e-3 to 1e-8, with multipliers from 1e-1 on. Below 1:");
    page.append(" ours needs fewer. Counts do not depend on the machine. Measured on ");
    page.append(LocalDate.now(ZoneOffset.UTC));
    page.append(" by [`MethodReports ratios`](../../benchmarks/README.md#pages-on-the-methods): ");
    page.append(System.getProperty("os.name")).append(' ').append(System.getProperty("os.arch"));
    page.append(", Java ").append(System.getProperty("java.version"));
    page.append(", ").append(version).append(".\n\n");
    page.append("## Problems on which parameters of the methods were chosen\n\n");
    append(page, known);
    page.append("\n## Further problems of the literature\n\n");
    page.append("No parameter of ode15s was chosen on them. How long ode15sR trusts a rate of");
    page.append(
        " convergence was judged on the car axis and the Chemical Akzo Nobel problem, too: ");
    page.append(link("unseen")).append(". Medical Akzo Nobel showed that its diffusion was taken");
    page.append(" for an oscillation (1.17 with that).\n\n");
    append(page, unseen);
    page.append("\n## Problems written later\n\n");
    page.append("Of STIFF DETEST, and a double pendulum: ");
    page.append(link("fresh")).append(".\n\n");
    append(page, fresh);
    page.append("\n## Mechanisms with flexible parts\n\n");
    page.append("Steps at the edge of stability were reconsidered on the first six: ");
    page.append(link("flexible")).append(".\n\n");
    append(page, flexible);
    page.append("\n## Held out\n\n");
    page.append(
        "Other measures and dampings, and other kinetics; nothing was tried on them before");
    page.append(" the end. The pendulum damped to 0.005 showed an error then, order 3 was never");
    page.append(" left, so that its figure of now is no held out one (2.6 with the error): ");
    page.append(link("heldout")).append(".\n\n");
    append(page, heldOut);
    page.append("\n## All\n\n| peer | problems | mean |\n|---|---|---|\n");
    Map<String, List<Double>> all = new TreeMap<>();
    for (Comparison one : List.of(known, unseen, fresh, flexible, heldOut)) {
      one.means.forEach(
          (peer, ratios) -> all.computeIfAbsent(peer, any -> new ArrayList<>()).addAll(ratios));
    }
    appendMeans(page, all);
    return page.toString();
  }

  private static String link(String file) {
    return String.format(
        "[`%s.json`](../../benchmarks/src/main/resources/org/mechservice/benchmarks/suite/%s.json)",
        file, file);
  }

  private static void append(StringBuilder page, Comparison set) {
    page.append("| problem | n | ours | peer | ratio | from, to | errors |\n");
    page.append("|---|---|---|---|---|---|---|\n");
    set.lines.forEach(line -> page.append(line).append('\n'));
    page.append("\n| peer | problems | mean |\n|---|---|---|\n");
    appendMeans(page, set.means);
    page.append(
        String.format(
            Locale.ROOT,
            "%n%.0f %% of the runs of ode15s at 1e-3 to 1e-10 have the digits asked for but two.%n",
            100 * set.digitsOfRuns));
  }

  private static void appendMeans(StringBuilder page, Map<String, List<Double>> means) {
    means.forEach(
        (peer, ratios) ->
            page.append(
                String.format(
                    Locale.ROOT,
                    "| %s | %d | %.2f |%n",
                    peer.replace(";", ","),
                    ratios.size(),
                    geometricMean(ratios.stream().mapToDouble(Double::doubleValue).toArray()))));
  }
}
