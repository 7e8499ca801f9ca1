package org.mechservice.solver.spatial;

/** Euler parameters e = [cos(φ/2); u sin(φ/2)] of a rotation by φ about the unit vector u. */
public final class EulerParameters {
  private EulerParameters() {}

  /**
   * Writes the Euler parameters of a rotation matrix, e0 ≥ 0. The largest of the four is found from
   * the diagonal and divides the others, so that no digits are lost whatever the angle (Shepperd
   * 1978).
   *
   * @param r rotation matrix row by row, body to world axes, 9 numbers from {@code ir}; not
   *     modified
   * @param e e0, e1, e2, e3 from {@code ie}; overwritten
   */
  public static void of(double[] r, int ir, double[] e, int ie) {
    double xx = r[ir];
    double yy = r[ir + 4];
    double zz = r[ir + 8];
    double trace = xx + yy + zz;
    double largest = Math.max(Math.max(xx, yy), Math.max(zz, trace));
    // 4 e_i e_j for the largest e_i, up to the common factor that normalising removes
    if (largest == trace) {
      set(e, ie, 1 + trace, r[ir + 7] - r[ir + 5], r[ir + 2] - r[ir + 6], r[ir + 3] - r[ir + 1]);
    } else if (largest == xx) {
      set(
          e,
          ie,
          r[ir + 7] - r[ir + 5],
          1 + xx - yy - zz,
          r[ir + 1] + r[ir + 3],
          r[ir + 2] + r[ir + 6]);
    } else if (largest == yy) {
      set(
          e,
          ie,
          r[ir + 2] - r[ir + 6],
          r[ir + 1] + r[ir + 3],
          1 - xx + yy - zz,
          r[ir + 5] + r[ir + 7]);
    } else {
      set(
          e,
          ie,
          r[ir + 3] - r[ir + 1],
          r[ir + 2] + r[ir + 6],
          r[ir + 5] + r[ir + 7],
          1 - xx - yy + zz);
    }
  }

  private static void set(double[] e, int ie, double e0, double e1, double e2, double e3) {
    double norm = Math.sqrt(e0 * e0 + e1 * e1 + e2 * e2 + e3 * e3);
    double scale = e0 < 0 ? -1 / norm : 1 / norm;
    e[ie] = scale * e0;
    e[ie + 1] = scale * e1;
    e[ie + 2] = scale * e2;
    e[ie + 3] = scale * e3;
  }
}
