package org.mechservice.solver.kinematics.pair;

import org.mechservice.solver.spatial.Blocks;

/**
 * (|ρ|² − d²) / (2d): a length with a gradient of one where the distance is d
 * (docs/theory/loops.md#cutting).
 */
final class Distance extends PairFunction {
  /** A unit vector in no plane and along no axis that a mechanism is likely to move in. */
  private static final double[] ANY_DIRECTION = {0.48, 0.6, 0.64};

  private final double distance;

  /**
   * @param distance d, m, positive
   */
  Distance(double distance) {
    super("distance");
    this.distance = distance;
  }

  @Override
  public <T> T as(PairForms<T> forms) {
    return forms.distance(distance);
  }

  @Override
  public boolean isLength() {
    return true;
  }

  @Override
  public double evaluate(RelativeMotion r) {
    for (int i = 0; i < 3; i++) {
      gradient[3 + i] = r.position[i] / distance;
    }
    double length = Math.sqrt(Blocks.dot(r.position, 0, r.position, 0));
    return (length - distance) * (length + distance) / (2 * distance);
  }

  /** {@inheritDoc} It is |ρ| − d; points that coincide are moved apart in any direction. */
  @Override
  public double evaluateFar(RelativeMotion r) {
    double length = Math.sqrt(Blocks.dot(r.position, 0, r.position, 0));
    for (int i = 0; i < 3; i++) {
      gradient[3 + i] = length > 0 ? r.position[i] / length : ANY_DIRECTION[i];
    }
    return length - distance;
  }

  @Override
  public void addCurvature(RelativeMotion r, double factor, double[] c) {
    for (int i = 3; i < 6; i++) {
      c[7 * i] += factor / distance;
    }
  }
}
