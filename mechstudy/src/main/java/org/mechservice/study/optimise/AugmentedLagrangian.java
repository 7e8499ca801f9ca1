package org.mechservice.study.optimise;

import java.util.Arrays;
import org.apache.commons.math3.exception.MathIllegalStateException;
import org.apache.commons.math3.optim.InitialGuess;
import org.apache.commons.math3.optim.MaxEval;
import org.apache.commons.math3.optim.SimpleBounds;
import org.apache.commons.math3.optim.nonlinear.scalar.GoalType;
import org.apache.commons.math3.optim.nonlinear.scalar.ObjectiveFunction;
import org.apache.commons.math3.optim.nonlinear.scalar.noderiv.BOBYQAOptimizer;
import org.apache.commons.math3.optim.nonlinear.scalar.noderiv.CMAESOptimizer;
import org.apache.commons.math3.optim.univariate.BrentOptimizer;
import org.apache.commons.math3.optim.univariate.SearchInterval;
import org.apache.commons.math3.optim.univariate.UnivariateObjectiveFunction;
import org.apache.commons.math3.random.Well19937c;

/**
 * Constraints for methods without derivatives: a sequence of problems with bounds only, whose
 * objective f + Σ ρ/2 max(0, g + λ/ρ)² + Σ ρ/2 (h + μ/ρ)² has the constrained minimum of f for its
 * own when the multipliers λ and μ are right (Nocedal and Wright 2006, algorithm 17.4). Without
 * constraints it is one problem. The methods are those of Commons Math.
 */
final class AugmentedLagrangian {
  private static final int ROUNDS = 25;
  private static final double FIRST_WEIGHT = 10;
  private static final double MORE_WEIGHT = 5;
  private static final double MOST_WEIGHT = 1e6;

  /** Violation that must be left of the one before, or the weight grows. */
  private static final double ENOUGH_PROGRESS = 0.25;

  /** Movement of the minimum, on the unit cube, that ends the rounds. */
  private static final double AT_REST = 1e-6;

  /** Of the unit cube: BOBYQA ends with models of this size. */
  private static final double FINEST = 1e-7;

  private static final double FIRST_RADIUS = 0.2;
  private static final double LATER_RADIUS = 0.02;

  /** Evaluations of an evolution strategy without progress that end it, per variable. */
  private static final int STALLED = 120;

  private static final double PROGRESS = 1e-9;

  /** An evolution strategy makes no more progress. */
  private static final class StalledException extends RuntimeException {
    private static final long serialVersionUID = 1L;
  }

  private final Trials trials;
  private final Method method;
  private final long seed;
  private final double[] lambda;
  private final double[] mu;
  private double weight = FIRST_WEIGHT;
  private double least;
  private double[] lowest;
  private int sinceProgress;

  AugmentedLagrangian(Trials trials, Method method, long seed) {
    this.trials = trials;
    this.method = method;
    this.seed = seed;
    lambda = new double[trials.count(Aim.Kind.AT_MOST_ZERO)];
    mu = new double[trials.count(Aim.Kind.ZERO)];
    lowest = new double[0];
  }

  void minimise(double[] start) {
    boolean constrained = lambda.length + mu.length > 0;
    double[] point = start.clone();
    double radius = FIRST_RADIUS;
    double before = Double.POSITIVE_INFINITY;
    for (int round = 0; round < (constrained ? ROUNDS : 1); round++) {
      least = Double.POSITIVE_INFINITY;
      lowest = point.clone();
      sinceProgress = 0;
      try {
        inner(point, radius, seed + round);
      } catch (MathIllegalStateException | StalledException e) {
        // The method has come to the end of its precision; its lowest point is known.
        sinceProgress = 0;
      }
      double moved = 0;
      for (int j = 0; j < point.length; j++) {
        moved = Math.max(moved, Math.abs(lowest[j] - point[j]));
      }
      point = lowest.clone();
      double violation = multiply(point);
      if (violation <= Trial.FEASIBLE && moved <= AT_REST) {
        return;
      }
      if (violation > ENOUGH_PROGRESS * before) {
        weight = Math.min(MOST_WEIGHT, weight * MORE_WEIGHT);
      }
      before = violation;
      radius = LATER_RADIUS;
    }
  }

