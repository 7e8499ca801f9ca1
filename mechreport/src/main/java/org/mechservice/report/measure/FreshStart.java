package org.mechservice.report.measure;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.OptionalDouble;
import java.util.concurrent.TimeUnit;
import org.mechservice.client.BuiltJar;

/** Time of a first run in a Java machine of its own, start of the machine included. */
public final class FreshStart implements AutoCloseable {
  private final Path folder;

  /**
   * @throws IOException if there is no place for temporary files
   */
  public FreshStart() throws IOException {
    folder = Files.createTempDirectory("mech-report");
  }

  /**
   * Runs a standalone JAR some times.
   *
   * @param jar that starts with {@code java -jar}
   * @param tolerance relative tolerance of the runs
   * @param times number of runs
   * @param limitSeconds for one run, s
   * @return median, s; empty if a run fails or takes too long
   */
  public OptionalDouble seconds(
      BuiltJar jar, double tolerance, double endTime, int times, double limitSeconds)
      throws IOException, InterruptedException {
    Path file = folder.resolve("model.jar");
    Files.write(file, jar.bytes());
    double[] seconds = new double[times];
    for (int i = 0; i < times; i++) {
      long started = System.nanoTime();
      Process process =
          new ProcessBuilder(
                  Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                  "-jar",
                  file.toString(),
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
      if (process.exitValue() != 0) {
        return OptionalDouble.empty();
      }
      seconds[i] = (System.nanoTime() - started) * 1e-9;
    }
    Arrays.sort(seconds);
    return OptionalDouble.of(seconds[times / 2]);
  }

  @Override
  public void close() throws IOException {
    Files.deleteIfExists(folder.resolve("model.jar"));
    Files.deleteIfExists(folder);
  }
}
