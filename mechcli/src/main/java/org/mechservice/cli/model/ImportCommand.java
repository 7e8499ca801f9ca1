package org.mechservice.cli.model;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.cli.shell.ServerOption;
import org.mechservice.cli.shell.ServiceConnection;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.client.ImportedModel;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech import}: a model of another format becomes MechML. */
@Command(
    name = "import",
    description = "Translates a robot from URDF, SDF or MJCF to MechML and lists what is lost.",
    footer = "mech import arm.urdf -o arm.xml",
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class ImportCommand implements Callable<Integer> {
  @Parameters(
      paramLabel = "ROBOT.urdf|.sdf|.mjcf",
      description = "The robot; MJCF may also end in .xml.")
  private Path robot = Path.of("");

  @Option(
      names = {"-o", "--output"},
      required = true,
      paramLabel = "MODEL.xml",
      description = "The model file to write.")
  private Path target = Path.of("");

  @Option(names = "--strict", description = "Write nothing if anything is lost.")
  private boolean strict;

  @Mixin private ServerOption server = new ServerOption();

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException {
    OutputFile.requireUsable(target);
    try (ServiceConnection service = ServiceConnection.open(server)) {
      ImportedModel imported = service.connection().importModel(robot);
      PrintWriter err = spec.commandLine().getErr();
      imported.messages().forEach(err::println);
      int lost = imported.lost();
      if (strict && lost > 0) {
        throw new UsageException(
            MessageCode.IMPORT_WOULD_LOSE
                + " "
                + robot
                + (lost == 1 ? " has one thing" : " has " + lost + " things")
                + " that MechML does not have, listed above; nothing was written. Leave out"
                + " --strict to import the rest");
      }
      OutputFile.write(target, imported.text().getBytes(StandardCharsets.UTF_8));
      return ExitStatus.DONE;
    }
  }
}
