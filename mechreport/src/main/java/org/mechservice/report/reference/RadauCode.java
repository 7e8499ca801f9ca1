package org.mechservice.report.reference;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.linear.DenseLayout;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;

/**
 * Radau IIA by collocation with any number of stages, for stiff and nonstiff problems: simplified
 * Newton's iteration on all stages at once, down to rounding, with a Jacobian by differences.
 *
 * <p>Error estimate: the defect of the collocation polynomial at the start of the step, filtered
 * through (1 − h γ J)⁻¹, of order s (Hairer &amp; Wanner II, 1996, §IV.8). The solution is of order
 * 2s − 1, so what a tolerance gives must be seen from two of them.
 */
public final class RadauCode implements ReferenceCode {
  private static final int MOST_ITERATIONS = 40;

  /** Contraction rate above which the Jacobian is evaluated again. */
  private static final double SLOW = 0.1;

  /** The iteration has ended when it moves nothing by more, relative to 1 + |y|. */
  private static final double ROUNDING = 2e-16;

  /** Correction above which an iteration that stalls has failed. */
  private static final double STALLED = 1e-12;

  private final RadauTableau tableau;

  /**
   * @param stages s, from 2
   */
  public RadauCode(int stages) {
    tableau = new RadauTableau(stages);
  }

  @Override
  public String name() {
    return "Radau IIA, " + tableau.stages + " stages, order " + (2 * tableau.stages - 1);
  }

  @Override
  public Optional<double[][]> solve(
      Problem problem, double[] times, double[] y0, double tolerance, long deadline) {
    CompensatedState state = new CompensatedState(y0);
    Solution steps = new Solution(problem, state, tolerance);
    double firstStep = (times[times.length - 1] - times[0]) / 1000;
    return new PhaseIntegration(problem, state, steps, tolerance, deadline)
        .through(times, firstStep);
  }

  /** One problem in progress. */
  private final class Solution implements PhaseIntegration.Steps {
    private final int n;
    private final int s = tableau.stages;
    private final Problem problem;
    private final double tolerance;
    private final CompensatedState state;
    private final double[] start;
    private final double[][] f;
    private final double[][] z;
    private final double[] jacobian;
    private final double[] big;
    private final DenseLu stageLu;
    private final DenseLu filterLu;
    private double factoredStep;
    private boolean jacobianIsNew;

    Solution(Problem problem, CompensatedState state, double tolerance) {
      this.problem = problem;
      this.tolerance = tolerance;
      this.state = state;
      n = state.y.length;
      start = new double[n];
      f = new double[s][n];
      z = new double[s][n];
      jacobian = new double[n * n];
      big = new double[s * n];
      stageLu = new DenseLu(s * n);
      filterLu = new DenseLu(n);
    }

    @Override
    public boolean begin(double t) {
      return formJacobian(t);
    }

    @Override
    public double[] increment() {
      return z[s - 1];
    }

    @Override
    public boolean renew(double t) {
      return !jacobianIsNew && formJacobian(t);
    }

    @Override
    public double next(double step, double error, boolean accepted) {
      if (accepted) {
        jacobianIsNew = false;
        return step * growth(error);
      }
      return step * (Double.isInfinite(error) ? 0.3 : Math.min(0.8, growth(error)));
    }

    private double growth(double error) {
      double factor = 0.9 * Math.pow(tolerance / Math.max(error, 1e-300), 1.0 / (s + 1));
      // Small growth is not worth a factorisation.
      return factor > 1 && factor < 1.3 ? 1 : Math.max(0.2, Math.min(4, factor));
    }

    /** Solves for the stages; returns the weighted error, infinite if they cannot be solved for. */
    @Override
    public double attempt(double t, double step) {
      if (!problem.derivative(t, state.y, start) || !factor(step)) {
        return Double.POSITIVE_INFINITY;
      }
      for (double[] stage : z) {
        Arrays.fill(stage, 0);
      }
      double last = Double.POSITIVE_INFINITY;
      for (int iteration = 0; iteration < MOST_ITERATIONS; iteration++) {
        if (!evaluateStages(t, step)) {
          return Double.POSITIVE_INFINITY;
        }
        double moved = correct(step);
        boolean settled = moved <= ROUNDING || (moved >= 0.5 * last && last <= STALLED);
        if (settled) {
          return evaluateStages(t, step) ? error(step) : Double.POSITIVE_INFINITY;
        }
        boolean slow = iteration > 1 && moved > SLOW * last && !jacobianIsNew && last > STALLED;
        if ((!(moved < last) && last > STALLED) || slow) {
          return Double.POSITIVE_INFINITY;
        }
        last = moved;
      }
      return Double.POSITIVE_INFINITY;
    }

