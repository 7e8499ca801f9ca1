package org.mechservice.solver.force.applied;

import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.force.ForceElement;

/** A force along one coordinate of a tree joint, given by a scalar law. */
public final class CoordinateForce extends AppliedForce {
  private final TreeMotion motion;
  private final TreeCoordinate coordinate;
  private final ScalarLaw law;
  private final double[] slopes = new double[2];
  private double force;

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
    double position = coordinate.position() < 0 ? 0 : motion.q[coordinate.position()];
    force = law.force(position, motion.v[coordinate.velocity()]);
    if (!Double.isFinite(force)) {
      return notFinite("joint force", force);
    }
    tau[coordinate.velocity()] += force;
    return true;
  }

  @Override
  public boolean linearise(double t, ForceJacobian sink) {
    law.slopes(slopes);
    double sum = slopes[0] + slopes[1];
    if (!Double.isFinite(sum)) {
      return notFinite("derivative", sum);
    }
    int at = coordinate.velocity();
    sink.forceByCoordinate(at, at, slopes[0], slopes[1]);
    return true;
  }

  @Override
  public double potentialEnergy() {
    return law.potentialEnergy();
  }

  @Override
  public double power() {
    return law.power();
  }

  @Override
  public void values(double[] out, int at) {
    out[at] = force;
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
