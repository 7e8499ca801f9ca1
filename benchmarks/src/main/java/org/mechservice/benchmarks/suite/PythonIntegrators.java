package org.mechservice.benchmarks.suite;

import com.google.gson.Gson;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.mechservice.report.measure.ReportProgress;

/**
 * Integrators of SciPy and SUNDIALS on the same problems, where Python has them. Its equations are
 * evaluated in Python, so only their number is comparable, not the time.
 */
final class PythonIntegrators {
  private static final String SCRIPT = "/org/mechservice/benchmarks/suite/peers.py";

  private static final int FIELDS = 7;

  /** Which integrators are to run. */
  enum Which {
    /** All on explicit problems. */
    EXPLICIT,
    /** CVODE with BDF on explicit problems, IDA on those with algebraic components. */
    STIFF_SUNDIALS
  }

  private final List<SuiteRun> runs = new ArrayList<>();
  private String version = "";

  /** Returns the runs; empty if SciPy is not installed. */
  List<SuiteRun> runs() {
    return runs;
  }

  /** Returns name and version; empty if SciPy is not there. */
  String version() {
    return version;
  }

  /**
   * Runs the peers.
   *
   * @param limit of the processor time of one run, s
   * @param which those of which package
   */
  static PythonIntegrators of(
      List<ProblemFile> problems,
      double[] tolerances,
      double limit,
      Which which,
      ReportProgress progress)
      throws IOException {
    PythonIntegrators peers = new PythonIntegrators();
    Path script = Files.createTempFile("mech-peers", ".py");
    try (InputStream in = PythonIntegrators.class.getResourceAsStream(SCRIPT)) {
      if (in == null) {
        throw new IllegalStateException("resource " + SCRIPT + " is missing");
      }
      Files.write(script, in.readAllBytes());
      peers.run(script, problems, tolerances, limit, which, progress);
    } finally {
      Files.delete(script);
    }
    return peers;
  }

  private void run(
      Path script,
      List<ProblemFile> problems,
      double[] tolerances,
      double limit,
      Which which,
      ReportProgress progress)
      throws IOException {
    Process python;
    try {
      python =
          new ProcessBuilder(
                  "python3",
                  script.toString(),
                  Arrays.stream(tolerances)
                      .mapToObj(Double::toString)
                      .collect(Collectors.joining(",")),
                  Double.toString(limit),
                  which.name())
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
    } catch (IOException e) {
      return;
    }
    try (Writer out = python.outputWriter(StandardCharsets.UTF_8)) {
      out.write(input(problems, which));
    } catch (IOException e) {
      // Without SciPy the script has ended before it read its input; its output then says nothing.
      python.destroy();
    }
    try (BufferedReader in =
        new BufferedReader(
            new InputStreamReader(python.getInputStream(), StandardCharsets.UTF_8))) {
      String first = in.readLine();
      version = first == null ? "" : first;
      long started = System.nanoTime();
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        add(line);
        double done = 1 + order(problems, line);
        double elapsed = (System.nanoTime() - started) * 1e-9;
        progress.at(
            "peers", 0.5 + 0.5 * done / problems.size(), elapsed / done * (problems.size() - done));
      }
    }
  }

  private static int order(List<ProblemFile> problems, String line) {
    int order = 0;
    while (order < problems.size() - 1 && !line.startsWith(problems.get(order).id + ",")) {
      order++;
    }
    return order;
  }

  private void add(String line) {
    String[] fields = line.split(",", FIELDS);
    if (fields.length < FIELDS) {
      // SUNDIALS prints what it fails with by itself; the run's own line tells it, too.
      return;
    }
    runs.add(
        new SuiteRun(
            fields[0],
            fields[1],
            Double.parseDouble(fields[2]),
            Double.parseDouble(fields[3]),
            Long.parseLong(fields[4]),
            Long.parseLong(fields[5]),
            Double.NaN,
            fields[FIELDS - 1]));
  }

  private static String input(List<ProblemFile> problems, Which which) {
    Gson gson = new Gson();
    JsonArray all = new JsonArray();
    for (ProblemFile problem : problems) {
      boolean multipliers = which == Which.STIFF_SUNDIALS && !problem.algebraic.isEmpty();
      if (problem.isExplicit() || multipliers) {
        JsonObject one = gson.toJsonTree(problem).getAsJsonObject();
        one.addProperty("end", new SuiteEquations(problem).number(problem.t1));
        one.add("scored", gson.toJsonTree(problem.scored()));
        all.add(one);
      }
    }
    return gson.toJson(all);
  }
}
