package org.mechservice.cli.model;

import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.ServerOption;
import org.mechservice.cli.shell.ServiceConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.failure.InvalidModelException;
import org.mechservice.sim.check.CheckReport;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech check}: topology, degrees of freedom and warnings of a model. */
@Command(
    name = "check",
    description = "Reads a model and prints its topology, degrees of freedom and doubtful values.",
    footer = "mech check model.xml",
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class CheckCommand implements Callable<Integer> {
  @Parameters(paramLabel = "MODEL.xml", description = "Model in MechML.")
  private Path model = Path.of("");

  @Mixin private ServerOption server = new ServerOption();

  @Mixin private UserCodeOption userCode = new UserCodeOption();

  @Mixin private SilenceOption silence = new SilenceOption();

  @Option(
      names = "--strict",
      description = "Take warnings for errors: exit status 2 if there are any.")
  private boolean strict;

  @Option(names = "--json", description = "Print one JSON object.")
  private boolean json;

  @Option(
      names = "--sarif",
      paramLabel = "FILE.sarif",
      description = "Write the messages in SARIF, for code hosts and editors.")
  private Optional<Path> sarif = Optional.empty();

  @Option(
      names = "--junit",
      paramLabel = "FILE.xml",
      description =
          "Write the messages as test cases in the XML of JUnit; with --strict warnings fail.")
  private Optional<Path> junit = Optional.empty();

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException {
    try (ServiceConnection service = ServiceConnection.open(server, userCode.consent());
        MechSession session = service.connection().openSession()) {
      try {
        session.loadModel(model, userCode.consent());
      } catch (InvalidModelException e) {
        write(CheckFindings.of(model, e));
        throw e;
      }
      SimulationOptions options = silence.addTo(SimulationOptions.asInFile());
      String report = session.checkReport(options, json);
      if (sarif.isPresent() || junit.isPresent()) {
        write(CheckFindings.of(model, json ? report : session.checkReport(options, true)));
      }
      spec.commandLine().getOut().println(report.stripTrailing());
      if (isUnusable(report)) {
        return ExitStatus.BAD_INPUT;
      }
      if (!strict) {
        return ExitStatus.DONE;
      }
      return judged(json ? report : session.checkReport(options, true));
    }
  }

  private void write(CheckFindings findings) throws IOException {
    if (sarif.isPresent()) {
      findings.writeSarif(sarif.get());
    }
    if (junit.isPresent()) {
      findings.writeJUnit(junit.get(), strict);
    }
  }

  /** Returns whether a report says that no run of the model can begin. */
  private boolean isUnusable(String report) {
    return json
        ? JsonParser.parseString(report).getAsJsonObject().has("unusable")
        : report.lines().anyMatch((CheckReport.UNUSABLE + ":")::equals);
  }

  /**
   * @param report as JSON
   */
  private int judged(String report) {
    int warnings =
        JsonParser.parseString(report).getAsJsonObject().getAsJsonArray("warnings").size();
    if (warnings == 0) {
      return ExitStatus.DONE;
    }
    spec.commandLine().getOut().flush();
    spec.commandLine()
        .getErr()
        .println(
            MessageCode.WARNINGS_REFUSED
                + " the model has "
                + (warnings == 1 ? "1 warning" : warnings + " warnings")
                + ", and --strict was given");
    return ExitStatus.BAD_INPUT;
  }
}
