package org.mechservice.solver.ode;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.adams.De;
import org.mechservice.solver.ode.adams.Ode113;
import org.mechservice.solver.ode.stiff.Ode15s;
import org.mechservice.solver.ode.suite.ResidualProblem;
import org.mechservice.solver.ode.suite.ResidualRun;
import org.mechservice.solver.ode.suite.Run;
import org.mechservice.solver.ode.suite.StiffnessDraw;
import org.mechservice.solver.ode.suite.StiffnessFamily;
import org.mechservice.solver.ode.suite.SuiteProblem;
import org.mechservice.solver.ode.switching.Switching;

/** Writes docs/reports/integrators.md: what the integrators cost and deliver on their suite. */
@Tag("soak")
class IntegratorReportTest {
  private static final Path PAGE = Path.of("..", "..", "docs", "reports", "integrators.md");

  /** What the page says of each target; kept by hand, with the tests that prove it. */
  private static final Path STANDING =
      Path.of("src", "test", "resources", "org", "mechservice", "solver", "ode")
          .resolve("targets.md");

  private static final int LEAST_DIGITS = 3;
  private static final int MOST_DIGITS = 10;

  /** Problems drawn of each group. */
  private static final int DRAWS = 40;

  private static final int LATER_DRAWS = 120;
  private static final long LATER_SEED = 20261127;

  /**
   * Steps/rejected/evaluations, then Jacobians and factorisations, at 1e-3, 1e-6 and 1e-9, of
   * independent programs written from the published descriptions.
   */
  private static final String[][] COUNTS = {
    {"ode113", "EulerRigidBody", "67/0/135", "168/0/337", "282/0/565"},
    {"ode113", "VanDerPol", "143/9/296", "329/7/666", "584/6/1175"},
    {"ode113", "Kepler", "244/23/512", "521/23/1066", "927/22/1877"},
    {"ode113", "Arenstorf", "147/7/302", "370/18/759", "668/13/1350"},
    {"ode113", "Pleiades", "227/18/473", "523/22/1069", "906/22/1835"},
    {"ode113", "DetestA3", "75/3/154", "144/2/291", "239/0/479"},
    {"ode113", "SixLinkChain", "127/7/262", "284/5/574", "547/8/1103"},
    {"ode15s", "EulerRigidBody", "87/5/180/1/19", "274/5/438/1/28", "815/5/931/1/49"},
    {"ode15s", "Kepler", "368/77/749/3/134", "852/72/1220/2/158", "2514/76/3049/2/294"},
    {"ode15s", "Pleiades", "287/50/570/1/89", "911/65/1167/1/144", "2771/75/3162/1/273"},
    {"ode15s", "Robertson", "310/15/667/10/77", "872/18/1607/10/151", "2226/20/4053/10/334"},
    {"ode15s", "Hires", "118/20/375/11/44", "359/24/818/8/74", "1066/58/2309/6/182"},
    {
      "ode15s",
      "StiffVanDerPol",
      "408/149/1266/30/197",
      "1355/159/3115/16/237",
      "3995/240/7546/14/483"
    },
    {"ode15s", "Brusselator", "72/8/242/2/21", "225/8/456/1/36", "646/12/1035/1/77"},
    {"ode15s", "StiffChain", "364/33/533/1/89", "766/7/1554/1/63", "2387/16/3985/1/126"}
  };

  private final StringBuilder page = new StringBuilder();

  @Test
  void reportIsWritten() throws IOException {
    line("# The integrators on their suite");
    line("");
    line(
        "Measured on %s by `mvn verify -Psoak`: %s %s, Java %s. Counts and digits are the same on"
            + " every machine; time per step is measured by the"
            + " [benchmarks](../../benchmarks/README.md).",
        LocalDate.now(ZoneId.systemDefault()),
        System.getProperty("os.name"),
        System.getProperty("os.arch"),
        System.getProperty("java.version"));
    counts();
    shares();
    stiffness();
    switching();
    changesOnFamilies();
    changesOnDraws();
    standing();
    Files.writeString(PAGE, page);
    assertThat(PAGE).exists();
  }

  private void line(String format, Object... values) {
    page.append(values.length == 0 ? format : String.format(Locale.ROOT, format, values))
        .append('\n');
  }

  private static IntegratorFactory named(String name, Mode mode) {
    return switch (name) {
      case "ode113" -> settings -> new Ode113(settings.withMode(mode));
      case "DE" -> settings -> new De(settings.withMode(mode));
      default -> settings -> new Ode15s(settings.withMode(mode));
    };
  }

