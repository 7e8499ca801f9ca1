package org.mechservice.solver.kinematics.pair;

import org.mechservice.solver.spatial.Blocks;
import org.mechservice.solver.spatial.Vector3;

/** The displacement of B's point from A's point along a vector fixed in A. */
final class Displacement extends PairFunction {
  private final Vector3 direction;
  private final double[] axis;

  Displacement(String label, Vector3 axis) {
    super(label);
    direction = axis;
    this.axis = new double[] {axis.x(), axis.y(), axis.z()};
    System.arraycopy(this.axis, 0, gradient, 3, 3);
  }

  @Override
  public <T> T as(PairForms<T> forms) {
    return forms.displacement(direction);
  }

  @Override
  public boolean isLength() {
    return true;
  }

  @Override
  public double evaluate(RelativeMotion r) {
    return Blocks.dot(axis, 0, r.position, 0);
  }

  /** {@inheritDoc} The curvature is zero, because the vector is constant for an observer on A. */
  @Override
  boolean isStraight() {
    return true;
  }

  @Override
  public void addCurvature(RelativeMotion r, double factor, double[] c) {}
}
