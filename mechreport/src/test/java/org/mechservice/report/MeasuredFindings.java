package org.mechservice.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.report.measure.Campaign;
import org.mechservice.report.measure.Effort;
import org.mechservice.report.measure.MeasurementFile;
import org.mechservice.report.measure.MethodRunner;
import org.mechservice.report.measure.Point;
import org.mechservice.report.measure.ReportBudget;
import org.mechservice.report.measure.ReportProgress;
import org.mechservice.report.measure.ReportedScene;
import org.mechservice.report.measure.SceneFindings;
import org.mechservice.report.measure.Spectrum;
import org.mechservice.report.method.Candidate;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.report.solution.Judge;
import org.mechservice.report.solution.StateDistance;

/** Findings of short reports of one method, and of others that differ from them in one thing. */
final class MeasuredFindings {
  static final Effort SHORT =
      new Effort("test", new double[] {1e-3, 1e-5, 1e-7, 1e-9}, 20, 3, 0.1, 20, 0, 0, 60);

  private MeasuredFindings() {}

  /**
   * Measures a method at all tolerances.
   *
   * @param folder for the file of the runs, which is named after the integrator
   * @param spectrum along the run
   */
  static SceneFindings of(
      ReportedScene scene,
      Candidate candidate,
      Judge judge,
      StateDistance distance,
      Optional<Spectrum> spectrum,
      Path folder)
      throws IOException {
    SimulationMethod method = candidate.method();
    try (MeasurementFile journal =
            MeasurementFile.open(folder.resolve(method.integrator() + ".csv"), "test");
        MethodRunner runner =
            new MethodRunner(judge.reference().orElseThrow(), distance, judge.grid())) {
      new Campaign(runner, journal, SHORT, new ReportBudget(60), ReportProgress.SILENT)
          .run(List.of(candidate));
      return new SceneFindings(
          scene,
          List.of(method),
          List.of(),
          judge,
          Point.of(journal.runs()),
          spectrum,
          Map.of(),
          Map.of(),
          SHORT,
          List.of("2000-01-01"),
          List.of());
    }
  }

  /** Returns findings with other methods and points. */
  static SceneFindings with(
      SceneFindings found, List<SimulationMethod> methods, List<Point> points) {
    return with(found, methods, points, found.effort(), found.savings());
  }

  /** Returns findings with other methods and points, of a report that had to save time. */
  static SceneFindings with(
      SceneFindings found,
      List<SimulationMethod> methods,
      List<Point> points,
      Effort effort,
      List<String> savings) {
    return new SceneFindings(
        found.scene(),
        methods,
        found.leftOut(),
        found.judge(),
        points,
        found.spectrum(),
        found.shares(),
        found.freshStarts(),
        effort,
        found.versions(),
        savings);
  }
}
