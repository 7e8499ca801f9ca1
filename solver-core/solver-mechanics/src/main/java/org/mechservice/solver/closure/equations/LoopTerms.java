package org.mechservice.solver.closure.equations;

import java.util.Optional;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.ExplicitModel;

/**
 * The terms of the equations of one mechanism with loops, M v' + b + Jᵀ λ = τ and Φ(q, t) = 0,
 * evaluated by code generated for it. The closure solves the equations. Workspace of one thread.
 *
 * <p>One array holds all terms. With m loop equations in the order of {@link LoopEquations} and n
 * velocities of the state it contains, in this order:
 *
 * <ul>
 *   <li>Φ, m numbers, m or rad;
 *   <li>Φ' = J v + Φ_t, m numbers;
 *   <li>J by the velocities of the state, m × n row by row;
 *   <li>the sizes of what the equations measure, m numbers; 0 for each constant size;
 *   <li>γ, m numbers: Φ'' if only driven joints accelerate;
 *   <li>b − τ, n numbers, N·m or N;
 *   <li>M, n × n row by row; only the lower triangle and the diagonal are used.
 * </ul>
 *
 * <p>Entries that are zero in every state need not be written. The state y is [q; v] and the
 * further states if there are any, followed by the {@link UnwrappedAngles}, rad, at the last
 * accepted step; present angles are taken on the nearest turn.
 */
public interface LoopTerms {
  /** Result of {@link #equations} if all forces have values. */
  int REGULAR = ExplicitModel.REGULAR;

  /** Returns where J begins. */
  static int jacobianAt(int m) {
    return 2 * m;
  }

  /** Returns where the sizes begin. */
  static int sizeAt(int m, int n) {
    return jacobianAt(m) + m * n;
  }

  /** Returns where γ begins. */
  static int offsetAt(int m, int n) {
    return sizeAt(m, n) + m;
  }

  /** Returns where b − τ begins. */
  static int biasAt(int m, int n) {
    return offsetAt(m, n) + m;
  }

  /** Returns where M begins. */
  static int massAt(int m, int n) {
    return biasAt(m, n) + n;
  }

  /** Returns the length of the array of terms. */
  static int count(int m, int n) {
    return massAt(m, n) + n * n;
  }

  /**
   * Writes Φ, Φ', J and the sizes.
   *
   * @param t time, s
   * @param y state [q; v] and counted angles; need not close the loops; not modified
   * @param terms overwritten
   */
  void loops(double t, double[] y, double[] terms);

  /**
   * Writes all terms.
   *
   * @param t time, s
   * @param y state [q; v] and counted angles; not modified
   * @param terms overwritten
   * @return {@link #REGULAR}, or the result of a force without direction ({@link
   *     org.mechservice.solver.api.capability.DirectedForces})
   */
  int equations(double t, double[] y, double[] terms);

  /**
   * Writes the energies of bodies, rods and springs.
   *
   * @param t time, s
   * @param y state [q; v] and counted angles; not modified
   * @param energy kinetic and potential energy, J; overwritten
   */
  void energy(double t, double[] y, double[] energy);

  /**
   * Writes the power of the forces that have no potential energy.
   *
   * @param t time, s
   * @param y state [q; v] and counted angles; not modified
   * @param power two zeros; overwritten by the sum and the sum of the sizes, W, if there is such a
   *     force
   */
  void power(double t, double[] y, double[] power);

  /**
   * Writes the derivatives of the further states, if the model has any.
   *
   * @param t time, s
   * @param y state [q; v; s] and counted angles; not modified
   * @param rates one number per further state; overwritten
   */
  default void further(double t, double[] y, double[] rates) {}

  /** Returns the code for poses of bodies, if the model has it. */
  default Optional<OfPoses> poses() {
    return this instanceof OfPoses own ? Optional.of(own) : Optional.empty();
  }

  /**
   * Terms of a large mechanism, without a mass matrix. One array holds the terms of the loops: Φ, m
   * numbers; Φ', m numbers; the elements of {@link LoopEquations#jacobian}, of which those of
   * driven joints are not written. All equations must be independent and between two bodies, so
   * that their sizes are constant.
   */
  interface Recursive extends LoopTerms {
    /** Returns where the elements of J begin. */
    static int elementAt(int m) {
      return 2 * m;
    }

    /**
     * Writes the accelerations v' that M v' + b + Jᵀ λ = τ and J v' + γ = 0 give.
     *
     * @param t time, s
     * @param y state [q; v], which closes the loops; not modified
     * @param accelerations n numbers, rad/s² or m/s²; overwritten
     * @return {@link #REGULAR}, or any other number if a force has no direction, a joint moves no
     *     inertia or the equations are dependent
     */
    @Override
    int equations(double t, double[] y, double[] accelerations);
  }

  /** Terms with poses of bodies. */
  interface OfPoses extends LoopTerms {
    /**
     * Writes the numbers of {@link BodyPoses}, bodies in file order, except that e0 may be
     * negative.
     *
     * @param t time, s
     * @param y state [q; v]; not modified
     * @param poses overwritten
     */
    void poses(double t, double[] y, double[] poses);
  }

  /** Terms with the recursive residual. */
  interface OfResidual extends LoopTerms {
    /**
     * Writes γ.
     *
     * @param t time, s
     * @param y state [q; v] and counted angles; not modified
     * @param terms overwritten
     */
    void offset(double t, double[] y, double[] terms);

    /**
     * Writes M v' + b − τ.
     *
     * @param t time, s
     * @param y state [q; v] and counted angles; not modified
     * @param a accelerations v', n numbers, rad/s² or m/s²; not modified
     * @param residual n numbers, N·m or N; overwritten
     * @return as {@link #equations}
     */
    int residual(double t, double[] y, double[] a, double[] residual);
  }

  /** Terms with the derivatives of the recursive residual. */
  interface OfDerivatives extends OfResidual {
    /**
     * Writes the derivatives of M v' + b − τ + Jᵀ λ by v', v and q, for Euler parameters along the
     * tangent. Entries that are zero in every state need not be written.
     *
     * @param t time, s
     * @param y state [q; v] and counted angles; not modified
     * @param a accelerations v', n numbers, rad/s² or m/s²; not modified
     * @param lambda multipliers λ, m numbers, N or N·m; not modified
     * @param derivatives M, of which only the lower triangle and the diagonal are used, then ∂/∂v,
     *     then ∂/∂q, each n × n row by row; then, if there are further states, the {@link
     *     org.mechservice.solver.dynamics.derivative.FurtherDerivatives}; overwritten
     * @return as {@link #equations}
     */
    int derivatives(double t, double[] y, double[] a, double[] lambda, double[] derivatives);
  }
}
