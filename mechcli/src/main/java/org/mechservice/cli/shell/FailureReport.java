package org.mechservice.cli.shell;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.regex.Pattern;
import org.mechservice.admin.AdminFailure;
import org.mechservice.admin.PlainText;
import org.mechservice.client.failure.InvalidModelException;
import org.mechservice.client.failure.InvalidOptionException;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.orb.PortInUseException;
import org.mechservice.orb.ServiceUnreachableException;
import org.mechservice.solver.catalogue.MessageCode;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import picocli.CommandLine;
import picocli.CommandLine.ParseResult;

/** Turns an exception into one message with a code, and into an exit status. */
public final class FailureReport {
  /** The details of an internal error go to the log file only, if the user named one. */
  private static final Logger INCIDENTS = LoggerFactory.getLogger("incident");

  private static final Pattern CODED = Pattern.compile("(?s).*\\b[MNS]-\\d{3}\\b.*");

  private FailureReport() {}

  /** Handles whatever a command threw. */
  public static int failed(Exception failure, CommandLine command, ParseResult parsed) {
    return print(failure, command.getErr());
  }

  /** Prints the message of an error of the virtual machine and returns the exit status. */
  public static int failed(Error failure, PrintWriter err) {
    if (failure instanceof OutOfMemoryError) {
      err.println(
          MessageCode.OUT_OF_MEMORY
              + " this needs more than the "
              + (Runtime.getRuntime().maxMemory() >> 20)
              + " MB of memory that Java takes here; give it more, such as JDK_JAVA_OPTIONS=-Xmx8g,"
              + " or use a smaller file or model");
      return ExitStatus.SIMULATION_FAILED;
    }
    return internal(failure, err);
  }

  /** Prints the message of a failure and returns its exit status. */
  static int print(Exception failure, PrintWriter err) {
    String text = String.valueOf(failure.getMessage());
    if (failure instanceof ServiceException refusal) {
      err.println(text);
      return status(refusal);
    } else if (failure instanceof AdminFailure vain) {
      err.println(PlainText.of(text));
      return status(vain);
    } else if (failure instanceof UsageException) {
      err.println(text);
      return ExitStatus.BAD_INPUT;
    } else if (failure instanceof IOException unusable) {
      err.println(fileMessage(unusable));
      return ExitStatus.BAD_INPUT;
    } else if (failure instanceof PortInUseException
        || failure instanceof ServiceUnreachableException) {
      err.println(text);
      return ExitStatus.SERVER;
    } else if (failure instanceof IllegalArgumentException && CODED.matcher(text).matches()) {
      err.println(text);
      return ExitStatus.BAD_INPUT;
    }
    return internal(failure, err);
  }

  /** Prints one line about what has ended a thread that nobody waits for. */
  public static void ofThread(Throwable failure, PrintWriter err) {
    if (failure instanceof Error error) {
      failed(error, err);
    } else {
      internal(failure, err);
    }
    err.flush();
  }

  private static int internal(Throwable failure, PrintWriter err) {
    INCIDENTS.error("internal error", failure);
    err.println(
        MessageCode.INTERNAL_ERROR
            + " internal error ("
            + failure.getClass().getSimpleName()
            + "); run again with MECH_LOG=mech.log and report what that file says");
    return ExitStatus.SIMULATION_FAILED;
  }

  /** Returns the exit status that a refusal of the service means. */
  public static int status(ServiceException refusal) {
    boolean input =
        refusal instanceof InvalidModelException || refusal instanceof InvalidOptionException;
    return input ? ExitStatus.BAD_INPUT : ExitStatus.SERVER;
  }

  /** Returns the exit status that a failed administration means. */
  public static int status(AdminFailure failure) {
    return switch (failure.reason()) {
      case NO_ANSWER, NOT_ALLOWED -> ExitStatus.SERVER;
      case NOT_FOUND, NOT_USABLE -> ExitStatus.BAD_INPUT;
    };
  }

  /** File exceptions of Java name the file and, sometimes, a reason. */
  public static String fileMessage(IOException failure) {
    String text = String.valueOf(failure.getMessage());
    if (CODED.matcher(text).matches()) {
      return text;
    } else if (failure instanceof NoSuchFileException missing) {
      return MessageCode.FILE_UNUSABLE + " there is no file " + missing.getFile();
    } else if (failure instanceof FileSystemException broken) {
      String reason = broken.getReason();
      String why = reason == null ? "it is not accessible" : reason;
      return MessageCode.FILE_UNUSABLE + " " + broken.getFile() + " cannot be used: " + why;
    }
    return MessageCode.FILE_UNUSABLE + " " + text;
  }
}
