package org.mechservice.study.optimise;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.apache.commons.math3.random.Well19937c;

/**
 * Finds the best point of a problem from one start or several. The same problem, settings and seed
 * give the same points, whatever the number of threads.
 */
public final class Optimiser {
  private Optimiser() {}

  /**
   * Optimises.
   *
   * @throws IllegalArgumentException if the method does not fit the problem, or it has two
   *     objectives
   * @throws PointFailedException if no start has a single point that could be computed
   * @throws InterruptedException if the thread is interrupted
   */
  public static Optimum minimise(DesignProblem problem, OptimiserSettings settings)
      throws PointFailedException, InterruptedException {
    if (problem.objectives().length > 1) {
      throw new IllegalArgumentException("two objectives have a front, and no optimum");
    }
    Method method = settings.method().chosenFor(problem);
    List<Optimum.Start> starts = new ArrayList<>();
    ExecutorService threads = Executors.newFixedThreadPool(settings.threads());
    try {
      List<Future<Optimum.Start>> running = new ArrayList<>();
      double[][] from = starts(problem, settings);
      for (int k = 0; k < settings.starts(); k++) {
        int number = k + 1;
        running.add(
            threads.submit(() -> start(problem, settings, method, number, from[number - 1])));
      }
      for (Future<Optimum.Start> each : running) {
        starts.add(each.get());
      }
    } catch (ExecutionException e) {
      if (e.getCause() instanceof RuntimeException unexpected) {
        throw unexpected;
      }
      throw new IllegalStateException(String.valueOf(e.getMessage()), e);
    } finally {
      threads.shutdownNow();
    }
    Optional<Trial> best = Optional.empty();
    for (Optimum.Start start : starts) {
      Optional<Trial> its = start.best();
      if (its.isPresent() && (best.isEmpty() || its.get().isBetterThan(best.get()))) {
        best = its;
      }
    }
    if (best.isEmpty() || best.get().failure().isPresent()) {
      throw new PointFailedException(
          starts
              .get(0)
              .ended()
              .or(() -> starts.get(0).best().flatMap(Trial::failure))
              .orElse("no point could be computed"));
    }
    return new Optimum(problem, method, starts, best.get(), promise(problem, settings, best.get()));
  }

  /** Asks linear models at the best point what they promise; empty if there are none. */
  private static OptionalDouble promise(
      DesignProblem problem, OptimiserSettings settings, Trial best) {
    if (problem.composition().isEmpty()) {
      return OptionalDouble.empty();
    }
    int n = problem.variables().size();
    Trials trials = new Trials(problem, best.start(), 3 * n + 1, settings.failedAs());
    double[] parts = new double[n];
    Arrays.setAll(parts, j -> problem.variables().get(j).part(best.point()[j]));
    try {
      return new Minimax(problem, problem.composition().get(), trials, settings.step())
          .promise(parts);
    } catch (PointFailedException | Trials.OutOfRunsException | Trials.StartFailedException e) {
      return OptionalDouble.empty();
    }
  }

  private static double[][] starts(DesignProblem problem, OptimiserSettings settings) {
    Well19937c random = new Well19937c(settings.seed());
    double[][] starts = new double[settings.starts()][];
    starts[0] = problem.start();
    for (int k = 1; k < starts.length; k++) {
      starts[k] = new double[problem.variables().size()];
      for (int j = 0; j < starts[k].length; j++) {
        starts[k][j] = random.nextDouble();
      }
    }
    return starts;
  }

  private static Optimum.Start start(
      DesignProblem problem, OptimiserSettings settings, Method method, int number, double[] from) {
    Trials trials = new Trials(problem, number, settings.mostRuns(), settings.failedAs());
    Optional<String> ended = Optional.empty();
    try {
      switch (method) {
        case LM -> leastSquares(trials, settings.step(), from);
        case SQP -> quadratic(problem, trials, settings.step(), from);
        case BOBYQA, CMAES ->
            new AugmentedLagrangian(trials, method, settings.seed() + 1000L * number)
                .minimise(from);
        case AUTO -> throw new IllegalStateException("a method was chosen before");
      }
    } catch (Trials.OutOfRunsException | Trials.StartFailedException e) {
      ended = Optional.of(String.valueOf(e.getMessage()));
    }
    return new Optimum.Start(trials.all(), ended);
  }

  /** Smooth steps, then, where extremes make corners, steps along these, as long as both help. */
  private static void quadratic(DesignProblem problem, Trials trials, double step, double[] from) {
    double[] point = from.clone();
    Optional<Trial> before = Optional.empty();
    do {
      before = trials.best();
      new QuadraticProgramming(problem, trials, step).minimise(point);
      if (!problem.hasCorners()) {
        return;
      }
      Trial best = trials.best().orElseThrow();
      Arrays.setAll(point, j -> problem.variables().get(j).part(best.point()[j]));
      try {
        new Minimax(problem, problem.composition().get(), trials, step).minimise(point);
      } catch (PointFailedException e) {
        return;
      }
      Trial corner = trials.best().orElseThrow();
      Arrays.setAll(point, j -> problem.variables().get(j).part(corner.point()[j]));
    } while (before.isEmpty() || QuadraticProgramming.improved(before.get(), trials.best().get()));
  }

  private static void leastSquares(Trials trials, double step, double[] from) {
    try {
      new LeastSquares(trials::residuals, trials.slopes(true, step)).minimise(from);
    } catch (PointFailedException e) {
      throw new Trials.StartFailedException(
          "Levenberg-Marquardt cannot pass a point that fails: " + e.getMessage());
    }
  }
}
