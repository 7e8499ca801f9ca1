package org.mechservice.solver.analysis;

import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.analysis.equation.Linearisation;
import org.mechservice.solver.analysis.equation.RestingLinks;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.linear.Cholesky;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;

/**
 * Residual forces at one state at rest, and the steps that stiffness predicts from it: in dense
 * matrices of the free directions, or by links.
 */
interface RestingStiffness {
  /** Returns the number of residual forces. */
  int count();

  /** Returns the residual force along a direction, N·m or N. */
  double left(int direction);

  /** Returns the velocity whose coordinate a direction moves most of all, or alone. */
  int velocity(int direction);

  /**
   * Solves (K + λD) z = −r with D as the metric says.
   *
   * @param shift λ
   * @param xi displacements of all coordinates; overwritten
   * @return whether the symmetric part of K + λD is positive definite; if not, nothing is written
   */
  boolean solve(double shift, double[] xi);

  /** Returns zᵀ K z of the last solution. */
  double curvature();

  /** Returns notes if this is an equilibrium that is unstable or not isolated. */
  List<Note> judged(double t);

  /** What D is. */
  enum Metric {
    /** Diagonal, with the scales of stiffness and of residual forces. */
    FORCES,
    /** The mass matrix, so that what nothing holds moves as it would from rest. */
    MASS
  }

  /** Returns dense matrices in the free directions at the state of a linearisation. */
  static RestingStiffness dense(EquationsOfMotion equations, Linearisation linear, Metric metric) {
    return new Dense(equations, linear, metric);
  }

  /** Returns matrices by links at the state where they were evaluated last. */
  static RestingStiffness byLinks(EquationsOfMotion equations, RestingLinks links, Metric metric) {
    return new ByLinks(equations, links, metric);
  }

  /** Directions are those of the independent coordinates; D has the scales of K and r. */
  final class Dense implements RestingStiffness {
    /** Smallest element of D, as a fraction of its largest. */
    private static final double LEAST_SCALE = 1e-9;

    private final EquationsOfMotion equations;
    private final Linearisation linear;
    private final Metric metric;
    private final double[] left;
    private final double[] scale;
    private final double[] z;

    private Dense(EquationsOfMotion equations, Linearisation linear, Metric metric) {
      this.equations = equations;
      this.linear = linear;
      this.metric = metric;
      left = new double[linear.freedom()];
      linear.project(equations.residual, left);
      z = new double[linear.freedom()];
      scale = metric == Metric.FORCES ? scale() : leastScale();
    }

    /** Returns what the diagonal of the mass matrix is raised by, where nothing has inertia. */
    private double[] leastScale() {
      int f = linear.freedom();
      double[] scale = new double[f];
      double most = Double.MIN_NORMAL;
      for (int j = 0; j < f; j++) {
        double unit = equations.unit[linear.independent()[j]];
        most = Math.max(most, linear.mass[j * f + j] * unit * unit);
      }
      for (int j = 0; j < f; j++) {
        double unit = equations.unit[linear.independent()[j]];
        scale[j] = LEAST_SCALE * most / (unit * unit);
      }
      return scale;
    }

    @Override
    public int count() {
      return left.length;
    }

    @Override
    public double left(int direction) {
      return left[direction];
    }

    @Override
    public int velocity(int direction) {
      return linear.independent()[direction];
    }

    /** Returns D: the scale of K and of the residual forces for each freedom, N·m or N/m. */
    private double[] scale() {
      int f = linear.freedom();
      double[] scale = new double[f];
      double most = Double.MIN_NORMAL;
      for (int j = 0; j < f; j++) {
        double unit = equations.unit[linear.independent()[j]];
        scale[j] = Math.abs(linear.stiffness[j * f + j]) + Math.abs(left[j]) / unit;
        most = Math.max(most, scale[j] * unit * unit);
      }
      for (int j = 0; j < f; j++) {
        double unit = equations.unit[linear.independent()[j]];
        scale[j] = Math.max(scale[j], LEAST_SCALE * most / (unit * unit));
      }
      return scale;
    }

    @Override
    public boolean solve(double shift, double[] xi) {
      int f = linear.freedom();
      double[] symmetric = new double[f * f];
      double[] matrix = linear.stiffness.clone();
      for (int i = 0; i < f * f && metric == Metric.MASS; i++) {
        matrix[i] += shift * linear.mass[i];
      }
      for (int i = 0; i < f; i++) {
        matrix[i * f + i] += shift * scale[i];
        for (int j = 0; j <= i; j++) {
          symmetric[i * f + j] = 0.5 * (matrix[i * f + j] + matrix[j * f + i]);
        }
      }
      if (new Cholesky(f).factor(symmetric) != Cholesky.POSITIVE_DEFINITE) {
        return false;
      }
      DenseLu lu = new DenseLu(f);
      if (lu.factor(matrix) != LinearSolver.NONSINGULAR) {
        return false;
      }
      for (int j = 0; j < f; j++) {
        z[j] = -left[j];
      }
      lu.solve(z);
      linear.expand(z, xi);
      return true;
    }

    @Override
    public double curvature() {
      double sum = 0;
      for (int i = 0; i < z.length; i++) {
        for (int j = 0; j < z.length; j++) {
          sum += z[i] * linear.stiffness[i * z.length + j] * z[j];
        }
      }
      return sum;
    }

    @Override
    public List<Note> judged(double t) {
      return EquilibriumStability.judged(equations, t, linear);
    }
  }

  /** Directions are those of all coordinates, with the forces of loops in the residual. */
  final class ByLinks implements RestingStiffness {
    private final EquationsOfMotion equations;
    private final RestingLinks links;
    private final Metric metric;
    private final double[] left;
    private final double[] z;
    private final double[] product;

    private ByLinks(EquationsOfMotion equations, RestingLinks links, Metric metric) {
      this.equations = equations;
      this.links = links;
      this.metric = metric;
      left = Arrays.copyOf(equations.residual, equations.nv);
      z = new double[left.length];
      product = new double[left.length];
    }

    @Override
    public int count() {
      return left.length;
    }

    @Override
    public double left(int direction) {
      return left[direction];
    }

    @Override
    public int velocity(int direction) {
      return direction;
    }

    @Override
    public boolean solve(double shift, double[] xi) {
      boolean regular =
          metric == Metric.MASS ? links.factor(shift, 0, 1, 0) : links.factor(0, 0, 1, shift);
      if (!regular) {
        return false;
      }
      for (int j = 0; j < z.length; j++) {
        z[j] = -left[j];
      }
      links.solve(z);
      System.arraycopy(z, 0, xi, 0, z.length);
      return true;
    }

    @Override
    public double curvature() {
      links.multiply(0, 0, 1, z, product);
      double sum = 0;
      for (int i = 0; i < z.length; i++) {
        sum += z[i] * product[i];
      }
      return sum;
    }

    @Override
    public List<Note> judged(double t) {
      return EquilibriumStability.judged(equations, t, links);
    }
  }
}
