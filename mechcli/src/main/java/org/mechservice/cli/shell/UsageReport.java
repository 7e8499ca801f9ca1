package org.mechservice.cli.shell;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;

/** Reports an error of the command line in one line and names the help page. */
public final class UsageReport {
  private UsageReport() {}

  /** Handles a command line that cannot be understood. */
  public static int badUsage(ParameterException wrong, String[] arguments) {
    CommandLine command = wrong.getCommandLine();
    CommandLine parent = command.getParent();
    String help =
        parent == null
            ? command.getCommandName() + " help"
            : parent.getCommandSpec().qualifiedName() + " help " + command.getCommandName();
    command.getErr().println(message(wrong) + " (" + help + " lists what there is)");
    return ExitStatus.BAD_INPUT;
  }

  private static String message(ParameterException wrong) {
    if (wrong instanceof UnmatchedArgumentException unmatched) {
      return unknown(unmatched);
    } else if (wrong instanceof MissingParameterException missing) {
      return MessageCode.OPTION_UNUSABLE + " " + missing(missing);
    }
    return MessageCode.OPTION_UNUSABLE
        + " "
        + badValue(wrong).orElseGet(() -> String.valueOf(wrong.getMessage()));
  }

  private static String unknown(UnmatchedArgumentException unmatched) {
    String word = unmatched.getUnmatched().get(0);
    List<String> nearest = unmatched.getSuggestions();
    // A suggestion carries the placeholder of its value.
    String hint =
        nearest.isEmpty() ? "" : "; did you mean " + nearest.get(0).split("[= ]", 2)[0] + "?";
    boolean namesCommand = !unmatched.getCommandLine().getSubcommands().isEmpty();
    String kind = namesCommand ? "command" : "word";
    return MessageCode.UNKNOWN_OPTION
        + " unknown "
        + (word.startsWith("-") ? "option" : kind)
        + " "
        + word
        + hint;
  }

  private static String missing(MissingParameterException missing) {
    String names =
        missing.getMissing().stream().map(UsageReport::name).collect(Collectors.joining(", "));
    boolean lacksValue = String.valueOf(missing.getMessage()).contains("parameter for option");
    return names + (lacksValue ? " lacks its value" : verb(missing) + " missing");
  }

  private static String verb(MissingParameterException missing) {
    return missing.getMissing().size() == 1 ? " is" : " are";
  }

  private static Optional<String> badValue(ParameterException wrong) {
    ArgSpec argument = wrong.getArgSpec();
    String value = wrong.getValue();
    if (argument == null) {
      return Optional.empty();
    } else if (value == null || argument.arity().max() == 0) {
      return Optional.of(name(argument) + " takes no value");
    }
    return Optional.of(name(argument) + " takes " + expected(argument) + ", not " + value);
  }

  private static String expected(ArgSpec argument) {
    Class<?> type = argument.auxiliaryTypes()[0];
    if (type == Path.class) {
      // The only names that Linux has and Java has not.
      return "a file name that this locale can spell (LC_ALL=C.UTF-8 can spell all)";
    }
    if (type.isEnum()) {
      return Stream.of(type.getEnumConstants())
          .map(constant -> constant.toString().toLowerCase(Locale.ROOT))
          .collect(Collectors.joining(" or "));
    }
    return type == Integer.class || type == int.class ? "a whole number" : "a number";
  }

  private static String name(ArgSpec argument) {
    return argument instanceof OptionSpec option ? option.shortestName() : argument.paramLabel();
  }
}
