package org.mechservice.solver.analysis;

import org.mechservice.solver.analysis.equation.Linearisation;
import org.mechservice.solver.analysis.equation.RestingLinks;
import org.mechservice.solver.linear.Cholesky;

/** The forms m M + c C + k K of small motions about an equilibrium, in any coordinates of them. */
interface MotionForms {
  /** Returns the number of coordinates. */
  int size();

  /** Returns whether M, C and K are symmetric. */
  boolean isSymmetric();

  /** Returns whether C has an element that is not zero. */
  boolean isDamped();

  /** Factors a form; returns whether it is positive definite along the free directions. */
  boolean factor(double mass, double damping, double stiffness);

  /**
   * Solves with the last factors, in the free directions.
   *
   * @param x right-hand side; overwritten
   */
  void solve(double[] x);

  /**
   * Writes the product of a form.
   *
   * @param x displacements in the free directions; not modified
   * @param out forces; overwritten
   */
  void multiply(double mass, double damping, double stiffness, double[] x, double[] out);

  /** Returns the forms of matrices in the free directions. */
  static MotionForms of(Linearisation linear) {
    return new Dense(linear);
  }

  /** Returns the forms that links keep, evaluated at the state of an equilibrium. */
  static MotionForms of(RestingLinks links) {
    return new ByLinks(links);
  }

  /** Forms of dense matrices. */
  final class Dense implements MotionForms {
    /**
     * Elements that differ from those across by less than this part of the largest are symmetric.
     */
    private static final double SYMMETRIC = 1e-9;

    private final int f;
    private final double[] mass;
    private final double[] damping;
    private final double[] stiffness;
    private final Cholesky cholesky;

    private Dense(Linearisation linear) {
      f = linear.freedom();
      mass = linear.mass;
      damping = linear.damping;
      stiffness = linear.stiffness;
      cholesky = new Cholesky(f);
    }

    @Override
    public int size() {
      return f;
    }

    @Override
    public boolean isSymmetric() {
      return isSymmetric(mass) && isSymmetric(stiffness) && isSymmetric(damping);
    }

    private boolean isSymmetric(double[] matrix) {
      double largest = 0;
      double across = 0;
      for (int i = 0; i < f; i++) {
        for (int j = 0; j <= i; j++) {
          largest = Math.max(largest, Math.abs(matrix[i * f + j]));
          across = Math.max(across, Math.abs(matrix[i * f + j] - matrix[j * f + i]));
        }
      }
      return across <= SYMMETRIC * largest;
    }

    @Override
    public boolean isDamped() {
      for (double element : damping) {
        if (element != 0) {
          return true;
        }
      }
      return false;
    }

    @Override
    public boolean factor(double m, double c, double k) {
      double[] sum = new double[f * f];
      for (int i = 0; i < sum.length; i++) {
        sum[i] = m * mass[i] + c * damping[i] + k * stiffness[i];
      }
      return cholesky.factor(sum) == Cholesky.POSITIVE_DEFINITE;
    }

    @Override
    public void solve(double[] x) {
      cholesky.solve(x, 0);
    }

    @Override
    public void multiply(double m, double c, double k, double[] x, double[] out) {
      for (int i = 0; i < f; i++) {
        double sum = 0;
        for (int j = 0; j < f; j++) {
          int e = i * f + j;
          sum += (m * mass[e] + c * damping[e] + k * stiffness[e]) * x[j];
        }
        out[i] = sum;
      }
    }
  }

  /** Forms by links. */
  final class ByLinks implements MotionForms {
    private final RestingLinks links;

    private ByLinks(RestingLinks links) {
      this.links = links;
    }

    @Override
    public int size() {
      return links.size();
    }

    @Override
    public boolean isSymmetric() {
      return links.isStiffnessSymmetric() && links.isDampingSymmetric();
    }

    @Override
    public boolean isDamped() {
      return links.isDamped();
    }

    @Override
    public boolean factor(double m, double c, double k) {
      return links.factor(m, c, k, 0);
    }

    @Override
    public void solve(double[] x) {
      links.solve(x);
    }

    @Override
    public void multiply(double m, double c, double k, double[] x, double[] out) {
      links.multiply(m, c, k, x, out);
    }
  }
}
