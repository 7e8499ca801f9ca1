package org.mechservice.solver.spatial;

/**
 * Euler parameters e = [cos(φ/2); u sin(φ/2)] of a rotation by φ about the unit vector u, and their
 * calculus (docs/theory/motion.md#positions). ∘ is the product of quaternions.
 */
public final class EulerParameters {
  private EulerParameters() {}

  /**
   * Writes the Euler parameters of a rotation matrix, e0 ≥ 0. The largest of the four is computed
   * from the diagonal and divides the others, so that no digits are lost at any angle (Shepperd
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

  /**
   * Writes the rotation of Euler parameters of any length but zero, R(e/|e|).
   *
   * @param e e0, e1, e2, e3 from {@code ie}; not modified
   * @param r rotation matrix row by row, 9 numbers from {@code ir}; overwritten
   */
  public static void rotation(double[] e, int ie, double[] r, int ir) {
    double w = e[ie];
    double x = e[ie + 1];
    double y = e[ie + 2];
    double z = e[ie + 3];
    double s = 2 / (w * w + x * x + y * y + z * z);
    r[ir] = 1 - s * (y * y + z * z);
    r[ir + 1] = s * (x * y - w * z);
    r[ir + 2] = s * (x * z + w * y);
    r[ir + 3] = s * (x * y + w * z);
    r[ir + 4] = 1 - s * (x * x + z * z);
    r[ir + 5] = s * (y * z - w * x);
    r[ir + 6] = s * (x * z - w * y);
    r[ir + 7] = s * (y * z + w * x);
    r[ir + 8] = 1 - s * (x * x + y * y);
  }

  /** Returns |e|. */
  public static double norm(double[] e, int ie) {
    double w = e[ie];
    double x = e[ie + 1];
    double y = e[ie + 2];
    double z = e[ie + 3];
    return Math.sqrt(w * w + x * x + y * y + z * z);
  }

  /**
   * Writes e' = ½ (0, ω) ∘ e.
   *
   * @param e from {@code ie}; not modified
   * @param omega angular velocity in the outer axes of e, rad/s, from {@code io}; not modified
   * @param rate four numbers from {@code ir}, 1/s; overwritten
   */
  public static void rate(double[] e, int ie, double[] omega, int io, double[] rate, int ir) {
    double x = 0.5 * omega[io];
    double y = 0.5 * omega[io + 1];
    double z = 0.5 * omega[io + 2];
    double e0 = e[ie];
    double e1 = e[ie + 1];
    double e2 = e[ie + 2];
    double e3 = e[ie + 3];
    rate[ir] = -x * e1 - y * e2 - z * e3;
    rate[ir + 1] = x * e0 + y * e3 - z * e2;
    rate[ir + 2] = y * e0 + z * e1 - x * e3;
    rate[ir + 3] = z * e0 + x * e2 - y * e1;
  }

  /**
   * Turns Euler parameters by a rotation vector: e ← exp(½ δ) ∘ e, exactly; their length stays.
   *
   * @param e from {@code ie}; overwritten
   * @param delta rotation vector in the outer axes of e, rad, from {@code id}; not modified
   * @param factor factor of δ
   */
  public static void turn(double[] e, int ie, double[] delta, int id, double factor) {
    double x = 0.5 * factor * delta[id];
    double y = 0.5 * factor * delta[id + 1];
    double z = 0.5 * factor * delta[id + 2];
    double angle = Math.sqrt(x * x + y * y + z * z);
    double cos = StrictMath.cos(angle);
    double s = angle == 0 ? 1 : StrictMath.sin(angle) / angle;
    double e0 = e[ie];
    double e1 = e[ie + 1];
    double e2 = e[ie + 2];
    double e3 = e[ie + 3];
    e[ie] = cos * e0 - s * (x * e1 + y * e2 + z * e3);
    e[ie + 1] = cos * e1 + s * (x * e0 + y * e3 - z * e2);
    e[ie + 2] = cos * e2 + s * (y * e0 + z * e1 - x * e3);
    e[ie + 3] = cos * e3 + s * (z * e0 + x * e2 - y * e1);
  }

  /**
   * Writes the rotation vector that turns one orientation into another, e ∘ e₀⁻¹, of at most half a
   * turn: the inverse of {@link #turn}.
   *
   * @param from e₀, four parameters from {@code at}; not modified
   * @param to e, likewise
   * @param delta rotation vector in the outer axes, rad, from {@code id}; overwritten
   */
  public static void turnBetween(double[] from, double[] to, int at, double[] delta, int id) {
    double a0 = from[at];
    double a1 = from[at + 1];
    double a2 = from[at + 2];
    double a3 = from[at + 3];
    double b0 = to[at];
    double b1 = to[at + 1];
    double b2 = to[at + 2];
    double b3 = to[at + 3];
    double cosine = a0 * b0 + a1 * b1 + a2 * b2 + a3 * b3;
    double x = a0 * b1 - b0 * a1 - b2 * a3 + b3 * a2;
    double y = a0 * b2 - b0 * a2 - b3 * a1 + b1 * a3;
    double z = a0 * b3 - b0 * a3 - b1 * a2 + b2 * a1;
    double sine = Math.sqrt(x * x + y * y + z * z);
    double angle = 2 * StrictMath.atan2(sine, Math.abs(cosine));
    double scale = sine == 0 ? 0 : Math.copySign(angle / sine, cosine);
    delta[id] = scale * x;
    delta[id + 1] = scale * y;
    delta[id + 2] = scale * z;
  }

  private static void set(double[] e, int ie, double e0, double e1, double e2, double e3) {
    double norm = Math.sqrt(e0 * e0 + e1 * e1 + e2 * e2 + e3 * e3);
    double scale = e0 < 0 ? -1 / norm : 1 / norm;
    e[ie] = scale * e0;
    e[ie + 1] = scale * e1;
    e[ie + 2] = scale * e2;
    e[ie + 3] = scale * e3;
  }

  /**
   * Writes the small rotation that a change of Euler parameters is along the tangent, 2 vec(δe ∘
   * e⁻¹), rad.
   *
   * @param e four parameters from {@code at}; not modified
   * @param change their change from {@code at}; not modified
   * @param rotation three numbers from {@code to}; overwritten
   */
  public static void rotation(double[] e, int at, double[] change, double[] rotation, int to) {
    double e0 = e[at];
    double e1 = e[at + 1];
    double e2 = e[at + 2];
    double e3 = e[at + 3];
    double c0 = change[at];
    double c1 = change[at + 1];
    double c2 = change[at + 2];
    double c3 = change[at + 3];
    double scale = 2 / (e0 * e0 + e1 * e1 + e2 * e2 + e3 * e3);
    rotation[to] = scale * (c1 * e0 - c0 * e1 - c2 * e3 + c3 * e2);
    rotation[to + 1] = scale * (c2 * e0 - c0 * e2 - c3 * e1 + c1 * e3);
    rotation[to + 2] = scale * (c3 * e0 - c0 * e3 - c1 * e2 + c2 * e1);
  }
}