  private static IntegrationStatistics run(
      IntegratorFactory integrators, SuiteProblem problem, int digits) {
    Run run =
        Run.of(integrators.create(Run.settings(problem, StrictMath.pow(10, -digits))), problem);
    return run.statistics();
  }

  /** Counts in the faithful mode beside those of independent programs. */
  private void counts() {
    line("");
    line("## Counts");
    line("");
    line(
        "Steps/rejected/evaluations, for ode15s also Jacobians/factorisations, in the faithful"
            + " mode; in brackets those of independent programs written from the published"
            + " descriptions.");
    line("");
    line("| integrator | problem | 1e-3 | 1e-6 | 1e-9 |");
    line("|---|---|---|---|---|");
    for (String[] row : COUNTS) {
      List<String> cells = new ArrayList<>();
      for (int i = 0; i < 3; i++) {
        IntegratorFactory integrators = named(row[0], Mode.FAITHFUL);
        IntegrationStatistics done = run(integrators, SuiteProblem.named(row[1]), 3 + 3 * i);
        cells.add(counted(done) + " (" + row[2 + i] + ")");
      }
      line("| %s | %s | %s |", row[0], row[1], String.join(" | ", cells));
    }
  }

  private static String counted(IntegrationStatistics done) {
    String explicit = done.steps() + "/" + done.rejectedSteps() + "/" + done.evaluations();
    return done.factorisations() == 0
        ? explicit
        : explicit + "/" + done.jacobians() + "/" + done.factorisations();
  }

  /** Shares of runs that deliver the digits asked for, less some. */
  private void shares() {
    line("");
    line("## Digits");
    line("");
    line(
        "Share of the runs at 1e-3 to 1e-10 whose result has the digits asked for less 3, 2 and 1."
            + " Targets: not stiff 87 and 52 %, stiff 96 and 90 %, differential-algebraic 85 and"
            + " 55 %; in the strict mode, less 1, 70 % not stiff and 80 % stiff.");
    line("");
    line("| integrator | mode | problems | less 3 | less 2 | less 1 | evaluations |");
    line("|---|---|---|---|---|---|---|");
    for (Mode mode : List.of(Mode.FAITHFUL, Mode.STANDARD, Mode.STRICT)) {
      share("ode113", mode, "not stiff", SuiteProblem.nonstiff());
      share("DE", mode, "not stiff", SuiteProblem.nonstiff());
    }
    for (Mode mode : Mode.values()) {
      share("ode15s", mode, "stiff", SuiteProblem.stiff());
      share("ode15s", mode, "not stiff", SuiteProblem.nonstiff());
    }
    shareOfResiduals();
  }

  private void share(String name, Mode mode, String kind, List<SuiteProblem> problems) {
    int[] within = new int[4];
    long evaluations = 0;
    for (SuiteProblem problem : problems) {
      for (int k = LEAST_DIGITS; k <= MOST_DIGITS; k++) {
        IntegratorSettings settings = Run.settings(problem, StrictMath.pow(10, -k));
        Run run = Run.of(named(name, mode).create(settings), problem);
        assertThat(run.result()).as(problem.name()).isEqualTo(StepResult.REACHED_END);
        evaluations += run.statistics().evaluations();
        count(within, problem.reference().mixedDigits(run.atEnd(), problem.reference().atEnd()), k);
      }
    }
    row(name, mode, kind, within, problems.size(), evaluations);
  }

  private void shareOfResiduals() {
    int[] within = new int[4];
    long evaluations = 0;
    for (ResidualProblem problem : ResidualProblem.all()) {
      for (int k = LEAST_DIGITS; k <= MOST_DIGITS; k++) {
        ResidualRun run = ResidualRun.of(problem, StrictMath.pow(10, -k));
        evaluations += run.statistics().evaluations();
        count(within, run.digits(), k);
      }
    }
    int problems = ResidualProblem.all().size();
    row("ode15sR", Mode.STANDARD, "residual form", within, problems, evaluations);
  }

  private static void count(int[] within, double digits, int asked) {
    for (int less = 1; less <= 3; less++) {
      within[less] += digits >= asked - less ? 1 : 0;
    }
  }

  private void row(
      String name, Mode mode, String kind, int[] within, int problems, long evaluations) {
    double runs = (MOST_DIGITS - LEAST_DIGITS + 1) * problems / 100.0;
    line(
        "| %s | %s | %s | %.0f %% | %.0f %% | %.0f %% | %d |",
        name,
        mode.name().toLowerCase(Locale.ROOT),
        kind,
        within[3] / runs,
        within[2] / runs,
        within[1] / runs,
        evaluations);
  }

