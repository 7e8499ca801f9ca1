package org.mechservice.solver.dynamics;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.Defects;
import org.mechservice.solver.api.capability.DirectedForces;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.PowerInput;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * Generated code combined with user force classes. The forces are evaluated before each evaluation
 * of the code; their loads follow the model's parameters in the code's inputs. Poses that the code
 * does not write come from the motion that the forces read.
 */
public class UserForcedModel
    implements ExplicitModel, Energies, PowerInput, BodyPoses, Defects, DirectedForces {
  final UserLoads loads;
  private final ExplicitModel generated;
  private final List<String> bodies;

  UserForcedModel(ExplicitModel generated, Mechanism mechanism, UserLoads loads) {
    this.generated = generated;
    this.loads = loads;
    bodies = mechanism.bodies().stream().map(Body::name).toList();
  }

  /**
   * Combines generated code with user forces.
   *
   * @param generated of the same mechanism, constructed with {@code inputs}
   * @param inputs what {@link UserLoads#inputs} returned
   * @param userForces creates the user forces
   * @return a model of the same formulation
   * @throws IllegalArgumentException if a user force cannot be created, or needs an element that
   *     does not exist
   */
  public static ExplicitModel of(
      ExplicitModel generated, double[] inputs, Mechanism mechanism, UserForceSource userForces) {
    UserLoads loads = new UserLoads(mechanism, userForces, inputs);
    if (generated instanceof TreeStepModel step) {
      return new UserForcedStepModel(step, mechanism, loads);
    } else if (generated instanceof ResidualModel residual) {
      return new UserForcedResidualModel(residual, mechanism, loads);
    }
    return new UserForcedModel(generated, mechanism, loads);
  }

  @Override
  public final ModelDescription description() {
    return generated.description();
  }

  @Override
  public final boolean hasUserClasses() {
    return true;
  }

  @Override
  public final void initialState(double[] y) {
    generated.initialState(y);
  }

  @Override
  public final int derivative(double t, double[] y, double[] yDot) {
    int loaded = loads.evaluate(t, y);
    return loaded == REGULAR ? generated.derivative(t, y, yDot) : loaded;
  }

  @Override
  public final Defect lastDefect() {
    return loads.defect();
  }

  @Override
  public final String directedForce(int force) {
    return ((DirectedForces) generated).directedForce(force);
  }

  /** {@inheritDoc} A user force gives its own reason. */
  @Override
  public final Optional<Defect> withoutValue(
      double t, double[] y, double[] yDot, List<Failure.Step> tried) {
    return generated instanceof Defects formulas
        ? formulas.withoutValue(t, y, yDot, tried)
        : Optional.empty();
  }

  /** {@inheritDoc} User forces have no potential energy. */
  @Override
  public final void energy(double t, double[] y, double[] energy) {
    ((Energies) generated).energy(t, y, energy);
  }

  @Override
  public final void power(double t, double[] y, double[] power) {
    loads.evaluate(t, y);
    double given = loads.forces().power();
    double turnover = loads.forces().turnover();
    Arrays.fill(power, 0);
    if (generated instanceof PowerInput others) {
      others.power(t, y, power);
    }
    power[0] += given;
    power[1] += turnover;
  }

  @Override
  public final List<String> bodies() {
    return bodies;
  }

  @Override
  public final void poses(double t, double[] y, double[] poses) {
    if (generated instanceof BodyPoses own) {
      own.poses(t, y, poses);
    } else {
      loads.poses(t, y, poses);
    }
  }
}
