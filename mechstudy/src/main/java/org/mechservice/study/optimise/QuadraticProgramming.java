package org.mechservice.study.optimise;

import java.util.ArrayList;
import java.util.List;
import org.hipparchus.exception.MathRuntimeException;
import org.hipparchus.linear.Array2DRowRealMatrix;
import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.RealMatrix;
import org.hipparchus.linear.RealVector;
import org.hipparchus.optim.InitialGuess;
import org.hipparchus.optim.MaxIter;
import org.hipparchus.optim.OptimizationData;
import org.hipparchus.optim.nonlinear.scalar.ObjectiveFunction;
import org.hipparchus.optim.nonlinear.vector.constrained.AbstractSQPOptimizer;
import org.hipparchus.optim.nonlinear.vector.constrained.EqualityConstraint;
import org.hipparchus.optim.nonlinear.vector.constrained.InequalityConstraint;
import org.hipparchus.optim.nonlinear.vector.constrained.SQPOptimizerGM;
import org.hipparchus.optim.nonlinear.vector.constrained.SQPOptimizerS;
import org.hipparchus.optim.nonlinear.vector.constrained.TwiceDifferentiableFunction;

/**
 * Sequential quadratic programming on the unit cube, with a quasi-Newton matrix (Hipparchus). The
 * bounds are linear constraints. A search that ends is begun anew at the best point, by
 * Schittkowski's method and by that with Goldfarb's and Idnani's subproblem in turn, until both
 * bring nothing more: the quasi-Newton matrix then starts fresh.
 */
final class QuadraticProgramming {
  private static final int RESTARTS = 12;
  private static final int ITERATIONS = 200;

  /** Part of the objective's size by which a further search must improve it. */
  private static final double IMPROVEMENT = 1e-10;

  private final Trials trials;
  private final Derivatives derivatives;
  private final int n;
  private final int atMost;
  private final int zero;

  QuadraticProgramming(DesignProblem problem, Trials trials, double step) {
    this.trials = trials;
    derivatives = trials.slopes(false, step);
    n = problem.variables().size();
    atMost = trials.count(Aim.Kind.AT_MOST_ZERO);
    zero = trials.count(Aim.Kind.ZERO);
  }

  void minimise(DesignProblem problem, double[] start) {
    double[] from = start.clone();
    int inVain = 0;
    for (int i = 0; i < RESTARTS && inVain < 2; i++) {
      trials.at(from);
      Trial before = trials.best().orElseThrow();
      search(from, i % 2 == 0 ? new SQPOptimizerS() : new SQPOptimizerGM());
      Trial after = trials.best().orElseThrow();
      inVain = improved(before, after) ? 0 : inVain + 1;
      for (int j = 0; j < n; j++) {
        from[j] = problem.variables().get(j).part(after.point()[j]);
      }
    }
  }

  private static boolean improved(Trial before, Trial after) {
    return after.isFeasible() != before.isFeasible()
        || before.objective() - after.objective() > IMPROVEMENT * Math.abs(after.objective())
        || before.violation() - after.violation() > Trial.FEASIBLE;
  }

  private void search(double[] from, AbstractSQPOptimizer method) {
    List<OptimizationData> data = new ArrayList<>();
    data.add(new InitialGuess(from));
    data.add(new MaxIter(ITERATIONS));
    data.add(new ObjectiveFunction(new Objective()));
    data.add(new Inequalities());
    if (zero > 0) {
      data.add(new Equalities());
    }
    try {
      method.optimize(data.toArray(OptimizationData[]::new));
    } catch (MathRuntimeException | NullPointerException e) {
      // The library's quadratic subproblem without a solution ends in a NullPointerException.
      // The search ends where its subproblem or its line search does; the best point is known.
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
