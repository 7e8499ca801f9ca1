package org.mechservice.report;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.List;
import java.util.stream.Stream;
import org.mechservice.solver.simulation.SolverVersion;

/** The machine and the versions of a measurement. */
public final class Machine {
  private static final Path PROCESSORS = Path.of("/proc/cpuinfo");

  private Machine() {}

  /** Returns the version that takes part in every result. */
  public static String solverVersion() {
    return "solver " + SolverVersion.CURRENT;
  }

  /** Returns date, machine and versions, one per line. */
  public static List<String> facts() {
    Runtime runtime = Runtime.getRuntime();
    return List.of(
        LocalDate.now(ZoneOffset.UTC).toString(),
        processor() + ", " + runtime.availableProcessors() + " processors seen",
        System.getProperty("os.name") + " " + System.getProperty("os.arch"),
        System.getProperty("java.vm.name") + " " + System.getProperty("java.runtime.version"),
        solverVersion());
  }

  /** Returns the processor's name on Linux, its architecture elsewhere. */
  private static String processor() {
    try (Stream<String> lines = Files.lines(PROCESSORS, StandardCharsets.UTF_8)) {
      return lines
          .filter(line -> line.startsWith("model name"))
          .map(line -> line.substring(line.indexOf(':') + 1).strip())
          .findFirst()
          .orElse(System.getProperty("os.arch"));
    } catch (IOException e) {
      return System.getProperty("os.arch");
    }
  }
}
