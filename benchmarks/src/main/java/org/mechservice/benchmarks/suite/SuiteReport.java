package org.mechservice.benchmarks.suite;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.mechservice.report.measure.Effort;
import org.mechservice.report.measure.ReportProgress;

/** The integrators alone on the suite, peers beside them, as one page. */
public final class SuiteReport {
  private final double[] tolerances;
  private final double limitSeconds;
  private final double peerSeconds;
  private final ReportProgress progress;

  /**
   * @param quick fewer tolerances and shorter limits
   */
  public SuiteReport(boolean quick, ReportProgress progress) {
    tolerances = quick ? new double[] {1e-3, 1e-6, 1e-9} : Effort.powers(3, 12);
    limitSeconds = quick ? 1 : 10;
    peerSeconds = quick ? 1 : 3;
    this.progress = progress;
  }

  /**
   * Runs the suite and writes its page.
   *
   * @throws IOException if the page cannot be written
   */
  public Path write(Path folder) throws IOException {
    Files.createDirectories(folder);
    List<ProblemFile> problems = ProblemFile.all();
    List<SuiteRun> runs = new ArrayList<>();
    long started = System.nanoTime();
    for (int i = 0; i < problems.size(); i++) {
      ProblemFile problem = problems.get(i);
      double elapsed = (System.nanoTime() - started) * 1e-9;
      double left = i == 0 ? Double.NaN : 2 * elapsed / i * (problems.size() - 0.5 * i);
      progress.at(problem.id, 0.5 * i / problems.size(), left);
      runs.addAll(SuiteRunner.all(problem, tolerances, limitSeconds));
    }
    PythonIntegrators peers =
        PythonIntegrators.of(
            problems, tolerances, peerSeconds, PythonIntegrators.Which.EXPLICIT, progress);
    runs.addAll(peers.runs());
    Path page = folder.resolve("integrators.html");
    Files.writeString(page, SuitePage.of(problems, runs, peers.version()), StandardCharsets.UTF_8);
    List<String> lines = new ArrayList<>(List.of(SuiteRun.HEADER));
    runs.forEach(run -> lines.add(run.line()));
    Files.write(folder.resolve(SuitePage.CSV), lines, StandardCharsets.UTF_8);
    return page;
  }
}
