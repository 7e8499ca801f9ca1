package org.mechservice.solver.force.applied;

import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.force.ForceElement;

/** A force along one coordinate of a tree joint, given by a scalar law. */
public final class CoordinateForce extends AppliedForce {
  private final TreeMotion motion;
  private final TreeCoordinate coordinate;
  private final ScalarLaw law;
  private double position;
  private double velocity;

  /**
   * @param coordinate has a velocity; if it has no position, the law must not depend on the
   *     position
   */
  public CoordinateForce(
      ForceElement element, TreeMotion motion, TreeCoordinate coordinate, ScalarLaw law) {
    super(element);
    this.motion = motion;
    this.coordinate = coordinate;
    this.law = law;
  }

  @Override
  public boolean parameters(double[] values) {
    return law.parameters(values, this);
  }

  @Override
  public boolean apply(double t, double[] wrench, double[] tau) {
    position = coordinate.position() < 0 ? 0 : motion.q[coordinate.position()];
    velocity = motion.v[coordinate.velocity()];
    law.evaluate(position, velocity);
    if (!Double.isFinite(law.force())) {
      return notFinite("joint force", law.force());
    }
    tau[coordinate.velocity()] += law.force();
    return true;
  }

  @Override
  public boolean linearise(double t, ForceJacobian sink) {
    double sum = law.byPosition() + law.byVelocity();
    if (!Double.isFinite(sum)) {
      return notFinite("derivative", sum);
    }
    int at = coordinate.velocity();
    sink.forceByCoordinate(at, at, law.byPosition(), law.byVelocity());
    return true;
  }

  @Override
  public double potentialEnergy() {
    return law.potentialEnergy(position);
  }

  @Override
  public double power() {
    return law.force() * velocity + law.energyRate(velocity);
  }

  @Override
  public void values(double[] out, int at) {
    out[at] = law.force();
  }

  @Override
  public boolean isLocal() {
    return true;
  }

  @Override
  public void couplings(Couplings couplings) {
    // its only entry is on the diagonal
  }
}
