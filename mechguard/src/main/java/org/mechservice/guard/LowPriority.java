package org.mechservice.guard;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import java.util.stream.Stream;

/**
 * Lower priority at the operating system for what takes long, so that what takes little is served
 * beside it. On Linux, where {@code renice} is installed; elsewhere nothing happens.
 */
public final class LowPriority {
  /** A tenth of the share of what has the usual priority. */
  private static final String NICE = "10";

  /** What takes longer than that has a lower priority. */
  private static final long LONG_NANOS = 3_000_000_000L;

  private LowPriority() {}

  /**
   * Returns whether what has begun takes so long that others come first.
   *
   * @param begin by {@link System#nanoTime}
   */
  public static boolean isDue(long begin) {
    return System.nanoTime() - begin > LONG_NANOS;
  }

  /**
   * Lowers the priority of a process and of those that it has started, once and for all: of all
   * their threads, since Linux has one for each.
   */
  public static void lower(ProcessHandle process) {
    List<String> threads =
        Stream.concat(Stream.of(process), process.descendants())
            .flatMap(LowPriority::threadsOf)
            .toList();
    if (!threads.isEmpty()) {
      renice(threads);
    }
  }

  private static Stream<String> threadsOf(ProcessHandle process) {
    Path tasks = Path.of("/proc", Long.toString(process.pid()), "task");
    try (Stream<Path> threads = Files.list(tasks)) {
      return threads.map(thread -> thread.getFileName().toString()).toList().stream();
    } catch (IOException | UncheckedIOException e) {
      return Stream.empty(); // it has ended, or this is no Linux
    }
  }

  /**
   * Lowers the priority of a thread of this process, once and for all.
   *
   * @param id of the thread
   */
  public static void lowerThread(long id) {
    renice(List.of(Long.toString(id)));
  }

  private static void renice(List<String> threads) {
    List<String> command = new ArrayList<>(List.of("renice", "-n", NICE, "-p"));
    command.addAll(threads);
    try {
      new ProcessBuilder(command)
          .redirectOutput(ProcessBuilder.Redirect.DISCARD)
          .redirectError(ProcessBuilder.Redirect.DISCARD)
          .start();
    } catch (IOException e) {
      // It is not installed: all have the same priority.
      return;
    }
  }

  /** Returns the id of the thread that calls, as the operating system counts; empty elsewhere. */
  public static OptionalLong idOfThisThread() {
    try {
      String name = Files.readSymbolicLink(Path.of("/proc/thread-self")).getFileName().toString();
      return OptionalLong.of(Long.parseLong(name));
    } catch (IOException | NumberFormatException | UnsupportedOperationException e) {
      return OptionalLong.empty();
    }
  }
}
