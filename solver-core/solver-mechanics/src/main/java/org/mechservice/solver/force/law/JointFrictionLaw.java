package org.mechservice.solver.force.law;

import java.util.List;
import org.mechservice.solver.force.applied.AppliedForce;
import org.mechservice.solver.force.applied.Coefficients;
import org.mechservice.solver.force.applied.ScalarLaw;
import org.mechservice.solver.mechanism.force.JointFriction;

/** τ = −coulomb v / √(v² + speed²) − viscous v. */
public final class JointFrictionLaw implements ScalarLaw {
  private static final String[] NAMES = {"dry friction", "viscous friction", "friction speed"};

  private final Coefficients coefficients;
  private double force;
  private double byVelocity;

  public JointFrictionLaw(JointFriction element) {
    coefficients =
        new Coefficients(
            element.name(), List.of(element.coulomb(), element.viscous(), element.speed()));
  }

  @Override
  public boolean parameters(double[] values, AppliedForce applied) {
    int bad = coefficients.update(values);
    if (bad >= 0) {
      return applied.refuse(NAMES[bad], coefficients.at(bad), "finite");
    }
    for (int i = 0; i < NAMES.length; i++) {
      if (coefficients.at(i) < 0) {
        return applied.refuse(NAMES[i], coefficients.at(i), "zero or positive");
      }
    }
    if (coefficients.at(0) > 0 && coefficients.at(2) == 0) {
      return applied.refuse(NAMES[2], 0, "positive where there is dry friction");
    }
    return true;
  }

  @Override
  public void evaluate(double position, double velocity) {
    double dry = coefficients.at(0);
    double viscous = coefficients.at(1);
    force = -viscous * velocity;
    byVelocity = -viscous;
    if (dry != 0) {
      double speed = coefficients.at(2);
      double root = Math.sqrt(velocity * velocity + speed * speed);
      double ratio = speed / root;
      force -= dry * (velocity / root);
      byVelocity -= dry * ratio * (ratio / root);
    }
  }

  @Override
  public double force() {
    return force;
  }

  @Override
  public double byPosition() {
    return 0;
  }

  @Override
  public double byVelocity() {
    return byVelocity;
  }

  @Override
  public double potentialEnergy(double position) {
    return 0;
  }

  @Override
  public double energyRate(double velocity) {
    return 0;
  }
}
