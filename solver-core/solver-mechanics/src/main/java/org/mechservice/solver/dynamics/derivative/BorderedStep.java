package org.mechservice.solver.dynamics.derivative;

import java.util.Arrays;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;

/**
 * The linear equations of an implicit step with further states s, s' = f(t, q, v, s). They border
 * those of the mechanism, A z = r, where A = hγ ∂F/∂y + ∂F/∂y':
 *
 * <pre>
 * A z + hγ B s = r,  −hγ C z + (1 − hγ D) s = r_s
 * </pre>
 *
 * <p>with B = ∂F/∂s, C = ∂f/∂(q, v) and D = ∂f/∂s. The block elimination uses the solver of A, with
 * one solution more for each state at a factorisation and one more at a solution. Workspace of one
 * thread.
 */
public final class BorderedStep {
  private final Inner linear;
  private final Inner corrected;
  private final StateCoordinates coordinates;
  private final FurtherDerivatives further;
  private final int nq;
  private final int nv;
  private final int ns;
  private final DenseLu lu;

  /** 1 − hγ D + hγ² C A⁻¹ B. */
  private final double[] matrix;

  private final double[] q;
  private final double[] tangent;
  private final double[] states;
  private final double[] work;
  private double hGamma;
  private int singular;

  /** Solves the equations of the mechanism, A z = r. */
  @FunctionalInterface
  public interface Inner {
    /**
     * Solves.
     *
     * @param r right-hand side at entry, solution at return; numbers of further states are left
     *     alone
     */
    void solve(double[] r);
  }

  /**
   * Makes a workspace for derivatives that are evaluated elsewhere.
   *
   * @param inner solves A z = r
   */
  public BorderedStep(StateCoordinates coordinates, FurtherDerivatives further, Inner inner) {
    this(
        coordinates,
        further,
        coordinates.positionCount() + coordinates.velocityCount() + further.count(),
        inner,
        inner);
  }

  /**
   * Makes a workspace for a solver that corrects its solution.
   *
   * @param unknowns length of right-hand sides
   * @param linear solves A z = r
   * @param corrected solves A z = r, and may correct z beyond the linear equations
   */
  public BorderedStep(
      StateCoordinates coordinates,
      FurtherDerivatives further,
      int unknowns,
      Inner linear,
      Inner corrected) {
    this.linear = linear;
    this.corrected = corrected;
    this.coordinates = coordinates;
    this.further = further;
    nq = coordinates.positionCount();
    nv = coordinates.velocityCount();
    ns = further.count();
    lu = new DenseLu(ns);
    matrix = new double[ns * ns];
    q = new double[nq];
    tangent = new double[nv];
    states = new double[ns];
    work = new double[ns == 0 ? 0 : unknowns];
  }

  /** Sets the state of the derivatives: y = [q; v; s], not modified. */
  public void setState(double[] y) {
    System.arraycopy(y, 0, q, 0, nq);
  }

  /**
   * Factors, after A has been factored.
   *
   * @param step hγ, s
   * @return whether the matrix is regular
   */
  public boolean factor(double step) {
    hGamma = step;
    if (ns == 0) {
      return true;
    }
    for (int k = 0; k < ns; k++) {
      Arrays.fill(work, 0);
      for (int i = 0; i < nv; i++) {
        work[nq + i] = hGamma * further.forces[i * ns + k];
      }
      linear.solve(work);
      formTangent(work);
      for (int i = 0; i < ns; i++) {
        matrix[i * ns + k] =
            (i == k ? 1 : 0) - hGamma * further.byState[i * ns + k] + hGamma * slope(i, work);
      }
    }
    int column = lu.factor(matrix);
    singular = column == LinearSolver.NONSINGULAR ? 0 : column;
    return column == LinearSolver.NONSINGULAR;
  }

  /** Returns the unknown at whose column the last {@link #factor} failed. */
  public int singularUnknown() {
    return nq + nv + singular;
  }

  /**
   * Solves with the last factors.
   *
   * @param r right-hand side at entry, solution at return
   */
  public void solve(double[] r) {
    if (ns == 0) {
      corrected.solve(r);
      return;
    }
    System.arraycopy(r, 0, work, 0, r.length);
    linear.solve(work);
    formTangent(work);
    for (int i = 0; i < ns; i++) {
      states[i] = r[nq + nv + i] + hGamma * slope(i, work);
    }
    lu.solve(states);
    for (int i = 0; i < nv; i++) {
      double sum = 0;
      for (int k = 0; k < ns; k++) {
        sum += further.forces[i * ns + k] * states[k];
      }
      r[nq + i] -= hGamma * sum;
    }
    corrected.solve(r);
    System.arraycopy(states, 0, r, nq + nv, ns);
  }

  /** Returns a row of C z, after {@link #formTangent}. */
  private double slope(int row, double[] z) {
    double sum = 0;
    for (int j = 0; j < nv; j++) {
      sum += further.byPlace[row * nv + j] * tangent[j];
      sum += further.byVelocity[row * nv + j] * z[nq + j];
    }
    return sum;
  }

  private void formTangent(double[] z) {
    coordinates.tangent(q, z, tangent);
  }
}
