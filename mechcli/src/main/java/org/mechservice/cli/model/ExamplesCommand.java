package org.mechservice.cli.model;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
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
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class ExamplesCommand implements Callable<Integer> {
  private static final String RESOURCE = "examples";
  private static final String README = "README.md";

  @Parameters(arity = "0..1", paramLabel = "NAME", description = "The example to copy.")
  private @Nullable String name;

  @Option(
      names = {"-o", "--out"},
      paramLabel = "DIR",
      description = "The new folder for the copy; default: NAME in the current folder.")
  private @Nullable Path target;

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException, URISyntaxException {
    URL examples = Objects.requireNonNull(ExamplesCommand.class.getResource(RESOURCE), RESOURCE);
    URI place = examples.toURI();
    if (!place.getScheme().equals("jar")) {
      return listOrCopy(Path.of(place));
    }
    try (FileSystem jar = FileSystems.newFileSystem(place, Map.of())) {
      return listOrCopy(jar.provider().getPath(place));
    }
  }

  private int listOrCopy(Path root) throws IOException {
    SortedMap<String, Path> examples = new TreeMap<>();
    for (Path folder : entries(root)) {
      examples.put(folder.getFileName().toString().replace("/", ""), folder);
    }
    PrintWriter out = spec.commandLine().getOut();
    if (name == null) {
      requireNoTarget();
      for (Map.Entry<String, Path> example : examples.entrySet()) {
        out.printf("%-22s%s%n", example.getKey(), title(example.getValue()));
      }
      out.println();
      out.println("mech examples NAME copies one.");
      return ExitStatus.DONE;
    }
    Path example = examples.get(name);
    if (example == null) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " examples: there is no example \""
              + name
              + "\"; choose one of "
              + String.join(", ", examples.keySet()));
    }
    Path copy = Optional.ofNullable(target).orElse(Path.of(name));
    if (Files.exists(copy)) {
      throw new UsageException(
          MessageCode.OUTPUT_PLACE
              + " "
              + copy
              + " exists; name a new folder with -o DIR, or remove it");
    }
    copy(example, copy);
    out.println(copy + "; begin with " + copy.resolve(README));
    return ExitStatus.DONE;
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

  private static List<Path> entries(Path folder) throws IOException {
    try (Stream<Path> entries = Files.list(folder)) {
      return entries.toList();
    }
  }

  /** Returns the heading of an example's page. */
  private static String title(Path example) throws IOException {
    try (Stream<String> lines = Files.lines(example.resolve(README))) {
      return lines.findFirst().orElse("").replaceFirst("^# *", "");
    }
  }

  private static void copy(Path from, Path to) throws IOException {
    try (Stream<Path> files = Files.walk(from)) {
      files.forEach(
          file -> {
            Path copied = to.resolve(from.relativize(file).toString());
            try {
              if (Files.isDirectory(file)) {
                Files.createDirectories(copied);
              } else {
                Files.copy(file, copied);
              }
            } catch (IOException e) {
              throw new UncheckedIOException(e);
            }
          });
    } catch (UncheckedIOException e) {
      throw new UsageException(
          MessageCode.FILE_UNUSABLE
              + " the example cannot be copied to "
              + to
              + ": "
              + e.getCause());
    }
  }
}
