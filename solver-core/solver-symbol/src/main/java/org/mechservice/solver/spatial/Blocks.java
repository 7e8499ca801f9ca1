package org.mechservice.solver.spatial;

/**
 * Vectors of 3 and matrices of 3 × 3 stored row by row in larger arrays. An offset gives the first
 * element of each; results must not overlap arguments unless stated otherwise. Nothing here
 * allocates.
 */
public final class Blocks {
  private Blocks() {}

  /** Returns aᵀ b. */
  public static double dot(double[] a, int ia, double[] b, int ib) {
    return a[ia] * b[ib] + a[ia + 1] * b[ib + 1] + a[ia + 2] * b[ib + 2];
  }

  /** Writes r = a × b. */
  public static void cross(double[] a, int ia, double[] b, int ib, double[] r, int ir) {
    r[ir] = a[ia + 1] * b[ib + 2] - a[ia + 2] * b[ib + 1];
    r[ir + 1] = a[ia + 2] * b[ib] - a[ia] * b[ib + 2];
    r[ir + 2] = a[ia] * b[ib + 1] - a[ia + 1] * b[ib];
  }

  /** Adds a × b to r. */
  public static void addCross(double[] a, int ia, double[] b, int ib, double[] r, int ir) {
    r[ir] += a[ia + 1] * b[ib + 2] - a[ia + 2] * b[ib + 1];
    r[ir + 1] += a[ia + 2] * b[ib] - a[ia] * b[ib + 2];
    r[ir + 2] += a[ia] * b[ib + 1] - a[ia + 1] * b[ib];
  }

  /** Writes r = M a. */
  public static void apply(double[] m, int im, double[] a, int ia, double[] r, int ir) {
    for (int i = 0; i < 3; i++) {
      r[ir + i] = dot(m, im + 3 * i, a, ia);
    }
  }

  /** Writes r = Mᵀ a. */
  public static void applyTransposed(double[] m, int im, double[] a, int ia, double[] r, int ir) {
    for (int i = 0; i < 3; i++) {
      r[ir + i] = m[im + i] * a[ia] + m[im + 3 + i] * a[ia + 1] + m[im + 6 + i] * a[ia + 2];
    }
  }

  /** Writes R = A B. */
  public static void multiply(double[] a, int ia, double[] b, int ib, double[] r, int ir) {
    for (int i = 0; i < 3; i++) {
      applyTransposed(b, ib, a, ia + 3 * i, r, ir + 3 * i);
    }
  }

  /**
   * Writes S = Q M Qᵀ; {@code work} holds 9 numbers and is overwritten. {@code s} may be {@code m}.
   */
  public static void congruence(
      double[] q, int iq, double[] m, int im, double[] s, int is, double[] work, int iw) {
    multiply(q, iq, m, im, work, iw);
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        s[is + 3 * i + j] = dot(work, iw + 3 * i, q, iq + 3 * j);
      }
    }
  }

  /** Writes R = [a]× M, the columns of M crossed with a. */
  public static void crossColumns(double[] a, int ia, double[] m, int im, double[] r, int ir) {
    for (int j = 0; j < 3; j++) {
      r[ir + j] = a[ia + 1] * m[im + 6 + j] - a[ia + 2] * m[im + 3 + j];
      r[ir + 3 + j] = a[ia + 2] * m[im + j] - a[ia] * m[im + 6 + j];
      r[ir + 6 + j] = a[ia] * m[im + 3 + j] - a[ia + 1] * m[im + j];
    }
  }

  /**
   * Writes the rotation about a unit vector (Rodrigues' formula).
   *
   * @param u unit vector
   * @param sin sine of the angle
   * @param cos cosine of the angle
   * @param r rotation matrix; overwritten
   */
  public static void rotationAbout(double[] u, int iu, double sin, double cos, double[] r, int ir) {
    double d = 1 - cos;
    double x = u[iu];
    double y = u[iu + 1];
    double z = u[iu + 2];
    r[ir] = cos + d * x * x;
    r[ir + 1] = d * x * y - sin * z;
    r[ir + 2] = d * x * z + sin * y;
    r[ir + 3] = d * x * y + sin * z;
    r[ir + 4] = cos + d * y * y;
    r[ir + 5] = d * y * z - sin * x;
    r[ir + 6] = d * x * z - sin * y;
    r[ir + 7] = d * y * z + sin * x;
    r[ir + 8] = cos + d * z * z;
  }
}
