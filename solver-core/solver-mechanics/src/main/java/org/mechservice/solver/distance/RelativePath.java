package org.mechservice.solver.distance;

import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.spatial.EulerParameters;

/**
 * The motion of a body B relative to a body A between two rows of a run. Places of B in A's axes
 * follow cubic Hermite curves: at both rows they have the place and the velocity of the rows. Such
 * a curve over a part of the time lies in the hull of four points (Bernstein and Bézier).
 */
final class RelativePath {
  /** Rotation from B's axes to A's, row by row, and B's origin, at both ends; and their rates. */
  private final double[][] value = new double[2][12];

  private final double[][] rate = new double[2][12];
  private final double[] rotationA = new double[9];
  private final double[] rotationB = new double[9];
  private final double[] now = new double[12];
  private final double[] change = new double[12];
  private double duration;

  /**
   * Takes two rows.
   *
   * @param poses of A at both rows, as of {@link BodyPoses}
   * @param others of B
   * @param seconds from one to the other, s
   */
  void between(double[][] poses, double[][] others, double seconds) {
    duration = seconds;
    for (int end = 0; end < 2; end++) {
      place(poses[end], others[end], value[end], rate[end]);
    }
  }

  private void place(double[] a, double[] b, double[] pose, double[] moved) {
    EulerParameters.rotation(a, 3, rotationA, 0);
    EulerParameters.rotation(b, 3, rotationB, 0);
    double[] from = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    double[] turning = {b[10] - a[10], b[11] - a[11], b[12] - a[12]};
    // the velocity of B's origin as A sees it: v_B − v_A − ω_A × r
    double[] sliding = {
      b[7] - a[7] - (a[11] * from[2] - a[12] * from[1]),
      b[8] - a[8] - (a[12] * from[0] - a[10] * from[2]),
      b[9] - a[9] - (a[10] * from[1] - a[11] * from[0])
    };
    double[] omega = new double[3];
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        pose[3 * i + j] =
            rotationA[i] * rotationB[j]
                + rotationA[3 + i] * rotationB[3 + j]
                + rotationA[6 + i] * rotationB[6 + j];
      }
      pose[9 + i] = inA(from, i);
      moved[9 + i] = inA(sliding, i);
      omega[i] = inA(turning, i);
    }
    for (int j = 0; j < 3; j++) {
      moved[j] = omega[1] * pose[6 + j] - omega[2] * pose[3 + j];
      moved[3 + j] = omega[2] * pose[j] - omega[0] * pose[6 + j];
      moved[6 + j] = omega[0] * pose[3 + j] - omega[1] * pose[j];
    }
  }

  private double inA(double[] world, int i) {
    return rotationA[i] * world[0] + rotationA[3 + i] * world[1] + rotationA[6 + i] * world[2];
  }

  /** Evaluates the motion and its derivative by u at a part u of the time, 0 to 1. */
  private void at(double u) {
    double v = 1 - u;
    double h00 = (1 + 2 * u) * v * v;
    double h10 = u * v * v * duration;
    double h01 = u * u * (3 - 2 * u);
    double h11 = 0 - u * u * v * duration;
    double d00 = 0 - 6 * u * v;
    double d10 = v * (1 - 3 * u) * duration;
    double d11 = u * (3 * u - 2) * duration;
    for (int i = 0; i < 12; i++) {
      now[i] = h00 * value[0][i] + h10 * rate[0][i] + h01 * value[1][i] + h11 * rate[1][i];
      change[i] = d00 * (value[0][i] - value[1][i]) + d10 * rate[0][i] + d11 * rate[1][i];
    }
  }

  /** Writes the places of points of B in A's axes at a part of the time. */
  void places(double u, double[] points, double[] out) {
    at(u);
    for (int p = 0; p < points.length; p += 3) {
      apply(now, points, p, out, p);
    }
  }

  /**
   * Writes the control points of the paths of points of B over a part of the time, four of each.
   *
   * @param out 12 numbers per point; overwritten
   */
  void controls(double from, double to, double[] points, double[] out) {
    double third = (to - from) / 3;
    at(from);
    for (int p = 0; p < points.length; p += 3) {
      control(points, p, third, out, 4 * p, 4 * p + 3);
    }
    at(to);
    for (int p = 0; p < points.length; p += 3) {
      control(points, p, 0 - third, out, 4 * p + 9, 4 * p + 6);
    }
  }

  private void control(double[] points, int p, double third, double[] out, int end, int next) {
    apply(now, points, p, out, end);
    for (int i = 0; i < 3; i++) {
      double along =
          change[3 * i] * points[p]
              + change[3 * i + 1] * points[p + 1]
              + change[3 * i + 2] * points[p + 2]
              + change[9 + i];
      out[next + i] = out[end + i] + third * along;
    }
  }

  /**
   * Returns a bound of the length that a unit vector of B has in A's axes over a part of the time:
   * curves between two rows do not keep lengths. It is the norm of the four control matrices, each
   * by the circles of Gershgorin around the eigenvalues of CᵀC; 1 for a body that does not turn.
   */
  double stretch(double from, double to) {
    double third = (to - from) / 3;
    at(from);
    double most = Math.max(square(0), square(third));
    at(to);
    return Math.sqrt(Math.max(most, Math.max(square(0), square(0 - third))));
  }

  /** Bounds the square of the norm of the matrix now + third change. */
  private double square(double third) {
    double most = 0;
    for (int i = 0; i < 3; i++) {
      double sum = 0;
      for (int j = 0; j < 3; j++) {
        double product = 0;
        for (int k = 0; k < 9; k += 3) {
          product += (now[k + i] + third * change[k + i]) * (now[k + j] + third * change[k + j]);
        }
        sum += Math.abs(product);
      }
      most = Math.max(most, sum);
    }
    return most;
  }

  /** Writes a place in A's axes at the first row in the axes of B. */
  void back(double[] place, double[] out) {
    for (int i = 0; i < 3; i++) {
      out[i] = 0;
      for (int j = 0; j < 3; j++) {
        out[i] += value[0][3 * j + i] * (place[j] - value[0][9 + j]);
      }
    }
  }

  private static void apply(double[] pose, double[] points, int p, double[] out, int at) {
    for (int i = 0; i < 3; i++) {
      out[at + i] =
          pose[3 * i] * points[p]
              + pose[3 * i + 1] * points[p + 1]
              + pose[3 * i + 2] * points[p + 2]
              + pose[9 + i];
    }
  }
}
