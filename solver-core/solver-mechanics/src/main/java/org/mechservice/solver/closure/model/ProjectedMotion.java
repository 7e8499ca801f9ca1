package org.mechservice.solver.closure.model;

import java.util.Arrays;
import org.mechservice.solver.dynamics.tree.TreeSquare;
import org.mechservice.solver.linear.Cholesky;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * The second velocity transformation: accelerations from the equations of motion projected onto the
 * free directions of the loops (docs/theory/loops.md#projection; García de Jalón and Bayo 1994, ch.
 * 5 and 8).
 *
 * <pre>v' = R v_I' + γ̂;  (Rᵀ M R) v_I' = −Rᵀ (b − τ + M γ̂)
 * R = 1 on the independent velocities, −J_D⁻¹ J_I on the dependent ones; γ̂ = −J_D⁻¹ γ there</pre>
 *
 * <p>Workspace of one thread; nothing allocates after construction.
 */
final class ProjectedMotion {
  /** Result of {@link #reduce} if all free directions have inertia. */
  static final int REGULAR = -1;

  private final int n;
  private final int r;
  private final int f;
  private final Partition partition;

  /** R of the dependent velocities, r × f. */
  private final double[] transformation;

  /** γ̂ of the dependent velocities. */
  private final double[] offset;

  /** M_DI + M_DD R_D, r × f. */
  private final double[] carried;

  /** RᵀMR, f × f. */
  private final double[] reduced;

  private final Cholesky factors;
  private final double[] force;
  private final double[] right;
  private final double[] along;
  private final double[] column;

  /** Index of each independent velocity among the independent ones. */
  private final int[] place;

  ProjectedMotion(int velocities, Partition partition) {
    n = velocities;
    this.partition = partition;
    r = partition.rank();
    f = partition.freedom();
    transformation = new double[r * f];
    offset = new double[r];
    carried = new double[r * f];
    reduced = new double[f * f];
    factors = new Cholesky(f);
    force = new double[n];
    right = new double[f];
    along = new double[n];
    column = new double[r];
    place = new int[n];
  }

  /** Forms R; the partition must be factored. */
  void formTransformation(SparseMatrix jacobian) {
    Arrays.fill(transformation, -0.0);
    for (int j = 0; j < f; j++) {
      place[partition.independent[j]] = j;
    }
    for (int i = 0; i < r; i++) {
      int row = partition.kept[i];
      for (int e = jacobian.start[row]; e < jacobian.start[row + 1]; e++) {
        int j = jacobian.column[e];
        if (j < n && partition.isIndependent(j)) {
          transformation[i * f + place[j]] = -jacobian.value[e];
        }
      }
    }
    for (int j = 0; j < f; j++) {
      for (int i = 0; i < r; i++) {
        column[i] = transformation[i * f + j];
      }
      partition.solve(column);
      for (int i = 0; i < r; i++) {
        transformation[i * f + j] = column[i];
      }
    }
  }

  /** Forms and factors Rᵀ M R; returns {@link #REGULAR} or the velocity without inertia. */
  int reduce(double[] mass) {
    int[] d = partition.dependent;
    int[] in = partition.independent;
    for (int i = 0; i < r; i++) {
      for (int j = 0; j < f; j++) {
        double sum = mass[d[i] * n + in[j]];
        for (int k = 0; k < r; k++) {
          sum += mass[d[i] * n + d[k]] * transformation[k * f + j];
        }
        carried[i * f + j] = sum;
      }
    }
    for (int i = 0; i < f; i++) {
      for (int j = 0; j <= i; j++) {
        double sum = mass[in[i] * n + in[j]];
        for (int k = 0; k < r; k++) {
          sum += transformation[k * f + i] * carried[k * f + j];
          sum += mass[d[k] * n + in[i]] * transformation[k * f + j];
        }
        reduced[i * f + j] = sum;
      }
    }
    int singular = factors.factor(reduced);
    return singular == Cholesky.POSITIVE_DEFINITE ? REGULAR : in[singular];
  }

  /**
   * Solves for the accelerations, after {@link #formTransformation} and {@link #reduce}.
   *
   * @param bias b − τ, n numbers
   * @param gamma γ, one number per equation
   * @param a n accelerations from {@code aAt}; overwritten
   */
  void accelerations(double[] mass, double[] bias, double[] gamma, double[] a, int aAt) {
    formOffset(gamma);
    int[] d = partition.dependent;
    for (int i = 0; i < n; i++) {
      double sum = -bias[i];
      for (int k = 0; k < r; k++) {
        sum -= mass[i * n + d[k]] * offset[k];
      }
      force[i] = sum;
    }
    project(force, right);
    factors.solve(right, 0);
    for (int j = 0; j < f; j++) {
      a[aAt + partition.independent[j]] = right[j];
    }
    compose(a, aAt);
  }

  /** Forms γ̂ = −J_D⁻¹ γ. */
  void formOffset(double[] gamma) {
    for (int i = 0; i < r; i++) {
      offset[i] = -gamma[partition.kept[i]];
    }
    partition.solve(offset);
  }

  /** Completes accelerations, x_D = R_D x_I + γ̂. */
  void compose(double[] x, int at) {
    expand(x, at);
    for (int i = 0; i < r; i++) {
      x[at + partition.dependent[i]] += offset[i];
    }
  }

  /** Completes a change in the free directions, x_D = R_D x_I. */
  void expand(double[] x, int at) {
    for (int i = 0; i < r; i++) {
      double sum = 0;
      for (int j = 0; j < f; j++) {
        sum += transformation[i * f + j] * x[at + partition.independent[j]];
      }
      x[at + partition.dependent[i]] = sum;
    }
  }

  /** Writes Rᵀ x. */
  void project(double[] x, double[] projected) {
    for (int j = 0; j < f; j++) {
      double sum = x[partition.independent[j]];
      for (int k = 0; k < r; k++) {
        sum += transformation[k * f + j] * x[partition.dependent[k]];
      }
      projected[j] = sum;
    }
  }

  /** Writes Rᵀ A R, f × f, of an unsymmetric n × n matrix. */
  void reduceSquare(double[] a, double[] product) {
    int[] d = partition.dependent;
    int[] in = partition.independent;
    for (int j = 0; j < f; j++) {
      for (int i = 0; i < n; i++) {
        double sum = a[i * n + in[j]];
        for (int k = 0; k < r; k++) {
          sum += a[i * n + d[k]] * transformation[k * f + j];
        }
        force[i] = sum;
      }
      project(force, right);
      for (int i = 0; i < f; i++) {
        product[i * f + j] = right[i];
      }
    }
  }

  /** Writes Rᵀ A R of a sparse matrix. */
  void reduceSparse(TreeSquare a, double[] product) {
    for (int j = 0; j < f; j++) {
      Arrays.fill(along, 0);
      along[partition.independent[j]] = 1;
      for (int k = 0; k < r; k++) {
        along[partition.dependent[k]] = transformation[k * f + j];
      }
      Arrays.fill(force, 0);
      a.addProduct(1, along, 0, force, 0);
      project(force, right);
      for (int i = 0; i < f; i++) {
        product[i * f + j] = right[i];
      }
    }
  }
}
