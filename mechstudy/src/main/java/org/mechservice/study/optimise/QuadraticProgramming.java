package org.mechservice.study.optimise;

import java.util.ArrayList;
import java.util.List;
import java.util.NoSuchElementException;
import org.hipparchus.exception.MathRuntimeException;
import org.hipparchus.linear.Array2DRowRealMatrix;
import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.RealMatrix;
import org.hipparchus.linear.RealVector;
import org.hipparchus.optim.InitialGuess;
import org.hipparchus.optim.MaxIter;
import org.hipparchus.optim.OptimizationData;
import org.hipparchus.optim.nonlinear.scalar.ObjectiveFunction;
import org.hipparchus.optim.nonlinear.vector.constrained.EqualityConstraint;
import org.hipparchus.optim.nonlinear.vector.constrained.InequalityConstraint;
import org.hipparchus.optim.nonlinear.vector.constrained.SQPOptimizerGM;
import org.hipparchus.optim.nonlinear.vector.constrained.TwiceDifferentiableFunction;

/**
 * Sequential quadratic programming on the unit cube, with a quasi-Newton matrix (Hipparchus). The
 * bounds are linear constraints. A start where constraints are violated is first moved to where
 * they hold. A search that ends is begun anew at the best point, until that brings nothing more:
 * the quasi-Newton matrix then starts fresh. The library's other method, Schittkowski's, has a
 * subproblem that may never end, and needs more runs.
 */
final class QuadraticProgramming {
  private static final int RESTARTS = 12;
  private static final int ITERATIONS = 200;

  /** Part of the objective's size by which a further search must improve it. */
  private static final double IMPROVEMENT = 1e-10;

  /** By which a constraint shall hold where the search begins, scaled. */
  private static final double MARGIN = 1e-3;

  private final DesignProblem problem;
  private final Trials trials;
  private final Derivatives derivatives;
  private final int n;
  private final int atMost;
  private final int zero;

  QuadraticProgramming(DesignProblem problem, Trials trials, double step) {
    this.problem = problem;
    this.trials = trials;
    derivatives = trials.slopes(false, step);
    n = problem.variables().size();
    atMost = trials.count(Aim.Kind.AT_MOST_ZERO);
    zero = trials.count(Aim.Kind.ZERO);
  }

  void minimise(double[] start) {
    double[] from = start.clone();
    for (int i = 0; i < RESTARTS; i++) {
      if (!trials.at(from).isFeasible() && !repaired(from)) {
        return;
      }
      Trial before = trials.best().orElseThrow();
      search(from);
      Trial after = trials.best().orElseThrow();
      if (!improved(before, after)) {
        return;
      }
      copy(after, from);
    }
  }

  private void copy(Trial trial, double[] to) {
    for (int j = 0; j < n; j++) {
      to[j] = problem.variables().get(j).part(trial.point()[j]);
    }
  }

  /**
   * Moves a point to where the constraints hold: least squares of what they are violated by.
   * Without such a place nearby the quadratic subproblems have no solution.
   *
   * @param from replaced by the best point that is known
   * @return whether all constraints hold there
   */
  private boolean repaired(double[] from) {
    try {
      new LeastSquares(x -> violations(trials.scaled(x)), this::slopesOfViolations).minimise(from);
    } catch (PointFailedException e) {
      return false;
    }
    Trial best = trials.best().orElseThrow();
    copy(best, from);
    return best.isFeasible();
  }

  /** Returns each constraint by which it is violated, 0 where it holds; scaled. */
  private double[] violations(double[] scaled) {
    double[] by = new double[atMost + zero];
    for (int i = 0; i < by.length; i++) {
      by[i] = i < atMost ? Math.max(0, scaled[1 + i] + MARGIN) : scaled[1 + i];
    }
    return by;
  }

  private double[][] slopesOfViolations(double[] x) throws PointFailedException {
    double[] by = violations(trials.scaled(x));
    double[][] slopes = derivatives.at(x);
    double[][] rows = new double[by.length][];
    for (int i = 0; i < by.length; i++) {
      rows[i] = i < atMost && by[i] == 0 ? new double[n] : slopes[1 + i];
    }
    return rows;
  }

