package org.mechservice.report.measure;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.concurrent.TimeUnit;

/**
 * Times first runs in Java machines of their own, start of the machine included. All JARs are run
 * in turns, so that whatever slows the computer down hits all alike.
 */
public final class ColdRunTiming implements AutoCloseable {
  private final Path folder;
  private final Map<String, Path> jars = new LinkedHashMap<>();

  /**
   * @throws IOException if there is no place for temporary files
   */
  public ColdRunTiming() throws IOException {
    folder = Files.createTempDirectory("mech-report");
  }

  /** Adds a standalone JAR, which starts with {@code java -jar}. */
  public void add(String name, byte[] jar) throws IOException {
    Path file = folder.resolve(jars.size() + ".jar");
    Files.write(file, jar);
    jars.put(name, file);
  }

  /**
   * Runs every JAR some times.
   *
   * @param tolerance relative tolerance of the runs
   * @param endTime of the runs, s
   * @param times number of runs of each
   * @param limitSeconds for one run, s
   * @param budget ends the runs when the time for the report is over; a JAR has then fewer of them
   * @param progress is called for every run
   * @return by name; none for a JAR of which a run fails or takes too long, or is not begun
   */
  public Map<String, ColdRunTimes> run(
      double tolerance,
      double endTime,
      int times,
      double limitSeconds,
      ReportBudget budget,
      ReportProgress progress)
      throws IOException, InterruptedException {
    Map<String, double[]> taken = new LinkedHashMap<>();
    jars.keySet().forEach(name -> taken.put(name, new double[0]));
    long started = System.nanoTime();
    int done = 0;
    boolean cut = false;
    for (int i = 0; i < times; i++) {
      for (Map.Entry<String, Path> jar : jars.entrySet()) {
        double elapsed = (System.nanoTime() - started) * 1e-9;
        if (budget.left() < (done == 0 ? 0 : elapsed / done)) {
          cut = true;
          continue;
        }
        double left = done == 0 ? Double.NaN : elapsed / done * (times * jars.size() - done);
        progress.at("first runs: " + jar.getKey(), 0.97, left);
        done++;
        double[] seconds = taken.get(jar.getKey());
        OptionalDouble one =
            seconds == null
                ? OptionalDouble.empty()
                : seconds(jar.getValue(), tolerance, endTime, limitSeconds);
        if (one.isEmpty()) {
          taken.remove(jar.getKey());
        } else if (seconds != null) {
          double[] more = Arrays.copyOf(seconds, seconds.length + 1);
          more[seconds.length] = one.getAsDouble();
          taken.put(jar.getKey(), more);
        }
      }
    }
    Map<String, ColdRunTimes> runs = new LinkedHashMap<>();
    taken.values().removeIf(seconds -> seconds.length == 0);
    taken.forEach((name, seconds) -> runs.put(name, ColdRunTimes.of(seconds)));
    if (cut) {
      budget.saves(
          String.format(
              Locale.ROOT,
              "%d first runs in a fresh JVM were made in place of %d.",
              done,
              times * jars.size()));
    }
    return runs;
  }

  private static OptionalDouble seconds(
      Path jar, double tolerance, double endTime, double limitSeconds)
      throws IOException, InterruptedException {
    long started = System.nanoTime();
    Process process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-jar",
                jar.toString(),
                "--quiet",
                "--t-end",
                Double.toString(endTime),
                "--rtol",
                Double.toString(tolerance),
                "--atol",
                Double.toString(tolerance * MethodRunner.ABSOLUTE_PART))
            .redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .start();
    if (!process.waitFor((long) (1000 * limitSeconds), TimeUnit.MILLISECONDS)) {
      process.destroyForcibly();
      return OptionalDouble.empty();
    }
    return process.exitValue() == 0
        ? OptionalDouble.of((System.nanoTime() - started) * 1e-9)
        : OptionalDouble.empty();
  }

  @Override
  public void close() throws IOException {
    for (Path jar : jars.values()) {
      Files.deleteIfExists(jar);
    }
    Files.deleteIfExists(folder);
  }
}
