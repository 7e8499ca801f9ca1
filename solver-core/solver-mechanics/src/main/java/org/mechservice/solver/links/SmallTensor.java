package org.mechservice.solver.links;

import org.mechservice.solver.spatial.InertiaTensor;

/** The pivots of a tensor of inertia in the successive elimination of its axes. */
public final class SmallTensor {
  private SmallTensor() {}

  /** Returns the pivots of x, y and z; a bound below those of any inertia that includes it. */
  public static double[] pivots(InertiaTensor i) {
    double x = i.xx();
    double xy = x > 0 ? i.xy() / x : 0;
    double xz = x > 0 ? i.xz() / x : 0;
    double y = i.yy() - xy * i.xy();
    double coupling = i.yz() - xy * i.xz();
    double yz = y > 0 ? coupling / y : 0;
    double z = i.zz() - xz * i.xz() - yz * coupling;
    return new double[] {Math.max(0, x), Math.max(0, y), Math.max(0, z)};
  }
}
