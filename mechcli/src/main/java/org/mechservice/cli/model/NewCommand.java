package org.mechservice.cli.model;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.concurrent.Callable;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech new}: a commented model that runs, to begin with. */
@Command(
    name = "new",
    description = "Writes NAME.xml: a small model with comments, which runs, to begin with.",
    footer = "mech new pendulum",
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class NewCommand implements Callable<Integer> {
  private static final String TEMPLATE = "new-model.xml";

  @Parameters(
      paramLabel = "NAME",
      description = "Name of the model, of letters, digits and _; a folder may stand before it.")
  private Path name = Path.of("");

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException {
    String model = String.valueOf(name.getFileName()).replaceFirst("\\.xml$", "");
    if (!model.matches("[A-Za-z_][A-Za-z0-9_]*")) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " new: \""
              + model
              + "\" is no name of a model: use letters, digits and _, and no digit first");
    }
    Path file = name.resolveSibling(model + ".xml");
    if (Files.exists(file)) {
      throw new UsageException(
          MessageCode.OUTPUT_PLACE + " " + file + " exists; choose another name or remove it");
    }
    OutputFile.write(file, template().replace("@NAME@", model).getBytes(StandardCharsets.UTF_8));
    spec.commandLine()
        .getOut()
        .println(file + "; run it with: mech simulate " + file + " --out r.csv");
    return ExitStatus.DONE;
  }

  /** Returns the model that users begin with; {@code @NAME@} stands for its name. */
  public static String template() throws IOException {
    try (InputStream in = NewCommand.class.getResourceAsStream(TEMPLATE)) {
      return new String(
          Objects.requireNonNull(in, TEMPLATE).readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
