package org.mechservice.solver.kinematics.pair;

import org.mechservice.solver.spatial.Blocks;

/** (|ρ|² − d²) / (2d): a length with a gradient of one where the distance is d (NUMERICS §3). */
final class Distance extends PairFunction {
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
  public double evaluate(RelativeMotion r) {
    for (int i = 0; i < 3; i++) {
      gradient[3 + i] = r.position[i] / distance;
    }
    double length = Math.sqrt(Blocks.dot(r.position, 0, r.position, 0));
    return (length - distance) * (length + distance) / (2 * distance);
  }

  @Override
  public void addCurvature(RelativeMotion r, double factor, double[] c) {
    for (int i = 3; i < 6; i++) {
      c[7 * i] += factor / distance;
    }
  }
}
