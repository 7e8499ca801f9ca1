package org.mechservice.report.measure;

import java.io.IOException;
import java.util.List;
import org.mechservice.report.method.Candidate;

/**
 * Runs all methods at all tolerances: {@linkplain FirstRuns first each once} for its error, then in
 * {@linkplain TimedRounds timed rounds}.
 *
 * <p>Both keep the report's {@link ReportBudget}. What is left out says so, and is not written to
 * the file of measurements: a report with more time takes it up.
 */
public final class Campaign {
  /** Beginning of the cause of a run that the report's time did not allow. */
  public static final String LEFT_OUT = "left out: ";

  private final FirstRuns firstRuns;
  private final TimedRounds rounds;

  /**
   * @param budget time of the whole report; runs take part of what is left of it when they begin
   */
  public Campaign(
      MethodRunner runner,
      MeasurementFile journal,
      Effort effort,
      ReportBudget budget,
      ReportProgress progress) {
    firstRuns = new FirstRuns(runner, journal, effort, budget, progress);
    rounds = new TimedRounds(runner, journal, effort, budget, progress);
  }

  /**
   * Runs the points that the file of measurements does not have yet.
   *
   * @return points that the report's time did not allow; they are not in the file
   */
  public List<MeasuredRun> run(List<Candidate> candidates) throws IOException {
    List<MeasuredRun> leftOut = firstRuns.run(candidates);
    rounds.warmUp(candidates, firstRuns.asideOfOne());
    rounds.time(candidates);
    return leftOut;
  }
}
