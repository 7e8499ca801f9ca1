package org.mechservice.cli.sweep;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.study.run.StudyJoin;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code mech study join}: the parts of a study as one table. */
@Command(
    name = "join",
    description =
        "Puts the tables of all parts of a study together to the table that the whole study would"
            + " have written, byte by byte.",
    footer = "mech study join part-1of2.csv part-2of2.csv -o all.csv",
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class StudyJoinCommand implements Callable<Integer> {
  @Parameters(
      arity = "1..*",
      paramLabel = "PART.csv",
      description = "The tables of all parts, in any order; their .study.json beside them.")
  private List<Path> parts = List.of();

  @Option(
      names = {"-o", "--output", "--out"},
      required = true,
      paramLabel = "ALL",
      description = "The table to write, .csv or .parquet.")
  private Path out = Path.of("");

  @Override
  public Integer call() throws IOException {
    StudyCommand.requireTable(out);
    OutputFile.requireUsable(out);
    StudyJoin.join(parts, out);
    return ExitStatus.DONE;
  }
}
