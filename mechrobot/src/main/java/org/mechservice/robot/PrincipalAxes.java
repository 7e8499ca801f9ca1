package org.mechservice.robot;

import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * The principal axes of an inertia tensor, by Jacobi's method: each rotation makes the largest
 * element off the diagonal zero. Axes that are principal from the beginning stay as they are.
 */
final class PrincipalAxes {
  /** Rotations; each about halves what is left, and convergence is quadratic at the end. */
  private static final int MOST = 100;

  private final double[][] tensor;
  private final double[][] axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

  private PrincipalAxes(double[][] tensor) {
    this.tensor = tensor;
  }

  /**
   * Returns the axes of a tensor.
   *
   * @param moments xx, yy, zz, xy, xz, yz, kg·m²
   */
  static PrincipalAxes of(List<Double> moments) {
    double[] m = moments.stream().mapToDouble(Double::doubleValue).toArray();
    PrincipalAxes all =
        new PrincipalAxes(
            new double[][] {{m[0], m[3], m[4]}, {m[3], m[1], m[5]}, {m[4], m[5], m[2]}});
    for (int i = 0; i < MOST && all.turn(); i++) {
      // Until nothing is left.
    }
    return all;
  }

  /** Returns the moments about the axes, kg·m². */
  double[] moments() {
    return new double[] {tensor[0][0], tensor[1][1], tensor[2][2]};
  }

  /** Returns an axis, 0 to 2, a unit vector; the three are a right-handed frame. */
  Vector3 axis(int i) {
    return new Vector3(axes[0][i], axes[1][i], axes[2][i]);
  }

  /** Returns the rotation from the axes to those of the tensor. */
  Rotation frame() {
    return Rotation.ofColumns(axis(0), axis(1), axis(2));
  }

  /**
   * Returns the tensor with other moments about the axes: xx, yy, zz, xy, xz, yz, kg·m².
   *
   * @param moments about the three axes, kg·m²
   */
  List<Double> tensor(double[] moments) {
    double[] sum = new double[6];
    for (int i = 0; i < 3; i++) {
      double m = moments[i];
      Vector3 a = axis(i);
      sum[0] += m * a.x() * a.x();
      sum[1] += m * a.y() * a.y();
      sum[2] += m * a.z() * a.z();
      sum[3] += m * a.x() * a.y();
      sum[4] += m * a.x() * a.z();
      sum[5] += m * a.y() * a.z();
    }
    return Arrays.stream(sum).boxed().toList();
  }

  /** Makes the largest element zero; returns whether there was one beside rounding. */
  private boolean turn() {
    int p = 0;
    int q = 1;
    if (Math.abs(tensor[0][2]) > Math.abs(tensor[p][q])) {
      q = 2;
    }
    if (Math.abs(tensor[1][2]) > Math.abs(tensor[p][q])) {
      p = 1;
      q = 2;
    }
    double scale = Math.abs(tensor[0][0]) + Math.abs(tensor[1][1]) + Math.abs(tensor[2][2]);
    double off = tensor[p][q];
    if (!(Math.abs(off) > 1e-17 * scale)) {
      return false;
    }
    // t = tan φ, the smaller root of t² + 2 t cot 2φ − 1 = 0.
    double cotangent = (tensor[q][q] - tensor[p][p]) / (2 * off);
    double t =
        Math.copySign(1, cotangent) / (Math.abs(cotangent) + Math.sqrt(1 + cotangent * cotangent));
    double c = 1 / Math.sqrt(1 + t * t);
    double s = t * c;
    for (int k = 0; k < 3; k++) {
      double kp = tensor[k][p];
      double kq = tensor[k][q];
      tensor[k][p] = c * kp - s * kq;
      tensor[k][q] = s * kp + c * kq;
      double ap = axes[k][p];
      double aq = axes[k][q];
      axes[k][p] = c * ap - s * aq;
      axes[k][q] = s * ap + c * aq;
    }
    for (int k = 0; k < 3; k++) {
      double pk = tensor[p][k];
      double qk = tensor[q][k];
      tensor[p][k] = c * pk - s * qk;
      tensor[q][k] = s * pk + c * qk;
    }
    tensor[p][q] = 0;
    tensor[q][p] = 0;
    return true;
  }
}
