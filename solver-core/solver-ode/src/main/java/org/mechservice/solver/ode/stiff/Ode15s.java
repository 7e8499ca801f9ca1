package org.mechservice.solver.ode.stiff;

import org.mechservice.solver.ode.BandedSystem;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.JacobianSystem;
import org.mechservice.solver.ode.SparseSystem;
import org.mechservice.solver.ode.backward.BackwardFormulas;
import org.mechservice.solver.ode.step.IntegrationProgress;

/**
 * ode15s: numerical or backward differentiation formulas of orders 1 to 5 on variable steps, solved
 * by a simplified Newton iteration. The choice for stiff problems.
 *
 * <p>Each component is held to max(rtol |y_i|, atol_i) per step, the steps end at the end of the
 * problem exactly, and no step is longer than a tenth of the interval unless {@link
 * IntegratorSettings#maxStep} says otherwise. A step costs one to four evaluations of f and as many
 * solutions of linear equations; a change of step or order costs a factorisation of I − hγ J. The
 * Jacobian J is kept until an iteration fails with it. It comes from the problem if that is a
 * {@link JacobianSystem}, else from differences, for which atol_i / rtol should be a size of y_i
 * that is small; a {@link BandedSystem} spares the zeros outside of its band, a {@link
 * SparseSystem} evaluations, and zeros of the factors from 100 unknowns on. {@link
 * IntegratorSettings#maxOrder} bounds the order; more than 5 means 5.
 *
 * <p>Errors of stiff steps die out, those of others add up, by hundreds at these orders. Where even
 * the fastest motion of the problem advances little in a step, h ρ(∂f/∂y) &lt; 1, and is no plain
 * decay or growth, a step is therefore held to a hundredth of the tolerances in the standard and
 * the strict mode, and to more of them the better that motion is damped, so that phases that are
 * not stiff keep their digits, too, for about twice the steps.
 *
 * <p>Formulas of orders 3 to 5 are not stable for weakly damped oscillations that are fast compared
 * with the step. In these modes the fastest motion is watched: where it is a damped oscillation,
 * backward differentiation formulas are taken, which are stable for less damping, and of those the
 * orders that let it decay. Other oscillations that are weakly damped may still take many steps.
 *
 * <p>Memory: about 95 n numbers of 8 bytes for n unknowns and four matrices, of n² or of n (l + u +
 * 1) numbers.
 *
 * <p>L. F. Shampine and M. W. Reichelt, <i>The MATLAB ODE Suite</i>, SIAM J. Sci. Comput. 18 (1997)
 * 1; R. W. Klopfenstein, <i>Numerical differentiation formulas for stiff systems of ordinary
 * differential equations</i>, RCA Review 32 (1971) 447.
 */
public final class Ode15s extends BackwardMethod {
  /**
   * Numerical differentiation formulas.
   *
   * @throws IllegalArgumentException if a setting is out of range
   */
  public Ode15s(IntegratorSettings settings) {
    this(settings, BackwardFormulas.NDF);
  }

  /**
   * @throws IllegalArgumentException if a setting is out of range
   */
  public Ode15s(IntegratorSettings settings, BackwardFormulas formulas) {
    super(settings, new IntegrationProgress(), formulas, false);
  }

  /** Takes turns with another that has the same progress. */
  public Ode15s(IntegratorSettings settings, IntegrationProgress progress) {
    super(settings, progress, BackwardFormulas.NDF, true);
  }
}
