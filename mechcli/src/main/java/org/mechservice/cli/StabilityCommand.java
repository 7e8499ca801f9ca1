package org.mechservice.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.mechservice.report.stability.CaseOutcome;
import org.mechservice.report.stability.StabilityReport;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code mech stability}: the suite of stiff and extreme scenes. */
@Command(
    name = "stability",
    description = "Runs the suite of stiff and extreme scenes with every method that fits.",
    mixinStandardHelpOptions = true,
    versionProvider = Mech.Version.class)
final class StabilityCommand implements Callable<Integer> {
  @Option(
      names = {"-o", "--output"},
      required = true,
      paramLabel = "DIR",
      description = "Folder for the page.")
  private Path folder = Path.of("");

  @Option(
      names = "--limit",
      paramLabel = "SECONDS",
      description = "Stop a run after this time; 5 s unless given.")
  private double limitSeconds = 5;

  @Mixin private ServerOption server = new ServerOption();

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException {
    Path page = folder.resolve("stability.html");
    List<CaseOutcome> outcomes;
    try (Service service = Service.open(server);
        ProgressLine line = new ProgressLine(spec.commandLine().getErr())) {
      outcomes =
          new StabilityReport(service.connection()::openSession, limitSeconds, line).write(page);
    }
    long good = outcomes.stream().filter(CaseOutcome::asExpected).count();
    spec.commandLine()
        .getOut()
        .println(page + ": " + good + " of " + outcomes.size() + " cases end as expected");
    return good == outcomes.size() ? ExitStatus.DONE : ExitStatus.SIMULATION_FAILED;
  }
}