  /** Corrects the multipliers; returns the largest violation, or of complementarity. */
  private double multiply(double[] point) {
    double[] g = trials.constraints(point, Aim.Kind.AT_MOST_ZERO);
    double[] h = trials.constraints(point, Aim.Kind.ZERO);
    double largest = 0;
    for (int i = 0; i < g.length; i++) {
      largest = Math.max(largest, Math.abs(Math.max(g[i], -lambda[i] / weight)));
      lambda[i] = Math.max(0, lambda[i] + weight * g[i]);
    }
    for (int i = 0; i < h.length; i++) {
      largest = Math.max(largest, Math.abs(h[i]));
      mu[i] += weight * h[i];
    }
    return largest;
  }

  private double value(double[] x) {
    double value = trials.objective(x);
    double[] g = trials.constraints(x, Aim.Kind.AT_MOST_ZERO);
    double[] h = trials.constraints(x, Aim.Kind.ZERO);
    for (int i = 0; i < g.length; i++) {
      double beyond = Math.max(0, g[i] + lambda[i] / weight);
      value += weight / 2 * beyond * beyond;
    }
    for (int i = 0; i < h.length; i++) {
      double beyond = h[i] + mu[i] / weight;
      value += weight / 2 * beyond * beyond;
    }
    sinceProgress++;
    if (value < least) {
      if (least - value > PROGRESS * Math.abs(value)) {
        sinceProgress = 0;
      }
      least = value;
      lowest = x.clone();
    }
    if (method == Method.CMAES && sinceProgress > STALLED * (1 + x.length)) {
      throw new StalledException();
    }
    return value;
  }

  private void inner(double[] start, double radius, long roundSeed) {
    int n = start.length;
    if (method == Method.CMAES) {
      evolve(start, radius, roundSeed);
    } else if (n == 1) {
      double from = radius == FIRST_RADIUS ? 0 : Math.max(0, start[0] - radius);
      double to = radius == FIRST_RADIUS ? 1 : Math.min(1, start[0] + radius);
      value(start);
      new BrentOptimizer(FINEST, FINEST)
          .optimize(
              new MaxEval(Integer.MAX_VALUE),
              GoalType.MINIMIZE,
              new UnivariateObjectiveFunction(x -> value(new double[] {x})),
              new SearchInterval(from, to, Math.max(from, Math.min(to, start[0]))));
    } else {
      new BOBYQAOptimizer(2 * n + 1, radius, FINEST)
          .optimize(
              new MaxEval(Integer.MAX_VALUE),
              GoalType.MINIMIZE,
              new ObjectiveFunction(this::value),
              new InitialGuess(start),
              new SimpleBounds(new double[n], ones(n)));
    }
  }

  private void evolve(double[] start, double radius, long roundSeed) {
    int n = start.length;
    double[] sigma = new double[n];
    Arrays.fill(sigma, radius);
    int population = 4 + (int) (3 * Math.log(n)) + 2;
    new CMAESOptimizer(
            Integer.MAX_VALUE,
            Double.NEGATIVE_INFINITY,
            true,
            0,
            0,
            new Well19937c(roundSeed),
            false,
            null)
        .optimize(
            new MaxEval(Integer.MAX_VALUE),
            GoalType.MINIMIZE,
            new ObjectiveFunction(this::value),
            new InitialGuess(start),
            new CMAESOptimizer.Sigma(sigma),
            new CMAESOptimizer.PopulationSize(population),
            new SimpleBounds(new double[n], ones(n)));
  }

  private static double[] ones(int n) {
    double[] ones = new double[n];
    Arrays.fill(ones, 1);
    return ones;
  }
}
