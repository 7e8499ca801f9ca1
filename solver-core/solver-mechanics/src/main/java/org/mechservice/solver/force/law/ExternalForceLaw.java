package org.mechservice.solver.force.law;

import org.mechservice.solver.force.applied.AppliedForce;
import org.mechservice.solver.force.applied.ScalarLaw;

/** A force on a coordinate that does not depend on the coordinate itself. */
public final class ExternalForceLaw implements ScalarLaw {
  private double force;

  public void set(double value) {
    force = value;
  }

  @Override
  public boolean parameters(double[] values, AppliedForce applied) {
    return true;
  }

  @Override
  public void evaluate(double position, double velocity) {
    // set from outside
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
    return 0;
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
