package org.mechservice.cli.model;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech examples}: lists the examples, which are part of the program, and copies one. */
@Command(
    name = "examples",
    description = "Lists the examples, or copies one of them: its models and what belongs to them.",
    footer = {"mech examples", "mech examples robot -o my-robot"},
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class ExamplesCommand implements Callable<Integer> {
  @Parameters(arity = "0..1", paramLabel = "NAME", description = "The example to copy.")
  private @Nullable String name;

  @Option(
      names = {"-o", "--out", "--output"},
      paramLabel = "DIR",
      description = "The new folder for the copy; default: NAME in the current folder.")
  private @Nullable Path target;

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException {
    try (Examples examples = Examples.open()) {
      if (name == null) {
        list(examples);
      } else {
        copy(examples, name);
      }
    }
    return ExitStatus.DONE;
  }

  private void list(Examples examples) throws IOException {
    requireNoTarget();
    PrintWriter out = spec.commandLine().getOut();
    for (String example : examples.names()) {
      out.printf("%-22s%s%n", example, examples.title(example));
    }
    out.println();
    out.println("mech examples NAME copies one.");
  }

  private void copy(Examples examples, String example) throws IOException {
    if (!examples.names().contains(example)) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " examples: there is no example \""
              + example
              + "\"; choose one of "
              + String.join(", ", examples.names()));
    }
    Path copy = Optional.ofNullable(target).orElse(Path.of(example));
    if (Files.exists(copy)) {
      throw new UsageException(
          MessageCode.OUTPUT_PLACE
              + " "
              + copy
              + " exists; name a new folder with -o DIR, or remove it");
    }
    try {
      examples.copy(example, copy);
    } catch (IOException e) {
      throw new UsageException(
          MessageCode.FILE_UNUSABLE + " the example cannot be copied to " + copy + ": " + e);
    }
    spec.commandLine().getOut().println(copy + "; begin with " + copy.resolve(Examples.README));
  }

  private void requireNoTarget() {
    if (target != null) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " --out "
              + target
              + ": no example is named; write mech examples NAME -o DIR");
    }
  }
}
