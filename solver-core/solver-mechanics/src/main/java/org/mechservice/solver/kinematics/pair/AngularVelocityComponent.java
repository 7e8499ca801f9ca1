package org.mechservice.solver.kinematics.pair;

/**
 * A component of the relative angular velocity in A's axes: a rate that is the derivative of no
 * coordinate. Its value as a position is not defined.
 */
final class AngularVelocityComponent extends PairFunction {
  private final int axis;

  AngularVelocityComponent(String label, int axis) {
    super(label);
    this.axis = axis;
    gradient[axis] = 1;
  }

  @Override
  public <T> T as(PairForms<T> forms) {
    return forms.angularVelocity(axis);
  }

  @Override
  public boolean isLength() {
    return false;
  }

  @Override
  public double evaluate(RelativeMotion r) {
    return Double.NaN;
  }

  @Override
  public void addCurvature(RelativeMotion r, double factor, double[] c) {}
}