    private boolean evaluateStages(double t, double step) {
      double[] y = new double[n];
      for (int i = 0; i < s; i++) {
        for (int k = 0; k < n; k++) {
          y[k] = state.y[k] + z[i][k];
        }
        if (!problem.derivative(t + tableau.c[i] * step, y, f[i])) {
          return false;
        }
      }
      return true;
    }

    /** One correction of all stages; returns its weighted size. */
    private double correct(double step) {
      for (int i = 0; i < s; i++) {
        for (int k = 0; k < n; k++) {
          double sum = 0;
          for (int j = 0; j < s; j++) {
            sum += tableau.a[i][j] * f[j][k];
          }
          big[i * n + k] = step * sum - z[i][k];
        }
      }
      stageLu.solve(big);
      double moved = 0;
      for (int i = 0; i < s; i++) {
        for (int k = 0; k < n; k++) {
          z[i][k] += big[i * n + k];
          moved = larger(moved, big[i * n + k] / (1 + Math.abs(state.y[k])));
        }
      }
      return moved;
    }

    private double error(double step) {
      double gamma = tableau.c[0];
      double[] defect = new double[n];
      for (int k = 0; k < n; k++) {
        double atStart = 0;
        for (int j = 0; j < s; j++) {
          atStart += tableau.atStart[j] * f[j][k];
        }
        defect[k] = step * gamma * (start[k] - atStart);
      }
      filterLu.solve(defect);
      double error = 0;
      for (int k = 0; k < n; k++) {
        error = larger(error, defect[k] / (1 + Math.abs(state.y[k])));
      }
      return error;
    }

    private boolean formJacobian(double t) {
      double[] y = state.y.clone();
      double[] shifted = new double[n];
      if (!problem.derivative(t, y, start)) {
        return false;
      }
      Arrays.fill(jacobian, 0);
      for (int k = 0; k < n; k++) {
        if (!problem.matters(k)) {
          continue;
        }
        double kept = y[k];
        y[k] = kept + 1.5e-8 * (1 + Math.abs(kept));
        double delta = y[k] - kept;
        if (!problem.derivative(t, y, shifted)) {
          return false;
        }
        for (int i = 0; i < n; i++) {
          jacobian[i * n + k] = (shifted[i] - start[i]) / delta;
        }
        y[k] = kept;
      }
      jacobianIsNew = true;
      factoredStep = 0;
      return true;
    }

    private boolean factor(double step) {
      if (Math.abs(step - factoredStep) <= 1e-12 * step) {
        return true;
      }
      factoredStep = step;
      double[] matrix = new double[stageLu.layout().length()];
      double[] filter = new double[filterLu.layout().length()];
      DenseLayout layout = new DenseLayout(s * n);
      DenseLayout small = new DenseLayout(n);
      for (int row = 0; row < n; row++) {
        for (int column = 0; column < n; column++) {
          double slope = step * jacobian[row * n + column];
          double one = row == column ? 1 : 0;
          filter[small.index(row, column)] = one - tableau.c[0] * slope;
          for (int i = 0; i < s; i++) {
            for (int j = 0; j < s; j++) {
              matrix[layout.index(i * n + row, j * n + column)] =
                  (i == j ? one : 0) - tableau.a[i][j] * slope;
            }
          }
        }
      }
      return stageLu.factor(matrix) == LinearSolver.NONSINGULAR
          && filterLu.factor(filter) == LinearSolver.NONSINGULAR;
    }
  }

  /** The larger modulus; not a number counts as infinite. */
  private static double larger(double a, double b) {
    double size = Math.abs(b);
    return size >= 0 ? Math.max(a, size) : Double.POSITIVE_INFINITY;
  }
}
