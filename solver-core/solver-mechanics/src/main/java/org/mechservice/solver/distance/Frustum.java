package org.mechservice.solver.distance;

/**
 * A cylinder, a frustum of a cone or a cone: the hull of two discs about one axis. Exact, without
 * facets.
 */
public final class Frustum implements ConvexShape {
  private final double[] from;
  private final double[] to;
  private final double[] axis = new double[3];
  private final double[] radius;

  /**
   * Makes a frustum.
   *
   * @param from centre of one disc, m; copied
   * @param to centre of the other, another place, m; copied
   * @param bottom radius of the first disc, m
   * @param top radius of the other, m; 0 for a tip
   * @throws IllegalArgumentException if the centres are the same place
   */
  public Frustum(double[] from, double[] to, double bottom, double top) {
    this.from = from.clone();
    this.to = to.clone();
    radius = new double[] {bottom, top};
    double length = 0;
    for (int i = 0; i < 3; i++) {
      axis[i] = to[i] - from[i];
      length += axis[i] * axis[i];
    }
    if (!(length > 0) || !(bottom >= 0) || !(top >= 0)) {
      throw new IllegalArgumentException("a frustum has a length, and radii that are not negative");
    }
    for (int i = 0; i < 3; i++) {
      axis[i] /= Math.sqrt(length);
    }
  }

  @Override
  public void support(double x, double y, double z, double[] point) {
    double along = x * axis[0] + y * axis[1] + z * axis[2];
    double acrossX = x - along * axis[0];
    double acrossY = y - along * axis[1];
    double acrossZ = z - along * axis[2];
    // once more: of a direction nearly along the axis rounding leaves a part along it
    along = acrossX * axis[0] + acrossY * axis[1] + acrossZ * axis[2];
    acrossX -= along * axis[0];
    acrossY -= along * axis[1];
    acrossZ -= along * axis[2];
    double across = Math.sqrt(acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ);
    double atFrom = x * from[0] + y * from[1] + z * from[2] + radius[0] * across;
    double atTo = x * to[0] + y * to[1] + z * to[2] + radius[1] * across;
    double[] centre = atTo > atFrom ? to : from;
    double out = across > 0 ? (atTo > atFrom ? radius[1] : radius[0]) / across : 0;
    point[0] = centre[0] + out * acrossX;
    point[1] = centre[1] + out * acrossY;
    point[2] = centre[2] + out * acrossZ;
  }

  @Override
  public double margin() {
    return 0;
  }
}
