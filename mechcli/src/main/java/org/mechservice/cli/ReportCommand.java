package org.mechservice.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.mechservice.client.MechSession;
import org.mechservice.report.ModelReport;
import org.mechservice.report.measure.Effort;
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
    mixinStandardHelpOptions = true,
    versionProvider = Mech.Version.class)
final class ReportCommand implements Callable<Integer> {
  @Parameters(paramLabel = "MODEL.xml", arity = "1..*", description = "Models in MechML.")
  private List<Path> models = List.of();

  @Option(
      names = {"-o", "--output"},
      required = true,
      paramLabel = "DIR",
      description = "Folder for the pages; a report that was interrupted is taken up again there.")
  private Path folder = Path.of("");

  @Option(
      names = "--quick",
      description = "Fewer tolerances and shorter limits: under a minute per model.")
  private boolean quick;

  @Mixin private ServerOption server = new ServerOption();

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException, InterruptedException {
    Effort effort = quick ? Effort.QUICK : Effort.FULL;
    PrintWriter err = spec.commandLine().getErr();
    try (Service service = Service.open(server)) {
      for (Path model : models) {
        try (MechSession session = service.connection().openSession();
            ProgressLine line = new ProgressLine(err)) {
          session.loadModel(model).forEach(err::println);
          Path page = new ModelReport(session, folder, effort, line).write(model);
          line.close();
          spec.commandLine().getOut().println(page);
        }
      }
    }
    return ExitStatus.DONE;
  }
}
