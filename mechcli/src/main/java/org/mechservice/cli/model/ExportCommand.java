package org.mechservice.cli.model;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.robot.RobotExport;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.ModelFiles;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech export}: a model becomes a robot in URDF or MJCF. */
@Command(
    name = "export",
    description = "Translates a model from MechML to URDF or MJCF and lists what is lost.",
    footer = "mech export model.xml -o robot.urdf",
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class ExportCommand implements Callable<Integer> {
  @Parameters(paramLabel = "MODEL.xml", description = "Model in MechML.")
  private Path model = Path.of("");

  @Option(
      names = {"-o", "--output", "--out"},
      required = true,
      paramLabel = "FILE",
      description = "The robot to write: FILE.urdf in URDF, FILE.xml or FILE.mjcf in MJCF.")
  private Path target = Path.of("");

  @Option(names = "--strict", description = "Write nothing if anything is lost.")
  private boolean strict;

  @Mixin private ParameterOption parameters = new ParameterOption();

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException {
    String end = target.toString().toLowerCase(Locale.ROOT);
    boolean urdf = end.endsWith(".urdf");
    if (!urdf && !end.endsWith(".xml") && !end.endsWith(".mjcf")) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " --output "
              + target
              + ": the name must end in .urdf for URDF, in .xml or .mjcf for MJCF");
    }
    OutputFile.requireUsable(target);
    RobotExport robot = translated(urdf);
    PrintWriter err = spec.commandLine().getErr();
    robot.losses().forEach(err::println);
    int lost = robot.losses().size();
    if (strict && lost > 0) {
      throw new UsageException(
          MessageCode.IMPORT_WOULD_LOSE
              + " "
              + model
              + (lost == 1 ? " has one thing" : " has " + lost + " things")
              + " that "
              + (urdf ? "URDF" : "MJCF")
              + " does not have, listed above; nothing was written. Leave out --strict"
              + " to export the rest");
    }
    OutputFile.write(target, robot.text().getBytes(StandardCharsets.UTF_8));
    return ExitStatus.DONE;
  }

  private RobotExport translated(boolean urdf) throws IOException {
    String name = model.toString();
    byte[] content = ModelFiles.inlined(Files.readAllBytes(model), model);
    try {
      ReadOptions values = new ReadOptions(Optional.empty(), parameters.values(), Set.of());
      MechmlModel read = MechmlReader.read(name, content, values);
      return urdf
          ? RobotExport.of(name, read, MechmlReader.whole(name, content))
          : RobotExport.mjcf(name, read);
    } catch (MechmlException e) {
      throw new UsageException(String.valueOf(e.getMessage()));
    }
  }
}
