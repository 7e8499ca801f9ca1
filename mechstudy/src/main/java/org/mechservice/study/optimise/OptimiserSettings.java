package org.mechservice.study.optimise;

import java.util.OptionalDouble;

/**
 * Settings of an optimisation.
 *
 * @param method how each start goes on
 * @param starts number of starts: the given one, then random ones
 * @param seed of the random starts and of methods that use random numbers
 * @param mostRuns runs that each start may use
 * @param step of differences, as a part of the variables' ranges
 * @param failedAs objective of points that fail; empty to end at the first one
 * @param threads starts at once
 */
public record OptimiserSettings(
    Method method,
    int starts,
    long seed,
    int mostRuns,
    double step,
    OptionalDouble failedAs,
    int threads) {
  /** One start, the method that suits, at most 2000 runs, differences of 1e-4 of the ranges. */
  public static final OptimiserSettings DEFAULT =
      new OptimiserSettings(Method.AUTO, 1, 1, 2000, 1e-4, OptionalDouble.empty(), 1);

  /**
   * @throws IllegalArgumentException if a number is out of its range; says which
   */
  public OptimiserSettings {
    requireAtLeastOne("the number of starts", starts);
    requireAtLeastOne("the number of runs", mostRuns);
    requireAtLeastOne("the number of threads", threads);
    if (!(step > 0 && step <= 0.1)) {
      throw new IllegalArgumentException(
          "the step of differences is " + step + "; it must be more than 0 and at most 0.1");
    }
    if (failedAs.isPresent() && !Double.isFinite(failedAs.getAsDouble())) {
      throw new IllegalArgumentException(
          "the objective of failing points is "
              + failedAs.getAsDouble()
              + "; it must be a finite number");
    }
  }

  private static void requireAtLeastOne(String what, int number) {
    if (number < 1) {
      throw new IllegalArgumentException(what + " is " + number + "; it must be 1 or more");
    }
  }

  /** Returns the settings with another method. */
  public OptimiserSettings with(Method other) {
    return new OptimiserSettings(other, starts, seed, mostRuns, step, failedAs, threads);
  }
}
