package org.mechservice.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.mechservice.cli.model.UserCodeOption;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.ServerOption;
import org.mechservice.cli.shell.ServiceConnection;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.client.MechSession;
import org.mechservice.client.SessionBuilds;
import org.mechservice.guard.Confinement;
import org.mechservice.report.ModelReport;
import org.mechservice.report.ProgressLine;
import org.mechservice.report.measure.Effort;
import org.mechservice.report.measure.MeasurementFile;
import org.mechservice.report.measure.Rerun;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech report}: error against run time of models, one page each. */
@Command(
    name = "report",
    description = "Measures error against run time of every method that fits a model.",
    footer = "mech report model.xml -o pages --quick",
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
final class ReportCommand implements Callable<Integer> {
  @Parameters(paramLabel = "MODEL.xml", arity = "0..*", description = "Models in MechML.")
  private List<Path> models = List.of();

  @Option(
      names = {"-o", "--output", "--out"},
      paramLabel = "DIR",
      description = "Folder for the pages; a report that was interrupted is taken up again there.")
  private Optional<Path> output = Optional.empty();

  @Option(
      names = "--quick",
      description =
          "Fewer tolerances and shorter limits: about a minute per model, three at most for a large"
              + " mechanism.")
  private boolean quick;

  @Option(
      names = "--budget",
      paramLabel = "SECONDS",
      description =
          "Time for the report of a model; what it does not allow is left out and named on the"
              + " page. Default: 900, with --quick 180.")
  private Optional<Double> budget = Optional.empty();

  @Option(
      names = "--compare",
      arity = "2",
      paramLabel = "RUNS.csv",
      description = "Compare the runs of two reports of one scene: is the second within noise?")
  private List<Path> compared = List.of();

  @Mixin private UserCodeOption userCode = new UserCodeOption();

  @Mixin private ServerOption server = new ServerOption();

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException, InterruptedException {
    if (!compared.isEmpty()) {
      return compare();
    }
    if (budget.isPresent() && !(budget.get() > 0)) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " --budget "
              + budget.get()
              + ": the time for a report is a positive number of seconds");
    }
    if (models.isEmpty()) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE + " report: name a model, or --compare with two files");
    }
    Path folder =
        output.orElseThrow(
            () ->
                new UsageException(
                    MessageCode.OPTION_UNUSABLE
                        + " report: name the folder for the pages, -o DIR"));
    reportModels(folder);
    return ExitStatus.DONE;
  }

  private int compare() throws IOException {
    for (Path runs : compared) {
      if (MeasurementFile.read(runs).isEmpty()) {
        throw new UsageException(
            MessageCode.OPTION_UNUSABLE + " --compare: " + runs + " has no runs of a report");
      }
    }
    Rerun rerun = Rerun.of(compared.get(0), compared.get(1));
    rerun.lines().forEach(spec.commandLine().getOut()::println);
    spec.commandLine().getOut().flush();
    return rerun.agrees() ? ExitStatus.DONE : ExitStatus.SIMULATION_FAILED;
  }

  private void reportModels(Path folder) throws IOException, InterruptedException {
    userCode
        .consent()
        .warning(Confinement.ofThisMachine())
        .ifPresent(
            why ->
                spec.commandLine().getErr().println(MessageCode.USER_CODE_UNCONFINED + " " + why));
    try (ServiceConnection service = ServiceConnection.open(server, userCode.consent())) {
      for (Path model : models) {
        report(service, model, folder);
      }
    }
  }

  private void report(ServiceConnection service, Path model, Path folder)
      throws IOException, InterruptedException {
    PrintWriter err = spec.commandLine().getErr();
    Effort usual = quick ? Effort.QUICK : Effort.FULL;
    Effort effort = budget.map(usual::withBudget).orElse(usual);
    try (MechSession session = service.connection().openSession();
        ProgressLine line = new ProgressLine(err)) {
      session.loadModel(model, userCode.consent()).forEach(err::println);
      print(new ModelReport(new SessionBuilds(session), folder, effort, line).write(model));
    }
  }

  private void print(Path page) {
    spec.commandLine().getOut().println(page);
    spec.commandLine().getOut().flush();
  }
}
