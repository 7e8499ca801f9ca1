package org.mechservice.guard;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.OptionalLong;

/**
 * Lower priority at the operating system for what takes long, so that what takes little is served
 * beside it. On Linux, where {@code renice} is installed; elsewhere nothing happens.
 */
public final class LowPriority {
  /** A tenth of the share of what has the usual priority. */
  private static final String NICE = "10";

  private LowPriority() {}

  /**
   * Lowers a priority, once and for all.
   *
   * @param id of a process, or of a thread of this one
   */
  public static void lower(long id) {
    try {
      new ProcessBuilder("renice", "-n", NICE, "-p", Long.toString(id))
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
