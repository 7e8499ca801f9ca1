package org.mechservice.cli.simulate;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.client.run.RunResult;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.text.JsonText;
import org.mechservice.solver.text.ReportText;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/**
 * The destinations of the results of a run, and the end of the run: the rows are kept, the report
 * is printed, and the exit status is set.
 */
final class ResultOptions {
  /** Lines of the report without {@code --verbose}. */
  static final int LINES = 10;

  /** The first entries of a printed report. */
  private static final List<String> FIRST =
      List.of(
          "scene",
          "outcome",
          "formulation",
          "integrator",
          "relativeTolerance",
          "steps",
          "evaluations",
          "rows",
          "wallTime",
          "energyDrift");

  /** Lines that say nothing of statics, kinematics and other analyses without an integrator. */
  private static final Set<String> OF_INTEGRATORS =
      Set.of("integrator", "relativeTolerance", "absoluteTolerance");

  private static final Set<String> NEVER_LEFT_OUT = Set.of("stiffness", "notes");

  @Option(
      names = {"-o", "--out", "--output"},
      paramLabel = "FILE",
      description = {
        "Write the rows here; may be given several times. The name ends in .csv or .tsv (units"
            + " beside it), .json, .mat or .parquet (units inside); or in .glb for an animated"
            + " scene, to which the columns of the bodies are added.",
        "With - the rows go to standard output as CSV, and the report to standard error."
      })
  private List<Path> out = List.of();

  @Option(
      names = "--verbose",
      description = "Print the whole run report; ten lines if left out, while --json has all.")
  private boolean verbose;

  @Option(names = "--quiet", description = "Print nothing but errors.")
  private boolean quiet;

  @Option(names = "--json", description = "Print the run report as one JSON object.")
  private boolean json;

  @Spec(Spec.Target.MIXEE)
  private CommandSpec command = CommandSpec.create();

  /**
   * Checks the options before anything is computed.
   *
   * @param model whether there is a model, without which there are no animated scenes
   * @throws UsageException S-044 if a file has a name that cannot be used, S-046 if an animated
   *     scene has, S-041 if both the rows and the JSON object would go to standard output
   */
  void requireUsable(boolean model) {
    List<Path> animated = model ? animated() : List.of();
    animated.forEach(OutputFile::requireUsable);
    ResultFiles.requireUsableNames(
        out.stream().filter(target -> !animated.contains(target)).toList());
    if (json && ResultFiles.arePrinted(out)) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " --json and --out - both write to standard output; give --out a file");
    }
  }

  /**
   * Opens the files for the rows.
   *
   * @param expectedRows number of rows that the settings of the run give; empty: not known
   * @param animations those that are animated scenes
   * @throws IOException if one cannot be written
   */
  ResultFiles open(OptionalLong expectedRows, List<AnimationFile> animations) throws IOException {
    return ResultFiles.open(out, command.commandLine().getOut(), expectedRows, animations);
  }

  /** Returns the files that are animated scenes. */
  List<Path> animated() {
    return out.stream().filter(AnimationFile::is).toList();
  }

  /** Returns the files for the rows. */
  List<Path> files() {
    return out;
  }

  boolean quiet() {
    return quiet;
  }

  /** Returns whether progress is printed. */
  boolean talks() {
    return !quiet && !json;
  }

  /**
   * Keeps the rows of a run, prints its report and says why it ended if it did not reach the end.
   *
   * @return exit status
   */
  int report(RunResult result, ResultFiles files) throws IOException {
    Map<String, Object> report = new LinkedHashMap<>(result.report());
    if (files.rows() > 0) {
      files.keep().ifPresent(hash -> report.put("resultsSha256", hash));
    }
    PrintWriter terminal =
        ResultFiles.arePrinted(out)
            ? command.commandLine().getErr()
            : command.commandLine().getOut();
    if (json) {
      terminal.println(JsonText.write(report));
    } else if (!quiet) {
      terminal.print(ReportText.format(verbose ? report : brief(report)));
    }
    // Now: after an interrupt the process ends as soon as the run is closed.
    terminal.flush();
    return status(result.outcome(), files);
  }

  /**
   * Returns the lines of a report that matter most, in its order: {@link #FIRST}, then others; and
   * the verdict on stiffness and the notes on the run, of which none may be missed.
   */
  static Map<String, Object> brief(Map<String, Object> report) {
    Set<String> told =
        Stream.concat(FIRST.stream(), report.keySet().stream())
            .filter(report::containsKey)
            .distinct()
            .limit(LINES)
            .collect(Collectors.toSet());
    Map<String, Object> brief = new LinkedHashMap<>(report);
    brief.keySet().removeIf(key -> !told.contains(key) && !NEVER_LEFT_OUT.contains(key));
    if (MethodNames.NONE.equals(report.get("integrator"))) {
      brief.keySet().removeAll(OF_INTEGRATORS);
    }
    return brief;
  }

  private int status(Outcome outcome, ResultFiles files) {
    PrintWriter err = command.commandLine().getErr();
    if (outcome instanceof Outcome.Failed failed) {
      err.println(failed.failure().message() + files.filesOfRows());
      return ExitStatus.SIMULATION_FAILED;
    } else if (outcome instanceof Outcome.Stopped) {
      err.println(
          MessageCode.RUN_STOPPED
              + " the run was stopped at "
              + files.reached()
              + "."
              + files.filesOfRows());
      return ExitStatus.INTERRUPTED;
    }
    return ExitStatus.DONE;
  }

  /** Keeps the rows that came before a run was lost, and says where. */
  static String keptRows(ResultFiles files) throws IOException {
    boolean kept = files.rows() > 0 && files.keep().isPresent();
    return kept ? "; rows up to " + files.reached() + " are in " + files : "";
  }
}
