package org.mechservice.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.ServerOption;
import org.mechservice.cli.shell.ServiceConnection;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SessionBuilds;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.report.ProgressLine;
import org.mechservice.report.method.BuildRefusedException;
import org.mechservice.report.method.MethodList;
import org.mechservice.report.stability.CaseOutcome;
import org.mechservice.report.stability.ExtremeCase;
import org.mechservice.report.stability.StabilityReport;
import org.mechservice.report.stability.SuiteBuilds;
import org.mechservice.report.stability.SuiteTimeBudget;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code mech stability}: the suite of stiff and extreme scenes. */
@Command(
    name = "stability",
    description =
        "Runs the suite of stiff and extreme scenes with every method that fits. Models of your"
            + " own: mech report.",
    footer = "mech stability -o pages --case chain_1000",
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
final class StabilityCommand implements Callable<Integer> {
  @Option(
      names = {"-o", "--output", "--out"},
      required = true,
      paramLabel = "DIR",
      description = "Folder for the pages.")
  private Path folder = Path.of("");

  @Option(
      names = "--limit",
      paramLabel = "SECONDS",
      description = "Stop a run after this time, s (default: 5).")
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
      description = "Run this case of the suite, such as chain_1000; may be repeated.")
  private List<String> cases = List.of();

  @Mixin private ServerOption server = new ServerOption();

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException {
    requirePositive("--limit", limitSeconds);
    requirePositive("--budget", budgetSeconds);
    return suite();
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

  private static SuiteBuilds.Built built(MechConnection service, ExtremeCase wanted)
      throws BuildRefusedException {
    try (MechSession session = service.openSession()) {
      List<String> warnings =
          session.loadModel(wanted.file(), wanted.content()).stream()
              .map(ModelMessage::toString)
              .toList();
      return new SuiteBuilds.Built(MethodList.of(new SessionBuilds(session)), warnings);
    } catch (ServiceException e) {
      throw new BuildRefusedException(e);
    }
  }

  private int suite() throws IOException {
    Path page = folder.resolve("stability.html");
    List<CaseOutcome> outcomes;
    try (ServiceConnection service = ServiceConnection.open(server);
        ProgressLine line = new ProgressLine(spec.commandLine().getErr())) {
      outcomes =
          new StabilityReport(
                  wanted -> built(service.connection(), wanted),
                  new SuiteTimeBudget(limitSeconds, budgetSeconds),
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
