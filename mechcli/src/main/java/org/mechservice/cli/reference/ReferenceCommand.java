package org.mechservice.cli.reference;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code mech reference}: the page of all commands, and their manual pages. */
@Command(
    name = "reference",
    hidden = true,
    description = "Writes the page of all commands for the user guide, or a manual page for each.",
    footer = {
      "mech reference --page docs/reference/commands.md",
      "mech reference --man share/man/man1"
    },
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class ReferenceCommand implements Callable<Integer> {
  @Option(names = "--page", paramLabel = "FILE.md", description = "Write the page here.")
  private Optional<Path> page = Optional.empty();

  @Option(
      names = "--man",
      paramLabel = "DIR",
      description = "Write the manual pages into this folder; it is made if need be.")
  private Optional<Path> manual = Optional.empty();

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException {
    if (page.isEmpty() && manual.isEmpty()) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE + " reference: --page FILE.md or --man DIR is missing");
    }
    List<CommandText> commands = CommandText.ofAll(spec.root().commandLine());
    if (page.isPresent()) {
      write(page.get(), CommandsPage.of(commands));
    }
    if (manual.isPresent()) {
      Files.createDirectories(manual.get());
      for (CommandText command : commands) {
        Path file = manual.get().resolve(ManPage.fileName(command));
        write(
            file,
            ManPage.of(command, new MechVersion().getVersion()[0], related(command, commands)));
      }
    }
    return ExitStatus.DONE;
  }

  /** Returns the command above one and those directly below it. */
  private static List<CommandText> related(CommandText command, List<CommandText> commands) {
    return commands.stream()
        .filter(
            other ->
                isDirectlyBelow(other.name(), command.name())
                    || isDirectlyBelow(command.name(), other.name()))
        .toList();
  }

  private static boolean isDirectlyBelow(String name, String above) {
    return name.startsWith(above + " ") && name.indexOf(' ', above.length() + 1) < 0;
  }

  private static void write(Path file, String text) throws IOException {
    OutputFile.write(file, text.getBytes(StandardCharsets.UTF_8));
  }
}
