package org.mechservice.benchmarks.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleSupplier;
import org.mechservice.report.measure.Quantiles;

/**
 * Times of runs after their code is compiled. Every method brings its own copy of the solver's
 * classes, and the virtual machine compiles each copy by what that copy has done: a number of runs
 * that warms a long one leaves a short one cold. So methods warm up for a time, not a number.
 *
 * @param warmSeconds processor time the runs of each method take before any is timed, s
 * @param longSeconds a run that takes this long is timed once, s
 */
record WarmTimes(double warmSeconds, double longSeconds) {

  /**
   * A run that can be repeated.
   *
   * @param method whose code it runs; runs of one method warm each other
   * @param seconds runs it and returns the processor time, s
   */
  record Run(Object method, DoubleSupplier seconds) {}

  /** Runs the runs of all methods in turns until each method is warm. */
  void warm(List<Run> runs) {
    Map<Object, Double> spent = new LinkedHashMap<>();
    List<Run> cold = runs;
    while (!cold.isEmpty()) {
      for (Run run : cold) {
        spent.merge(run.method(), run.seconds().getAsDouble(), Double::sum);
      }
      cold =
          cold.stream().filter(run -> spent.getOrDefault(run.method(), 0.0) < warmSeconds).toList();
    }
  }

  /**
   * Returns the medians of the runs' times, taken in turns, so that what disturbs the machine for a
   * while disturbs all of them, s.
   */
  List<Double> medians(List<Run> runs, int repeats) {
    List<List<Double>> times = new ArrayList<>();
    runs.forEach(run -> times.add(new ArrayList<>()));
    for (int round = 0; round < repeats; round++) {
      for (int i = 0; i < runs.size(); i++) {
        List<Double> before = times.get(i);
        if (before.isEmpty() || before.get(0) < longSeconds) {
          before.add(runs.get(i).seconds().getAsDouble());
        }
      }
    }
    return times.stream()
        .map(taken -> Quantiles.median(taken.stream().mapToDouble(Double::doubleValue).toArray()))
        .toList();
  }
}