  /** Whether ode113 says of itself that a problem is stiff. */
  private void stiffness() {
    line("");
    line("## Stiffness");
    line("");
    line(
        "Digits at which ode113 suspects stiffness within 20000 steps, of 3 to 9; target: nearly"
            + " all stiff ones, none of the others.");
    line("");
    line("| problem | stiff | suspected at |");
    line("|---|---|---|");
    SuiteProblem.stiff().forEach(problem -> suspicion(problem, "yes"));
    SuiteProblem.nonstiff().forEach(problem -> suspicion(problem, "no"));
  }

  private static IntegratorSettings bounded(IntegratorSettings settings) {
    return bounded(settings, 20_000);
  }

  private static IntegratorSettings bounded(IntegratorSettings settings, long steps) {
    return new IntegratorSettings(
        settings.relativeTolerance(),
        settings.absoluteTolerance(),
        Double.POSITIVE_INFINITY,
        0,
        0,
        steps,
        () -> false);
  }

  private void suspicion(SuiteProblem problem, String stiff) {
    List<Integer> suspected = new ArrayList<>();
    for (int k = LEAST_DIGITS; k <= 9; k++) {
      IntegratorSettings settings = Run.settings(problem, StrictMath.pow(10, -k));
      if (Run.of(new Ode113(bounded(settings)), problem).statistics().stiffnessSuspected()) {
        suspected.add(k);
      }
    }
    line("| %s | %s | %s |", problem.name(), stiff, suspected);
  }

  /** What the change between methods costs beside each method alone. */
  private void switching() {
    line("");
    line("## Changing the method");
    line("");
    line(
        "Evaluations with ode113 (none beyond 20000 steps), ode15s and the change between them, how"
            + " often it changed, and its cost over that of the better one; target: 1.3. Problems"
            + " that are not stiff cost what ode113 costs, to the bit.");
    line("");
    line("| problem | at | ode113 | ode15s | changing | changes | ratio |");
    line("|---|---|---|---|---|---|---|");
    List<Double> ratios = new ArrayList<>();
    for (SuiteProblem problem : SuiteProblem.stiff()) {
      for (int k = LEAST_DIGITS; k <= MOST_DIGITS; k++) {
        ratios.add(ratio(problem, k));
      }
    }
    for (SuiteProblem problem : SuiteProblem.nonstiff()) {
      for (int k = LEAST_DIGITS; k <= MOST_DIGITS; k++) {
        Run run = Run.of(new Switching(Run.settings(problem, StrictMath.pow(10, -k))), problem);
        assertThat(run.integrator().methodChangeCount()).as(problem.name()).isZero();
        ratios.add(1.0);
      }
    }
    ratios.sort(null);
    line("");
    line(
        "All problems of the suite, %d runs: median %.2f, 90 of 100 at most %.2f, worst %.2f."
            + " Finding out takes some 60 evaluations, which short runs feel.",
        ratios.size(),
        ratios.get(ratios.size() / 2),
        ratios.get(ratios.size() * 9 / 10),
        ratios.get(ratios.size() - 1));
  }

  /** The change between methods on families of problems that are more or less stiff. */
  private void changesOnFamilies() {
    line("");
    line("### Families of problems more or less stiff");
    line("");
    line(
        "Fixed problems (`StiffnessFamily`) at 1e-3 to 1e-8, absolute alike: evaluations of the"
            + " change over those of the better of ode113 and ode15s. Long runs are those of which"
            + " the better method takes 200 evaluations and more.");
    line("");
    head();
    List<double[]> all = new ArrayList<>();
    for (StiffnessFamily family : StiffnessFamily.all()) {
      List<double[]> runs = new ArrayList<>();
      for (StiffnessFamily.Member member : family.members()) {
        for (int k = LEAST_DIGITS; k <= 8; k++) {
          double tolerance = StrictMath.pow(10, -k);
          IntegratorSettings settings = new IntegratorSettings(tolerance, tolerance);
          runs.add(betterAndRatio(member.ode(), member.start(), member.end(), settings));
        }
      }
      row(family.name(), runs);
      all.addAll(runs);
    }
    row("all", all);
    assertThat(all.stream().filter(run -> run[1] <= 1.3).count())
        .isGreaterThanOrEqualTo((long) (0.95 * all.size()));
    assertThat(all).allMatch(run -> run[1] <= 3);
  }

