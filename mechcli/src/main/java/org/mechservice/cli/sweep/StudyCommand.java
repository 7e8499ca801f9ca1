package org.mechservice.cli.sweep;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.mechservice.cli.model.UserCodeOption;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.cli.shell.ServerOption;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.study.run.StudyPart;
import org.mechservice.study.run.StudyPlan;
import org.mechservice.study.run.StudyReader;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech study}: many runs of a model, as a file describes them. */
@Command(
    name = "study",
    description = {
      "Runs a model at the points of a design, on all cores, and writes what is kept of each run"
          + " as a row, in the order of the points.",
      "What was interrupted is taken up again by the same command. The same file gives the same"
          + " bytes on every engine, with any number of threads, after interruptions and in parts."
    },
    subcommands = StudyJoinCommand.class,
    footer = {"mech study study.xml -o table.csv", "mech study study.xml --part 3/8"},
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class StudyCommand implements Callable<Integer> {
  /** The place where points run; the constants are the words of the option. */
  @SuppressWarnings("checkstyle:ConstantName")
  private enum Engine {
    threads,
    hosts,
    spark
  }

  @Parameters(
      arity = "0..1",
      paramLabel = "STUDY.xml",
      description = "The study, XML or YAML: model, factors, design, outputs.")
  private @Nullable Path file;

  @Option(
      names = {"-o", "--output", "--out"},
      paramLabel = "FILE",
      description =
          "The table to write, .csv or .parquet (default: the study's name with .csv, in this folder); beside it"
              + " a file with the ending .study.json says where it comes from.")
  private @Nullable String out;

  @Mixin private ThreadsOption threads = new ThreadsOption();

  @Option(
      names = "--engine",
      paramLabel = "ENGINE",
      description =
          "Where the points run: ${COMPLETION-CANDIDATES}. threads of this process (default); hosts"
              + " of a server; spark, a cluster, by the spark-submit of SPARK_HOME or the path.")
  private Engine engine = Engine.threads;

  @Mixin private ServerOption server = new ServerOption();

  @Mixin private UserCodeOption userCode = new UserCodeOption();

  @Option(
      names = "--master",
      paramLabel = "URL",
      description = "The cluster's master, such as spark://head:7077, yarn or local[2].")
  private Optional<String> master = Optional.empty();

  @Option(
      names = "--conf",
      paramLabel = "NAME=VALUE",
      description =
          "A setting of Spark, such as spark.executor.memory=2g; may be given several" + " times.")
  private List<String> settings = List.of();

  @Option(
      names = "--part",
      paramLabel = "I/N",
      description =
          "Run part I of N, for array jobs; mech study join puts the parts together. A stop"
              + " rule acts when they are joined.")
  private String part = StudyPart.WHOLE.toString();

  @Option(names = "--quiet", description = "Print nothing but errors.")
  private boolean quiet;

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException, InterruptedException {
    if (file == null) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " no study is named; write mech study STUDY.xml, or mech study join PART.csv... -o"
              + " ALL.csv");
    }
    requireOptionsOfEngine();
    StudyPart asked = part();
    if (engine == Engine.spark) {
      return SparkSubmit.run(
          SparkSubmit.command(System.getenv(), master, settings, wordsForSpark(file, asked)));
    }
    if (!asked.equals(StudyPart.WHOLE)
        && out != null
        && !out.toLowerCase(Locale.ROOT).endsWith(".csv")) {
      throw new UsageException(
          MessageCode.RESULT_FILE_NAME
              + " -o "
              + out
              + ": a part is written to a .csv file; mech study join writes .parquet of all parts");
    }
    Path table = out == null ? Path.of(nameOf(file, asked)) : Path.of(out);
    requireTable(table);
    OutputFile.requireUsable(table);
    StudyPlan plan;
    try {
      plan = StudyReader.read(file, Files.readAllBytes(file), userCode.consent());
    } catch (MechmlException e) {
      throw new UsageException(String.valueOf(e.getMessage()));
    }
    StudyRun run =
        new StudyRun(
            plan,
            asked,
            threads,
            spec.commandLine().getOut(),
            spec.commandLine().getErr(),
            quiet,
            false);
    return engine == Engine.hosts
        ? run.onHosts(table, server, userCode.consent())
        : run.here(table);
  }

  /** Refuses options that another engine would take. */
  private void requireOptionsOfEngine() {
    List<String> given =
        spec.commandLine().getParseResult().matchedOptions().stream()
            .map(OptionSpec::longestName)
            .toList();
    List<String> others =
        switch (engine) {
          case threads -> List.of("--server", "--master", "--conf");
          case hosts -> List.of("--master", "--conf");
          case spark -> List.of("--server", "--threads", "--part");
        };
    for (String option : others) {
      if (given.contains(option)) {
        throw new UsageException(
            MessageCode.OPTION_UNUSABLE + " " + option + " is none of --engine " + engine);
      }
    }
  }

  private List<String> wordsForSpark(Path study, StudyPart asked) {
    List<String> words = new ArrayList<>(List.of(study.toString(), "-o"));
    words.add(out == null ? nameOf(study, asked) : out);
    if (quiet) {
      words.add("--quiet");
    }
    words.addAll(userCode.words());
    return words;
  }

  private StudyPart part() {
    try {
      return StudyPart.parse(part);
    } catch (IllegalArgumentException e) {
      throw new UsageException(MessageCode.OPTION_UNUSABLE + " --part: " + e.getMessage());
    }
  }

  private static String nameOf(Path file, StudyPart part) {
    String name = String.valueOf(file.getFileName()).replaceFirst("\\.[^.]*$", "");
    return name
        + (part.equals(StudyPart.WHOLE) ? "" : "-" + part.number() + "of" + part.count())
        + ".csv";
  }

  /** Refuses names of tables in other formats. */
  static void requireTable(Path table) {
    String name = table.toString().toLowerCase(Locale.ROOT);
    if (!name.endsWith(".csv") && !name.endsWith(".parquet")) {
      throw new UsageException(
          MessageCode.RESULT_FILE_NAME
              + " -o "
              + table
              + ": the table of a study is written to a .csv or a .parquet file");
    }
  }
}
