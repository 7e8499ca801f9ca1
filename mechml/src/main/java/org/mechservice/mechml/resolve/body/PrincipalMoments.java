package org.mechservice.mechml.resolve.body;

import java.util.Arrays;
import org.mechservice.solver.spatial.InertiaTensor;

/**
 * Computes the eigenvalues of an inertia tensor by Jacobi's method: each plane rotation makes one
 * off-diagonal element zero.
 */
final class PrincipalMoments {
  /** Number of sweeps; convergence is quadratic, and five or six suffice for 3 × 3 matrices. */
  private static final int SWEEPS = 20;

  private PrincipalMoments() {}

  /** Returns the principal moments in ascending order, kg·m². */
  static double[] of(InertiaTensor inertia) {
    double[][] a = {
      {inertia.xx(), inertia.xy(), inertia.xz()},
      {inertia.xy(), inertia.yy(), inertia.yz()},
      {inertia.xz(), inertia.yz(), inertia.zz()}
    };
    double scale = largest(a);
    if (scale == 0) {
      return new double[3];
    }
    // Scaled to 1, so that no square leaves the range of doubles.
    for (double[] row : a) {
      for (int j = 0; j < 3; j++) {
        row[j] /= scale;
      }
    }
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
      annihilate(a, 0, 1, 2);
      annihilate(a, 0, 2, 1);
      annihilate(a, 1, 2, 0);
    }
    double[] moments = {scale * a[0][0], scale * a[1][1], scale * a[2][2]};
    Arrays.sort(moments);
    return moments;
  }

  private static double largest(double[][] a) {
    return Arrays.stream(a).flatMapToDouble(Arrays::stream).map(Math::abs).max().orElse(0);
  }

  /** Rotates the plane of p and q so that a[p][q] becomes zero; r is the third index. */
  private static void annihilate(double[][] a, int p, int q, int r) {
    if (a[p][q] == 0) {
      return;
    }
    // t = tan φ, the smaller root of t² + 2 t cot 2φ − 1 = 0.
    double cot2 = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    double t =
        Double.isInfinite(cot2)
            ? 0
            : Math.copySign(1, cot2) / (Math.abs(cot2) + Math.sqrt(1 + cot2 * cot2));
    double c = 1 / Math.sqrt(1 + t * t);
    double s = t * c;
    double arp = a[r][p];
    double arq = a[r][q];
    a[p][p] -= t * a[p][q];
    a[q][q] += t * a[p][q];
    a[p][q] = 0;
    a[q][p] = 0;
    a[r][p] = c * arp - s * arq;
    a[p][r] = a[r][p];
    a[r][q] = s * arp + c * arq;
    a[q][r] = a[r][q];
  }
}
