package org.mechservice.cli.picture;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.result.ResultFormat;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.view.plot.Plot;
import org.mechservice.view.plot.PlotRequest;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech plot}: curves of results. */
@Command(
    name = "plot",
    description = "Draws the curves of results, of several runs over each other.",
    footer = {
      "mech plot r.csv hinge.q hinge.v -o curves.svg",
      "mech plot before.csv after.csv hinge.q -o both.html"
    },
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class PlotCommand implements Callable<Integer> {
  @Parameters(
      arity = "1..*",
      paramLabel = "RESULT|COLUMN",
      description =
          "Result files (CSV, TSV, MAT, JSON, Parquet), and the names of columns; * and ? stand for"
              + " other characters. If no columns are named, the coordinates of the joints are"
              + " drawn.")
  private List<String> words = List.of();

  @Option(
      names = {"-o", "--output", "--out"},
      required = true,
      paramLabel = "FILE.svg|png|html",
      description = "The picture to write, or a page with zoom and values at the cursor.")
  private Path target = Path.of("");

  @Option(
      names = "--x",
      paramLabel = "COLUMN",
      description = "Column of the horizontal axis instead of the time, for phase plots.")
  private Optional<String> x = Optional.empty();

  @Mixin private DarkOption theme = new DarkOption();

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException {
    String format = PictureFile.formatOfDiagram(target);
    List<Path> files = words.stream().filter(PlotCommand::isFile).map(Path::of).toList();
    List<String> columns =
        words.stream()
            .filter(word -> !isFile(word))
            .flatMap(word -> Stream.of(word.split(",", -1)))
            .map(String::strip)
            .filter(word -> !word.isEmpty())
            .toList();
    if (files.isEmpty()) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE + " no result file is named, such as r.csv");
    }
    Plot plot = new PlotRequest(distinct(files), columns, x).read();
    PictureFile.write(target, format, plot, theme.isDark());
    plot.notes().forEach(spec.commandLine().getErr()::println);
    return ExitStatus.DONE;
  }

  private static boolean isFile(String word) {
    return ResultFormat.of(Path.of(word)).isPresent() || Files.isRegularFile(Path.of(word));
  }

  private static List<Path> distinct(List<Path> files) {
    List<Path> distinct = new ArrayList<>();
    for (Path file : files) {
      if (distinct.contains(file)) {
        throw new UsageException(
            MessageCode.OPTION_UNUSABLE + " " + file + " is named twice; name each file once");
      }
      distinct.add(file);
    }
    return distinct;
  }
}
