package org.mechservice.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.mechservice.report.stability.CaseOutcome;
import org.mechservice.report.stability.ExtremeCase;
import org.mechservice.report.stability.StabilityReport;
import org.mechservice.report.stability.TimeBudget;
import org.mechservice.report.stability.study.Bench;
import org.mechservice.report.stability.study.Study;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code mech stability}: the suite of stiff and extreme scenes. */
@Command(
    name = "stability",
    description = {
      "Runs the suite of stiff and extreme scenes with every method that fits, or measures a"
          + " property of the integrators and formulations. Models of your own: mech report."
    },
    mixinStandardHelpOptions = true,
    versionProvider = Mech.Version.class)
final class StabilityCommand implements Callable<Integer> {
  private static final String ALL = "all";

  @Option(
      names = {"-o", "--output"},
      required = true,
      paramLabel = "DIR",
      description = "Folder for the pages.")
  private Path folder = Path.of("");

  @Option(
      names = "--limit",
      paramLabel = "SECONDS",
      description = "Stop a run after this time; 5 s unless given.")
  private double limitSeconds = 5;

  @Option(
      names = "--budget",
      paramLabel = "SECONDS",
      description =
          "Stop runs sooner, so that all take no longer than this; no bound unless given.")
  private double budgetSeconds = Double.POSITIVE_INFINITY;

  @Option(
      names = "--case",
      paramLabel = "NAME",
      description = "Run this case of the suite only, such as chain_1000; may be repeated.")
  private List<String> cases = List.of();

  @Option(
      names = "--measure",
      paramLabel = "STUDY",
      description = {
        "Measure a property instead, one page each with its figures as CSV: growth, periods, noise,"
            + " damping, singular, start, condition, newton, auto, service; or all."
      })
  private Optional<String> study = Optional.empty();

  @Option(
      names = "--quick",
      description = "With --measure: shorter runs and fewer points, under a minute each.")
  private boolean quick;

  @Mixin private ServerOption server = new ServerOption();

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException {
    requirePositive("--limit", limitSeconds);
    requirePositive("--budget", budgetSeconds);
    return study.isPresent() ? measure(study.get()) : suite();
  }

  private static void requirePositive(String option, double seconds) {
    if (!(seconds > 0)) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " "
              + option
              + " is "
              + seconds
              + "; it is a time in seconds, more than 0");
    }
  }

  private int measure(String wanted) throws IOException {
    try (Service service = Service.open(server);
        ProgressLine line = new ProgressLine(spec.commandLine().getErr())) {
      Bench bench = new Bench(service.connection()::openSession, quick, wantedCases(), line);
      List<Study> studies =
          Study.all(bench).stream()
              .filter(one -> wanted.equals(ALL) || wanted.equals(one.name()))
              .toList();
      if (studies.isEmpty()) {
        String known = String.join(", ", Study.all(bench).stream().map(Study::name).toList());
        throw new UsageException(
            MessageCode.OPTION_UNUSABLE
                + " --measure is \""
                + wanted
                + "\"; there are "
                + known
                + " and "
                + ALL);
      }
      for (Study one : studies) {
        spec.commandLine().getOut().println(one.write(folder, bench));
        spec.commandLine().getOut().flush();
      }
    }
    return ExitStatus.DONE;
  }

  private List<ExtremeCase> wantedCases() {
    List<ExtremeCase> suite = ExtremeCase.suite();
    for (String name : cases) {
      if (suite.stream().noneMatch(one -> one.name().equals(name))) {
        String known = String.join(", ", suite.stream().map(ExtremeCase::name).toList());
        throw new UsageException(
            MessageCode.OPTION_UNUSABLE + " --case is \"" + name + "\"; there are " + known);
      }
    }
    return suite.stream().filter(one -> cases.isEmpty() || cases.contains(one.name())).toList();
  }

  private int suite() throws IOException {
    Path page = folder.resolve("stability.html");
    List<CaseOutcome> outcomes;
    try (Service service = Service.open(server);
        ProgressLine line = new ProgressLine(spec.commandLine().getErr())) {
      outcomes =
          new StabilityReport(
                  service.connection()::openSession,
                  new TimeBudget(limitSeconds, budgetSeconds),
                  line)
              .write(page, wantedCases());
    }
    long good = outcomes.stream().filter(CaseOutcome::asExpected).count();
    spec.commandLine()
        .getOut()
        .println(page + ": " + good + " of " + outcomes.size() + " cases end as expected");
    return good == outcomes.size() ? ExitStatus.DONE : ExitStatus.SIMULATION_FAILED;
  }
}
