package org.mechservice.solver.closure;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.api.capability.Defects;
import org.mechservice.solver.closure.equations.LoopTerms;
import org.mechservice.solver.dynamics.UserForceSlopes;
import org.mechservice.solver.dynamics.UserLoads;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * Generated terms of a mechanism with loops and user force classes. User forces are evaluated
 * before all terms that depend on forces; their loads follow the model's parameters in the code's
 * inputs. Terms of the loops do not depend on forces.
 */
public class UserForcedTerms implements LoopTerms {
  final UserLoads loads;
  private final LoopTerms generated;

  private UserForcedTerms(LoopTerms generated, UserLoads loads) {
    this.generated = generated;
    this.loads = loads;
  }

  /**
   * Combines generated code with user forces.
   *
   * @param generated of the same mechanism, constructed with {@code inputs}
   * @param inputs what {@link UserLoads#inputs} returned
   * @param userForces creates the user forces
   * @return the terms, including those of the residual and its derivatives if the code has them
   * @throws IllegalArgumentException if a user force cannot be created, or needs an element that
   *     does not exist
   */
  public static LoopTerms of(
      LoopTerms generated, double[] inputs, Mechanism mechanism, UserForceSource userForces) {
    UserLoads loads = new UserLoads(mechanism, userForces, inputs);
    if (generated instanceof OfDerivatives derivatives) {
      return new WithDerivatives(derivatives, loads);
    }
    return generated instanceof OfResidual residual
        ? new WithResidual(residual, loads)
        : new UserForcedTerms(generated, loads);
  }

  @Override
  public final Optional<OfPoses> poses() {
    return generated.poses();
  }

  @Override
  public final void loops(double t, double[] y, double[] terms) {
    generated.loops(t, y, terms);
  }

  /** {@inheritDoc} No term is written if a user force is not finite. */
  @Override
  public final int equations(double t, double[] y, double[] terms) {
    int loaded = loads.evaluate(t, y);
    return loaded == REGULAR ? generated.equations(t, y, terms) : loaded;
  }

  @Override
  public final void further(double t, double[] y, double[] rates) {
    generated.further(t, y, rates);
  }

  /** {@inheritDoc} User forces have no potential energy. */
  @Override
  public final void energy(double t, double[] y, double[] energy) {
    generated.energy(t, y, energy);
  }

  @Override
  public final void power(double t, double[] y, double[] power) {
    generated.power(t, y, power);
    loads.evaluate(t, y);
    power[0] += loads.forces().power();
    power[1] += loads.forces().turnover();
  }

  /** The same with the terms of the recursive residual. */
  private static class WithResidual extends UserForcedTerms implements LoopTerms.OfResidual {
    private final LoopTerms.OfResidual generated;

    WithResidual(LoopTerms.OfResidual generated, UserLoads loads) {
      super(generated, loads);
      this.generated = generated;
    }

    @Override
    public final void offset(double t, double[] y, double[] terms) {
      generated.offset(t, y, terms);
    }

    @Override
    public final int residual(double t, double[] y, double[] a, double[] residual) {
      int loaded = loads.evaluate(t, y);
      return loaded == REGULAR ? generated.residual(t, y, a, residual) : loaded;
    }
  }

  /** The same with its derivatives. */
  private static final class WithDerivatives extends WithResidual
      implements LoopTerms.OfDerivatives {
    private final LoopTerms.OfDerivatives generated;
    private final UserForceSlopes slopes;

    WithDerivatives(LoopTerms.OfDerivatives generated, UserLoads loads) {
      super(generated, loads);
      this.generated = generated;
      slopes = new UserForceSlopes(loads);
    }

    /**
     * {@inheritDoc} Generated code does not write the entries that only user forces contribute to.
     */
    @Override
    public int derivatives(
        double t, double[] y, double[] a, double[] lambda, double[] derivatives) {
      int loaded = loads.evaluate(t, y);
      if (loaded != REGULAR) {
        return loaded;
      }
      Arrays.fill(derivatives, 0);
      int result = generated.derivatives(t, y, a, lambda, derivatives);
      if (result != REGULAR) {
        return result;
      }
      return slopes.addTo(t, derivatives) ? REGULAR : Defects.DEFECT;
    }
  }
}
