package org.mechservice.solver.force.applied;

import java.util.Arrays;
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

  private final double[] slopes = new double[2];
  private double position;
  private double force;

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
  public boolean wrench(FrameMotion x, double[] w, AppliedForce applied) {
    cut.relative().place(motion);
    double found = function.evaluate(cut.relative());
    double before = motion.counted.get(reference);
    position = before + function.difference(found, before);
    double velocity = 0;
    for (int i = 0; i < 6; i++) {
      velocity += function.gradient[i] * x.twist(i);
    }
    force = law.force(position, velocity);
    for (int i = 0; i < 6; i++) {
      w[i] = force * function.gradient[i];
    }
    return true;
  }

  @Override
  public void slopes(FrameMotion x, double[] by) {
    law.slopes(slopes);
    Arrays.fill(curvature, 0);
    function.addCurvature(cut.relative(), 1, curvature);
    double[] g = function.gradient;
    for (int j = 0; j < 6; j++) {
      double velocityByPlace = 0;
      for (int k = 0; k < 6; k++) {
        velocityByPlace += x.twist(k) * curvature[6 * k + j];
      }
      double change = slopes[0] * g[j] + slopes[1] * velocityByPlace;
      for (int i = 0; i < 6; i++) {
        by[6 * i + j] = g[i] * change + force * curvature[6 * i + j];
        by[36 + 6 * i + j] = slopes[1] * g[i] * g[j];
      }
    }
  }

  @Override
  public double potentialEnergy() {
    return law.potentialEnergy();
  }

  @Override
  public double power(FrameMotion x, double[] w) {
    return law.power();
  }

  @Override
  public void values(FrameMotion x, double[] out, int at) {
    out[at] = force;
  }

  @Override
  public void accepted() {
    motion.counted.set(reference, position);
  }
}
