package org.mechservice.cli;

import java.io.PrintWriter;
import java.util.List;
import java.util.Set;
import org.mechservice.cli.admin.AdminCommand;
import org.mechservice.cli.clearance.ClearanceCommand;
import org.mechservice.cli.model.BuildCommand;
import org.mechservice.cli.model.CheckCommand;
import org.mechservice.cli.model.ExamplesCommand;
import org.mechservice.cli.model.ExportCommand;
import org.mechservice.cli.model.ImportCommand;
import org.mechservice.cli.model.NewCommand;
import org.mechservice.cli.model.VerifyCommand;
import org.mechservice.cli.optimise.GradientCommand;
import org.mechservice.cli.optimise.IdentifyCommand;
import org.mechservice.cli.optimise.OptimiseCommand;
import org.mechservice.cli.picture.CompareCommand;
import org.mechservice.cli.picture.PlotCommand;
import org.mechservice.cli.picture.ShowCommand;
import org.mechservice.cli.picture.ViewCommand;
import org.mechservice.cli.picture.WebCommand;
import org.mechservice.cli.reference.ReferenceCommand;
import org.mechservice.cli.service.KeysCommand;
import org.mechservice.cli.service.ServerCommand;
import org.mechservice.cli.service.SimhostCommand;
import org.mechservice.cli.shell.CompletionCommand;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.FailureReport;
import org.mechservice.cli.shell.HelpSections;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.SafeWriter;
import org.mechservice.cli.shell.StandardOutput;
import org.mechservice.cli.shell.UsageReport;
import org.mechservice.cli.simulate.FetchCommand;
import org.mechservice.cli.simulate.SimulateCommand;
import org.mechservice.cli.sweep.StudyCommand;
import org.mechservice.cli.sweep.SweepCommand;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine;
import picocli.CommandLine.Command;

/** The {@code mech} command. */
@Command(
    name = "mech",
    description = "Simulates multibody systems written in MechML.",
    synopsisSubcommandLabel = "COMMAND",
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class,
    exitCodeListHeading = "%nExit status:%n",
    exitCodeList = {
      "0:done",
      "1:the simulation failed; results up to the failure are written",
      "2:bad usage or bad input",
      "3:server or network",
      "4:a robot was imported, and moves otherwise than in its own engine",
      "130:interrupted by Ctrl-C; results so far are written",
      "143:ended by a termination signal; results so far are written"
    })
public final class Mech {
  private static final String HELP = "help";

  /** Commands that tell of all others. */
  private static final Set<String> ALL_COMMANDS = Set.of(HELP, "completion", "reference");

  /** In the order in which help lists them. */
  private static final List<Class<?>> COMMANDS =
      List.of(
          NewCommand.class,
          ExamplesCommand.class,
          SimulateCommand.class,
          SweepCommand.class,
          StudyCommand.class,
          OptimiseCommand.class,
          GradientCommand.class,
          ClearanceCommand.class,
          IdentifyCommand.class,
          FetchCommand.class,
          CompareCommand.class,
          PlotCommand.class,
          CheckCommand.class,
          ShowCommand.class,
          ViewCommand.class,
          WebCommand.class,
          BuildCommand.class,
          ImportCommand.class,
          ExportCommand.class,
          ReportCommand.class,
          StabilityCommand.class,
          ServerCommand.class,
          SimhostCommand.class,
          AdminCommand.class,
          KeysCommand.class,
          VerifyCommand.class,
          CompletionCommand.class,
          ReferenceCommand.class,
          CommandLine.HelpCommand.class);

  /** Runs a command and ends the process with its exit status. */
  public static void main(String[] arguments) {
    StandardOutput out = StandardOutput.ofProcess();
    Thread.setDefaultUncaughtExceptionHandler(
        (thread, failure) -> FailureReport.ofThread(failure, new SafeWriter(System.err)));
    int status = run(new SafeWriter(out), new SafeWriter(System.err), arguments);
    System.exit(out.failure().map(why -> unwritten(why, status)).orElse(status));
  }

  private static int unwritten(String why, int status) {
    System.err.println(MessageCode.FILE_UNUSABLE + " standard output cannot be written: " + why);
    return status == ExitStatus.DONE ? ExitStatus.BAD_INPUT : status;
  }

  /**
   * Runs a command.
   *
   * @param out receives the results
   * @param err takes errors and progress
   * @param arguments command line
   * @return exit status
   */
  public static int run(PrintWriter out, PrintWriter err, String... arguments) {
    String[] words = arguments.length == 0 ? new String[] {HELP} : arguments;
    CommandLine line = new CommandLine(new Mech());
    commandsNamed(words[0]).forEach(line::addSubcommand);
    HelpSections.addTo(line);
    line.setOut(out)
        .setErr(err)
        .setCaseInsensitiveEnumValuesAllowed(true)
        .setParameterExceptionHandler(UsageReport::badUsage)
        .setExecutionExceptionHandler(FailureReport::failed);
    int status;
    try {
      status = line.execute(words);
    } catch (OutOfMemoryError | StackOverflowError | LinkageError | AssertionError failure) {
      status = FailureReport.failed(failure, err);
    }
    out.flush();
    err.flush();
    return status;
  }

  /**
   * Returns the command that a word names, or all of them: to prepare the options of all takes as
   * long as a small simulation.
   */
  private static List<Class<?>> commandsNamed(String word) {
    return COMMANDS.stream()
        .filter(type -> !ALL_COMMANDS.contains(word) && word.equals(nameOf(type)))
        .findFirst()
        .<List<Class<?>>>map(List::of)
        .orElse(COMMANDS);
  }

  private static String nameOf(Class<?> command) {
    return command.getAnnotation(Command.class).name();
  }
}