  /** Returns whether a point is better than another by more than rounding. */
  static boolean improved(Trial before, Trial after) {
    return after.isFeasible() != before.isFeasible()
        || before.objective() - after.objective() > IMPROVEMENT * Math.abs(after.objective())
        || before.violation() - after.violation() > Trial.FEASIBLE;
  }

  private void search(double[] from) {
    List<OptimizationData> data = new ArrayList<>();
    data.add(new InitialGuess(from));
    data.add(new MaxIter(ITERATIONS));
    data.add(new ObjectiveFunction(new Objective()));
    data.add(new Inequalities());
    if (zero > 0) {
      data.add(new Equalities());
    }
    try {
      new SQPOptimizerGM().optimize(data.toArray(OptimizationData[]::new));
    } catch (MathRuntimeException | NullPointerException | NoSuchElementException e) {
      // The library's quadratic subproblem without a solution ends in a NullPointerException, its
      // first line search, if it fails, in a NoSuchElementException. The search ends where these
      // do; the best point is known.
      return;
    }
  }

  private double[][] slopes(RealVector x) {
    try {
      return derivatives.at(x.toArray());
    } catch (PointFailedException e) {
      return new double[1 + atMost + zero][n];
    }
  }

  private final class Objective extends TwiceDifferentiableFunction {
    @Override
    public int dim() {
      return n;
    }

    @Override
    public double value(RealVector x) {
      return trials.objective(x.toArray());
    }

    @Override
    public RealVector gradient(RealVector x) {
      return new ArrayRealVector(slopes(x)[0], false);
    }

    @Override
    public RealMatrix hessian(RealVector x) {
      throw new UnsupportedOperationException("the method approximates second derivatives");
    }
  }

  /** -g(x) >= 0, x >= 0 and 1 - x >= 0. */
  private final class Inequalities extends InequalityConstraint {
    Inequalities() {
      super(new ArrayRealVector(atMost + 2 * n));
    }

    @Override
    public int dim() {
      return n;
    }

    @Override
    public RealVector value(RealVector x) {
      double[] g = trials.constraints(x.toArray(), Aim.Kind.AT_MOST_ZERO);
      double[] values = new double[atMost + 2 * n];
      for (int i = 0; i < atMost; i++) {
        values[i] = -g[i];
      }
      for (int j = 0; j < n; j++) {
        values[atMost + 2 * j] = x.getEntry(j);
        values[atMost + 2 * j + 1] = 1 - x.getEntry(j);
      }
      return new ArrayRealVector(values, false);
    }

    @Override
    public RealMatrix jacobian(RealVector x) {
      double[][] slopes = slopes(x);
      double[][] rows = new double[atMost + 2 * n][n];
      for (int i = 0; i < atMost; i++) {
        for (int j = 0; j < n; j++) {
          rows[i][j] = -slopes[1 + i][j];
        }
      }
      for (int j = 0; j < n; j++) {
        rows[atMost + 2 * j][j] = 1;
        rows[atMost + 2 * j + 1][j] = -1;
      }
      return new Array2DRowRealMatrix(rows, false);
    }
  }

  /** h(x) = 0. */
  private final class Equalities extends EqualityConstraint {
    Equalities() {
      super(new ArrayRealVector(zero));
    }

    @Override
    public int dim() {
      return n;
    }

    @Override
    public RealVector value(RealVector x) {
      return new ArrayRealVector(trials.constraints(x.toArray(), Aim.Kind.ZERO), false);
    }

    @Override
    public RealMatrix jacobian(RealVector x) {
      double[][] slopes = slopes(x);
      double[][] rows = new double[zero][];
      for (int i = 0; i < zero; i++) {
        rows[i] = slopes[1 + atMost + i];
      }
      return new Array2DRowRealMatrix(rows, false);
    }
  }
}
