package org.mechservice.benchmarks.paper;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import org.mechservice.report.measure.EqualError;
import org.mechservice.report.measure.MeasuredRun;
import org.mechservice.report.measure.MethodRunner;
import org.mechservice.report.measure.Point;
import org.mechservice.report.measure.ReportProgress;
import org.mechservice.report.measure.WarmUpRounds;
import org.mechservice.report.method.Candidate;

/**
 * Cost of the explicit method over that of the implicit one, at the same error.
 *
 * @param absolutePart the absolute tolerances of the runs as a part of the relative ones
 * @param ratios one for each error
 */
record EqualErrors(double absolutePart, List<Ratio> ratios) {
  /**
   * Errors are |x − x_ref| / (1 + |x_ref|): with absolute tolerances as large as the relative ones
   * a run weighs what it does as it will be judged.
   */
  static final double AS_JUDGED = 1;

  private static final double[] ERRORS = {1e-4, 1e-6};
  private static final double[] TOLERANCES = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};
  private static final int REPEATS = 11;

  EqualErrors {
    ratios = List.copyOf(ratios);
  }

  /**
   * Costs of the explicit method in those of the implicit one; NaN where one does not reach the
   * error.
   *
   * @param error largest over time
   * @param evaluations of the forces
   * @param seconds warm
   */
  record Ratio(double error, double evaluations, double seconds) {}

  /**
   * Runs both methods in turns at several tolerances.
   *
   * @param runner with that part
   */
  static EqualErrors of(
      double absolutePart,
      MethodRunner runner,
      Candidate explicit,
      Candidate implicit,
      double limitSeconds) {
    List<MeasuredRun> first = new ArrayList<>();
    List<MeasuredRun> second = new ArrayList<>();
    WarmUpRounds.until(
        () ->
            Arrays.stream(TOLERANCES)
                .map(
                    tolerance ->
                        runner.run(explicit, tolerance, 0, limitSeconds).seconds()
                            + runner.run(implicit, tolerance, 0, limitSeconds).seconds())
                .sum(),
        PaperReport.WARM_SECONDS,
        ReportProgress.SILENT,
        0);
    for (int round = 0; round <= REPEATS; round++) {
      for (double tolerance : TOLERANCES) {
        first.add(runner.run(explicit, tolerance, round, limitSeconds));
        second.add(runner.run(implicit, tolerance, round, limitSeconds));
      }
    }
    List<Point> slow = Point.of(first);
    List<Point> fast = Point.of(second);
    List<Ratio> ratios =
        Arrays.stream(ERRORS)
            .mapToObj(
                error ->
                    new Ratio(
                        error,
                        ratio(slow, fast, error, point -> (double) point.first().evaluations()),
                        ratio(slow, fast, error, Point::seconds)))
            .toList();
    return new EqualErrors(absolutePart, ratios);
  }

  private static double ratio(
      List<Point> slow, List<Point> fast, double error, ToDoubleFunction<Point> cost) {
    OptionalDouble above = EqualError.cost(slow, error, cost);
    OptionalDouble below = EqualError.cost(fast, error, cost);
    return above.isPresent() && below.isPresent()
        ? above.getAsDouble() / below.getAsDouble()
        : Double.NaN;
  }
}
