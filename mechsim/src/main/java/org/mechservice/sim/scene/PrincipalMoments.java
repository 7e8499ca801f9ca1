package org.mechservice.sim.scene;

import java.util.Arrays;
import org.mechservice.solver.spatial.InertiaTensor;

/** Principal moments of inertia: the eigenvalues of a symmetric 3 × 3 matrix. */
final class PrincipalMoments {
  private PrincipalMoments() {}

  /**
   * Returns the eigenvalues in rising order, from the roots of the characteristic cubic in
   * trigonometric form (Smith, Comm. ACM 4 (1961) 168).
   */
  static double[] of(InertiaTensor inertia) {
    double mean = inertia.trace() / 3;
    double xx = inertia.xx() - mean;
    double yy = inertia.yy() - mean;
    double zz = inertia.zz() - mean;
    double xy = inertia.xy();
    double xz = inertia.xz();
    double yz = inertia.yz();
    double products = xy * xy + xz * xz + yz * yz;
    double p = Math.sqrt((xx * xx + yy * yy + zz * zz + 2 * products) / 6);
    if (p == 0) {
      return new double[] {mean, mean, mean};
    }
    double determinant =
        xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
    double cosine = Math.max(-1, Math.min(1, determinant / (2 * p * p * p)));
    double angle = StrictMath.acos(cosine) / 3;
    double third = 2 * Math.PI / 3;
    double[] moments = {
      mean + 2 * p * StrictMath.cos(angle + third),
      mean + 2 * p * StrictMath.cos(angle - third),
      mean + 2 * p * StrictMath.cos(angle)
    };
    Arrays.sort(moments);
    return moments;
  }
}
