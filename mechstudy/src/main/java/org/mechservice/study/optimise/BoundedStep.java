package org.mechservice.study.optimise;

import java.util.Arrays;
import org.mechservice.solver.linear.spectrum.SingularValues;

/**
 * Steps of Levenberg and Marquardt inside bounds: the least ‖J p + r‖ with ‖D p‖ ≤ Δ, by the
 * singular values of the triangle R of J = Q R with its columns scaled by D (Moré 1978, §5). What
 * leads across a bound is held at it, and the others are solved for anew, with what is held on the
 * right-hand side.
 *
 * <p>D has the norms of the columns, so that a step is nearly the same in whatever units the
 * variables are. Workspace of one fit.
 */
final class BoundedStep {
  /** Part by which a step may be longer or shorter than its bound (Moré 1978, §5: 0.1). */
  private static final double ABOUT = 0.1;

  /** Part of the largest singular value below which a direction has no effect on the residuals. */
  private static final double NO_EFFECT = 1e-12;

  /**
   * Part of the largest scale that every variable has: one that hardly changes the residuals is not
   * to cross its whole range for them.
   */
  private static final double LEAST_SCALE = 1e-6;

  /** The same below which a variable stays where it is: its column may be rounding. */
  private static final double NO_MOVE = 1e-9;

  private static final int MOST_TRIES = 50;

  private final int n;
  private final double[] scale;
  private double least = 1;
  private double[][] triangle = {};
  private double[] right = {};

  BoundedStep(int n) {
    this.n = n;
    scale = new double[n];
  }

  /**
   * Takes the residuals and their derivatives at a point.
   *
   * @param factors of J and r there; kept, not modified
   */
  void at(TallFactors factors) {
    triangle = factors.triangle();
    right = factors.right();
    double largest = 0;
    for (int j = 0; j < n; j++) {
      double sum = 0;
      for (int i = 0; i <= j; i++) {
        sum += triangle[i][j] * triangle[i][j];
      }
      // a scale that never falls makes the bounds of steps shrink only for a reason
      scale[j] = Math.max(scale[j], Math.sqrt(sum));
      largest = Math.max(largest, scale[j]);
    }
    least = largest > 0 ? LEAST_SCALE * largest : 1;
  }

  /** Returns ‖D p‖. */
  double length(double[] p) {
    double sum = 0;
    for (int j = 0; j < n; j++) {
      sum += scaled(j) * p[j] * scaled(j) * p[j];
    }
    return Math.sqrt(sum);
  }

  private double scaled(int j) {
    return Math.max(scale[j], least);
  }

  /** Returns the derivative of half the sum of squares by a variable. */
  double slope(int j) {
    double sum = 0;
    for (int i = 0; i <= j; i++) {
      sum += triangle[i][j] * right[i];
    }
    return sum;
  }

  /** Returns by how much a step lowers the sum of squares if the residuals are linear. */
  double gain(double[] p) {
    double gain = 0;
    for (int i = 0; i < n; i++) {
      double move = 0;
      for (int j = i; j < n; j++) {
        move += triangle[i][j] * p[j];
      }
      gain -= move * (2 * right[i] + move);
    }
    return gain;
  }

  /**
   * Returns the step from a point of the unit cube that stays in it.
   *
   * @param radius Δ
   */
  double[] from(double[] x, double radius) {
    boolean[] held = new boolean[n];
    for (int j = 0; j < n; j++) {
      double slope = slope(j);
      held[j] =
          (x[j] <= 0 && slope > 0)
              || (x[j] >= 1 && slope < 0)
              || scale[j] <= NO_MOVE / LEAST_SCALE * least;
    }
    double[] p = new double[n];
    while (true) {
      int[] free = free(held);
      if (free.length == 0) {
        return p;
      }
      double[] part = solved(free, p, radius);
      boolean crossed = false;
      for (int k = 0; k < free.length; k++) {
        int j = free[k];
        double to = x[j] + part[k] / scaled(j);
        p[j] = Math.max(0, Math.min(1, to)) - x[j];
        if (to < 0 || to > 1) {
          held[j] = true;
          crossed = true;
        }
      }
      if (!crossed) {
        return p;
      }
      for (int j : free) {
        p[j] = held[j] ? p[j] : 0;
      }
    }
  }

  private int[] free(boolean[] held) {
    int[] free = new int[n];
    int count = 0;
    for (int j = 0; j < n; j++) {
      if (!held[j]) {
        free[count++] = j;
      }
    }
    return Arrays.copyOf(free, count);
  }

  /** Returns D p of the free variables, with the steps of the others given. */
  private double[] solved(int[] free, double[] given, double radius) {
    int k = free.length;
    double[] matrix = new double[n * k];
    double[] b = new double[n];
    for (int i = 0; i < n; i++) {
      b[i] = -right[i];
      for (int j = i; j < n; j++) {
        b[i] -= triangle[i][j] * given[j];
      }
      for (int c = 0; c < k; c++) {
        matrix[i * k + c] = triangle[i][free[c]] / scaled(free[c]);
      }
    }
    SingularValues values = new SingularValues(n, k);
    values.decompose(matrix);
    int rank = 0;
    while (rank < k && values.value(rank) > NO_EFFECT * values.value(0)) {
      rank++;
    }
    double[] q = new double[k];
    values.solve(rank, b, q);
    double length = norm(q);
    if (length <= (1 + ABOUT) * radius) {
      return q;
    }
    // 1/‖q‖ grows nearly linearly with the damping μ (Hebden): secants, in an interval
    double low = 0;
    double atLow = 1 / length;
    double high = values.value(0) * norm(b) / radius;
    double damping = Math.min(high, values.value(0) * values.value(0) * 1e-3);
    for (int tries = 0; tries < MOST_TRIES; tries++) {
      values.solveDamped(damping, b, q);
      length = norm(q);
      if (Math.abs(length - radius) <= ABOUT * radius) {
        return q;
      }
      double next = low + (1 / radius - atLow) * (damping - low) / (1 / length - atLow);
      if (length > radius) {
        low = damping;
        atLow = 1 / length;
      } else {
        high = damping;
      }
      damping = next > low && next < high ? next : 0.5 * (low + high);
    }
    return q;
  }

  static double norm(double[] vector) {
    double sum = 0;
    for (double each : vector) {
      sum += each * each;
    }
    return Math.sqrt(sum);
  }
}
