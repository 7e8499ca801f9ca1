package org.mechservice.solver.force.law;

import java.util.Arrays;
import org.mechservice.solver.force.applied.AppliedForce;
import org.mechservice.solver.force.applied.FrameLaw;
import org.mechservice.solver.force.applied.FrameMotion;
import org.mechservice.solver.force.applied.ScalarLaw;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.kinematics.pair.CutJoint;
import org.mechservice.solver.kinematics.pair.PairFunction;

/**
 * A law of one coordinate of a cut joint, which acts on the two bodies along the coordinate's
 * gradient g: w = τ g, ẋ = g · twist, and g changes by its curvature.
 */
public final class CutCoordinateLaw implements FrameLaw {
  private final TreeMotion motion;
  private final CutJoint cut;
  private final PairFunction function;
  private final ScalarLaw law;
  private final double[] curvature = new double[36];

  /**
   * Index in {@link TreeMotion#counted} of the position at the last accepted step; an angle is
   * taken on the nearest turn.
   */
  private final int reference;

  private double position;
  private double velocity;

  public CutCoordinateLaw(
      TreeMotion motion, CutJoint cut, PairFunction function, double start, ScalarLaw law) {
    this.motion = motion;
    this.cut = cut;
    this.function = function;
    this.law = law;
    reference = motion.counted.add(start);
  }

  @Override
  public boolean parameters(double[] values, AppliedForce force) {
    return law.parameters(values, force);
  }

  @Override
  public boolean wrench(FrameMotion x, double[] w, AppliedForce force) {
    cut.relative().place(motion);
    double found = function.evaluate(cut.relative());
    double before = motion.counted.get(reference);
    position = before + function.difference(found, before);
    velocity = 0;
    for (int i = 0; i < 6; i++) {
      velocity += function.gradient[i] * x.twist[i];
    }
    law.evaluate(position, velocity);
    for (int i = 0; i < 6; i++) {
      w[i] = law.force() * function.gradient[i];
    }
    return true;
  }

  @Override
  public void jacobian(FrameMotion x, double[] byPlace, double[] byVelocity) {
    Arrays.fill(curvature, 0);
    function.addCurvature(cut.relative(), 1, curvature);
    double[] g = function.gradient;
    for (int j = 0; j < 6; j++) {
      double velocityByPlace = 0;
      for (int k = 0; k < 6; k++) {
        velocityByPlace += x.twist[k] * curvature[6 * k + j];
      }
      double change = law.byPosition() * g[j] + law.byVelocity() * velocityByPlace;
      for (int i = 0; i < 6; i++) {
        byPlace[6 * i + j] = g[i] * change + law.force() * curvature[6 * i + j];
        byVelocity[6 * i + j] = law.byVelocity() * g[i] * g[j];
      }
    }
  }

  @Override
  public double potentialEnergy(FrameMotion x) {
    return law.potentialEnergy(position);
  }

  @Override
  public double energyRate(FrameMotion x) {
    return law.energyRate(velocity);
  }

  @Override
  public void values(FrameMotion x, double[] out, int at) {
    out[at] = law.force();
  }

  @Override
  public void accepted() {
    motion.counted.set(reference, position);
  }
}