  private void head() {
    line("| group | runs | at most 1.3 | median | worst | long runs | at most 1.3 | worst |");
    line("|---|---|---|---|---|---|---|---|");
  }

  /** The same on problems drawn at random. */
  private void changesOnDraws() {
    line("");
    line("### Problems drawn at random");
    line("");
    line(
        "`StiffnessDraw`, %d of each group, seed %d, tolerances drawn from 1e-8 to 1e-3. By two"
            + " thirds of each group the rules of the change were chosen; of the last third alone the"
            + " price of an evaluation.",
        DRAWS, StiffnessDraw.SEED);
    List<StiffnessDraw> drawn = StiffnessDraw.all(DRAWS);
    draws("Looked at:", drawn.stream().filter(draw -> !draw.heldOut()).toList());
    draws("Held out:", drawn.stream().filter(StiffnessDraw::heldOut).toList());
    String later =
        String.format(
            Locale.ROOT,
            "Drawn when nothing was chosen any more, %d of each group, seed %d:",
            LATER_DRAWS,
            LATER_SEED);
    draws(later, StiffnessDraw.all(LATER_DRAWS, LATER_SEED));
  }

  private void draws(String title, List<StiffnessDraw> drawn) {
    line("");
    line(title);
    line("");
    head();
    Map<String, List<double[]>> groups = new LinkedHashMap<>();
    List<double[]> all = new ArrayList<>();
    for (StiffnessDraw draw : drawn) {
      double tolerance = draw.tolerance();
      IntegratorSettings settings = new IntegratorSettings(tolerance, tolerance * draw.small());
      double[] run = betterAndRatio(draw.ode(), draw.start(), draw.end(), settings);
      groups.computeIfAbsent(draw.group(), name -> new ArrayList<>()).add(run);
      all.add(run);
    }
    groups.forEach(this::row);
    row("all", all);
  }

  private static double[] betterAndRatio(
      OdeSystem ode, double[] start, double end, IntegratorSettings settings) {
    Run explicit = Run.of(new Ode113(bounded(settings, 200_000)), ode, 0, start, end);
    Run implicit = Run.of(new Ode15s(settings), ode, 0, start, end);
    Run changing = Run.of(new Switching(settings), ode, 0, start, end);
    assertThat(implicit.result()).isEqualTo(StepResult.REACHED_END);
    assertThat(changing.result()).isEqualTo(StepResult.REACHED_END);
    long better = implicit.statistics().evaluations();
    if (explicit.result() == StepResult.REACHED_END) {
      better = Math.min(better, explicit.statistics().evaluations());
    }
    return new double[] {better, (double) changing.statistics().evaluations() / better};
  }

  private void row(String name, List<double[]> runs) {
    double[] ratios = runs.stream().mapToDouble(run -> run[1]).sorted().toArray();
    double[] longRuns =
        runs.stream().filter(run -> run[0] >= 200).mapToDouble(run -> run[1]).sorted().toArray();
    line(
        "| %s | %d | %d | %.2f | %.2f | %d | %d | %s |",
        name,
        ratios.length,
        Arrays.stream(ratios).filter(ratio -> ratio <= 1.3).count(),
        ratios[ratios.length / 2],
        ratios[ratios.length - 1],
        longRuns.length,
        Arrays.stream(longRuns).filter(ratio -> ratio <= 1.3).count(),
        longRuns.length == 0
            ? "-"
            : String.format(Locale.ROOT, "%.2f", longRuns[longRuns.length - 1]));
  }

  private double ratio(SuiteProblem problem, int digits) {
    IntegratorSettings settings = Run.settings(problem, StrictMath.pow(10, -digits));
    Run explicit = Run.of(new Ode113(bounded(settings)), problem);
    boolean ended = explicit.result() == StepResult.REACHED_END;
    long adams = ended ? explicit.statistics().evaluations() : Long.MAX_VALUE;
    long backward = Run.of(new Ode15s(settings), problem).statistics().evaluations();
    Run changing = Run.of(new Switching(settings), problem);
    double ratio = (double) changing.statistics().evaluations() / Math.min(adams, backward);
    if (digits % 3 == 0) {
      line(
          "| %s | 1e-%d | %s | %d | %d | %d | %.2f |",
          problem.name(),
          digits,
          ended ? "" + adams : "-",
          backward,
          changing.statistics().evaluations(),
          changing.integrator().methodChangeCount(),
          ratio);
    }
    return ratio;
  }

  /** Each target with what was reached; figures that are not measured above have their source. */
  private void standing() throws IOException {
    line("");
    page.append(Files.readString(STANDING));
  }
}
