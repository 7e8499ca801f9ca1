package org.mechservice.solver.ode.stiff;

import java.util.Optional;
import org.mechservice.solver.ode.BandedSystem;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.LinearisedSystem;
import org.mechservice.solver.ode.ResidualIntegrator;
import org.mechservice.solver.ode.ResidualJacobianSystem;
import org.mechservice.solver.ode.ResidualSystem;
import org.mechservice.solver.ode.SparseSystem;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.backward.BackwardFormulas;
import org.mechservice.solver.ode.newton.Residual;
import org.mechservice.solver.ode.newton.ResidualEquations;
import org.mechservice.solver.ode.newton.ResidualJacobians;
import org.mechservice.solver.ode.newton.ResidualLinearisation;
import org.mechservice.solver.ode.newton.StepEquations;
import org.mechservice.solver.ode.newton.UserLinearisation;
import org.mechservice.solver.ode.step.IntegrationProgress;
import org.mechservice.solver.ode.step.Manifold;

/**
 * ode15sR: the formulas of ode15s for systems in residual form, F(t, y, y') = 0: implicit
 * equations, mass matrices, and differential-algebraic systems of index 1.
 *
 * <p>Differential components are held to max(rtol |y_i|, atol_i) per step; algebraic ones, such as
 * multipliers, are in no test and only have to be finite. ∂F/∂y and ∂F/∂y' are stored apart and
 * kept until an iteration fails with them, so that a change of step or order costs a factorisation
 * of hγ ∂F/∂y + ∂F/∂y' alone. They come from the problem if it is a {@link ResidualJacobianSystem}
 * or, with all linear algebra, if it is a {@link LinearisedSystem}, else from differences: 2n + 1
 * evaluations of F, or n + 1 where only their sum is renewed. For a {@link BandedSystem} n is to be
 * read as the number of its diagonals, and factors and solutions cost in proportion to the number
 * of components; for a {@link SparseSystem} as the number of groups of columns that share no row.
 *
 * <p>A problem starts from consistent values: y'_d and y_a are corrected until F(t0, y0, y'0) = 0,
 * the differential part y_d staying as given. The first step is a tenth of what ode15s would take,
 * and at most a thousandth of the interval. Problems in explicit form are integrated as ode15s
 * does.
 *
 * <p>Orders 1 to 5. Memory: about 165 n numbers of 8 bytes for n unknowns and ten matrices, of n²
 * or of n (l + u + 1) numbers.
 *
 * <p>L. R. Petzold, <i>A description of DASSL</i>, SAND82-8637 (1982); K. E. Brenan, S. L. Campbell
 * and L. R. Petzold, <i>Numerical Solution of Initial-Value Problems in Differential-Algebraic
 * Equations</i>, 1996, ch. 5; L. F. Shampine, <i>Solving 0 = F(t, y(t), y'(t)) in Matlab</i>, J.
 * Numer. Math. 10 (2002) 291.
 */
public final class Ode15sR extends BackwardMethod implements ResidualIntegrator {
  /**
   * Numerical differentiation formulas.
   *
   * @throws IllegalArgumentException if a setting is out of range
   */
  public Ode15sR(IntegratorSettings settings) {
    this(settings, BackwardFormulas.NDF);
  }

  /**
   * @throws IllegalArgumentException if a setting is out of range
   */
  public Ode15sR(IntegratorSettings settings, BackwardFormulas formulas) {
    super(settings, new IntegrationProgress(), formulas, false);
  }

  /**
   * {@inheritDoc}
   *
   * @throws IllegalArgumentException also if a component is declared {@link
   *     ResidualSystem.Component#ALGEBRAIC} although its derivative appears in F; not looked for in
   *     a {@link LinearisedSystem}
   */
  @Override
  public StepResult start(
      ResidualSystem system, double t0, double[] y0, double[] yDot0, double tEnd) {
    IntegratorSettings.requireUsable(t0, tEnd, y0, system.dimension());
    IntegratorSettings.requireUsableDerivative(yDot0, system.dimension());
    return begin(implicit(system, yDot0, t0, tEnd), t0, y0, tEnd);
  }

  private StepEquations implicit(ResidualSystem system, double[] yDot0, double t0, double tEnd) {
    Residual residual = new Residual(system, new Manifold(system), settings.stop());
    residual.breakpoints().begin(system, t0, tEnd);
    Optional<LinearisedSystem> own = system.part(LinearisedSystem.class);
    ResidualLinearisation linearisation =
        own.isPresent()
            ? new UserLinearisation(own.get(), residual)
            : new ResidualJacobians(system, residual, settings.smallSizes(yDot0.length));
    return new ResidualEquations(residual, linearisation, yDot0, tEnd, norm(), settings);
  }

  @Override
  public StepResult resume(ResidualSystem system, byte[] saved) {
    double[] slope = new double[system.dimension()];
    return resume(saved, (t0, tEnd) -> implicit(system, slope, t0, tEnd));
  }
}
