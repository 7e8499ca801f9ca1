package org.mechservice.examples;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;

/** Runs commands in a directory and keeps their output. */
final class Terminal {
  /**
   * Time limit of a command, far above the duration of every command of these tests: a film that is
   * drawn in software takes five minutes beside ten other builds.
   */
  private static final Duration PATIENCE = Duration.ofMinutes(20);

  private final Path directory;

  Terminal(Path directory) {
    this.directory = directory;
  }

  /** Runs {@code ./mech} with these arguments and waits for its end. */
  Ended mech(String... arguments) {
    return run(mechCommand(arguments));
  }

  /** Starts {@code ./mech} with these arguments; closing it ends it. */
  Running startMech(String... arguments) {
    return start(mechCommand(arguments));
  }

  private static String[] mechCommand(String... arguments) {
    List<String> command = new ArrayList<>();
    command.add(WorkingTree.MECH.toString());
    command.addAll(Arrays.asList(arguments));
    return command.toArray(String[]::new);
  }

  /** Runs a line as a user's shell does. */
  Ended shell(String line) {
    return run("sh", "-c", line);
  }

  /** Runs a command and waits for its end. */
  Ended run(String... command) {
    try (Running running = start(command)) {
      return running.awaitEnd();
    }
  }

  /** Starts a command; closing it ends it. */
  Running start(String... command) {
    try {
      Path log = Files.createTempDirectory("terminal");
      Process process =
          new ProcessBuilder(command)
              .directory(directory.toFile())
              .redirectInput(ProcessBuilder.Redirect.from(Path.of("/dev/null").toFile()))
              .redirectOutput(log.resolve("stdout").toFile())
              .redirectError(log.resolve("stderr").toFile())
              .start();
      return new Running(String.join(" ", command), process, log);
    } catch (IOException e) {
      throw new AssertionError("cannot start " + String.join(" ", command), e);
    }
  }

  /**
   * A command that has ended.
   *
   * @param command the command
   * @param exitStatus its exit status
   * @param stdout what it printed on standard output
   * @param stderr what it printed on standard error
   */
  record Ended(String command, int exitStatus, String stdout, String stderr) {
    /** Returns this if the command was successful; fails the test with its messages if not. */
    Ended orFail() {
      if (exitStatus != 0) {
        throw new AssertionError(toString());
      }
      return this;
    }

    @Override
    public String toString() {
      return "`%s` ended with %d%n%s%n%s".formatted(command, exitStatus, stdout, stderr);
    }
  }

  /** A running command. */
  static final class Running implements AutoCloseable {
    private final String command;
    private final Process process;
    private final Path log;

    private Running(String command, Process process, Path log) {
      this.command = command;
      this.process = process;
      this.log = log;
    }

    /** Waits for the end of the command. */
    Ended awaitEnd() {
      try {
        if (!process.waitFor(PATIENCE.toSeconds(), TimeUnit.SECONDS)) {
          throw new AssertionError("does not end: " + soFar(-1));
        }
        return soFar(process.exitValue());
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw new AssertionError("interrupted in `" + command + "`", e);
      }
    }

    /** Waits until a condition holds while the command runs. */
    void awaitThat(String what, BooleanSupplier condition) {
      long deadline = System.nanoTime() + PATIENCE.toNanos();
      while (!condition.getAsBoolean()) {
        if (!process.isAlive()) {
          throw new AssertionError(what + " never came: " + soFar(process.exitValue()));
        }
        if (System.nanoTime() > deadline) {
          throw new AssertionError(what + " did not come: " + soFar(-1));
        }
        try {
          Thread.sleep(100);
        } catch (InterruptedException e) {
          Thread.currentThread().interrupt();
          throw new AssertionError("interrupted waiting for " + what, e);
        }
      }
    }

    /** Returns what it has printed on standard output so far. */
    String stdout() {
      return printed("stdout");
    }

    /** Returns what it has printed on standard error so far. */
    String stderr() {
      return printed("stderr");
    }

    /** Asks it to end, as {@code kill} does; Ctrl-C does not reach what was started aside. */
    void terminate() {
      process.destroy();
    }

    private Ended soFar(int exitStatus) {
      return new Ended(command, exitStatus, stdout(), printed("stderr"));
    }

    private String printed(String stream) {
      try {
        return Files.readString(log.resolve(stream), StandardCharsets.UTF_8);
      } catch (IOException e) {
        throw new AssertionError("the output of `" + command + "` is gone", e);
      }
    }

    @Override
    public void close() {
      process.descendants().forEach(ProcessHandle::destroy);
      process.destroy();
      try {
        if (!process.waitFor(10, TimeUnit.SECONDS)) {
          process.descendants().forEach(ProcessHandle::destroyForcibly);
          process.destroyForcibly();
        }
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
      deleteLog();
    }

    private void deleteLog() {
      try {
        Files.deleteIfExists(log.resolve("stdout"));
        Files.deleteIfExists(log.resolve("stderr"));
        Files.deleteIfExists(log);
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }
}
