package org.mechservice.solver.kinematics.pair;

import static org.mechservice.solver.spatial.Blocks.apply;

import org.mechservice.solver.spatial.Vector3;

/**
 * The velocity of B's point along a vector d fixed in B, as seen from A: R d · ρ'. It is not the
 * derivative of a function of the pose.
 */
final class EdgeVelocity extends PairFunction {
  private final Vector3 side;
  private final double[] inB;

  EdgeVelocity(String label, Vector3 side) {
    super(label);
    this.side = side;
    inB = new double[] {side.x(), side.y(), side.z()};
    System.arraycopy(inB, 0, gradient, 3, 3);
  }

  @Override
  public <T> T as(PairForms<T> forms) {
    return forms.edgeVelocity(side);
  }

  @Override
  public boolean isHolonomic() {
    return false;
  }

  @Override
  public boolean isLength() {
    return true;
  }

  @Override
  public double evaluate(RelativeMotion r) {
    apply(r.rotation, 0, inB, 0, gradient, 3);
    return 0;
  }

  /** δ(R d) = δθ × R d. */
  @Override
  public void addCurvature(RelativeMotion r, double factor, double[] c) {
    double x = factor * gradient[3];
    double y = factor * gradient[4];
    double z = factor * gradient[5];
    c[19] += z;
    c[20] -= y;
    c[24] -= z;
    c[26] += x;
    c[30] += y;
    c[31] -= x;
  }
}
