package org.mechservice.solver.closure;

import org.mechservice.solver.dynamics.UserLoads;
import org.mechservice.solver.force.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * Generated terms of the equations of a mechanism with loops and with forces that users have
 * written as classes. Where the terms depend on forces, the classes are called first, and their
 * loads handed to the code as inputs behind the model's parameters; loops know no forces.
 */
public class UserForcedTerms implements LoopTerms {
  final UserLoads loads;
  private final LoopTerms generated;

  private UserForcedTerms(LoopTerms generated, UserLoads loads) {
    this.generated = generated;
    this.loads = loads;
  }

  /**
   * Puts the user's forces to generated code.
   *
   * @param generated of the same mechanism, constructed with {@code inputs}
   * @param inputs what {@link UserLoads#inputs} returned
   * @param userForces makes the forces
   * @return terms of the residual besides, if the code has them
   * @throws IllegalArgumentException if a user force cannot be made, or asks for what is not there
   */
  public static LoopTerms of(
      LoopTerms generated, double[] inputs, Mechanism mechanism, UserForceSource userForces) {
    UserLoads loads = new UserLoads(mechanism, userForces, inputs);
    return generated instanceof OfResidual residual
        ? new WithResidual(residual, loads)
        : new UserForcedTerms(generated, loads);
  }

  @Override
  public final void loops(double t, double[] y, double[] terms) {
    generated.loops(t, y, terms);
  }

  /** {@inheritDoc} Where a class gives no finite value, no term is written. */
  @Override
  public final int equations(double t, double[] y, double[] terms) {
    int loaded = loads.evaluate(t, y);
    return loaded == REGULAR ? generated.equations(t, y, terms) : loaded;
  }

  /** {@inheritDoc} Forces written as classes have no potential energy. */
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
  private static final class WithResidual extends UserForcedTerms implements LoopTerms.OfResidual {
    private final LoopTerms.OfResidual generated;

    WithResidual(LoopTerms.OfResidual generated, UserLoads loads) {
      super(generated, loads);
      this.generated = generated;
    }

    @Override
    public void offset(double t, double[] y, double[] terms) {
      generated.offset(t, y, terms);
    }

    @Override
    public int residual(double t, double[] y, double[] a, double[] residual) {
      int loaded = loads.evaluate(t, y);
      return loaded == REGULAR ? generated.residual(t, y, a, residual) : loaded;
    }
  }
}
