package org.mechservice.view.player;

import java.util.List;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneBody;

/**
 * The box of even density that has a body's mass and inertia.
 *
 * @param pose its centre and edges in body axes
 * @param size lengths of its edges, m; one may be 0 for a slender body, none if the body has no
 *     inertia
 */
record InertiaBox(BodyPose pose, Point3 size) {
  private static final int SWEEPS = 20;

  static InertiaBox of(SceneBody body) {
    if (!(body.mass() > 0)) {
      return new InertiaBox(BodyPose.WORLD, Point3.ZERO);
    }
    List<Double> i = body.inertia();
    double[] a = {
      i.get(0), i.get(3), i.get(4), i.get(3), i.get(1), i.get(5), i.get(4), i.get(5), i.get(2)
    };
    double[] axes = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
      turn(a, axes, 0, 1);
      turn(a, axes, 0, 2);
      turn(a, axes, 1, 2);
    }
    if (determinant(axes) < 0) {
      for (int row = 0; row < 3; row++) {
        axes[3 * row + 2] = -axes[3 * row + 2];
      }
    }
    return new InertiaBox(
        BodyPose.of(body.centreOfMass(), axes, 0),
        new Point3(
            edge(a[4] + a[8] - a[0], body.mass()),
            edge(a[0] + a[8] - a[4], body.mass()),
            edge(a[0] + a[4] - a[8], body.mass())));
  }

  /** Returns a with m a²/6 = twice the second moment of mass along the edge. */
  private static double edge(double moment, double mass) {
    return Math.sqrt(Math.max(0, 6 * moment / mass));
  }

  private static double determinant(double[] m) {
    return m[0] * (m[4] * m[8] - m[5] * m[7])
        - m[1] * (m[3] * m[8] - m[5] * m[6])
        + m[2] * (m[3] * m[7] - m[4] * m[6]);
  }

  /** One rotation of Jacobi's method for eigenvalues: makes a[p][q] zero (columns of axes turn). */
  private static void turn(double[] a, double[] axes, int p, int q) {
    double apq = a[3 * p + q];
    if (apq == 0) {
      return;
    }
    double theta = (a[4 * q] - a[4 * p]) / (2 * apq);
    double tan = Math.copySign(1, theta) / (Math.abs(theta) + Math.sqrt(theta * theta + 1));
    double cos = 1 / Math.sqrt(tan * tan + 1);
    double sin = tan * cos;
    for (int k = 0; k < 3; k++) {
      mix(a, 3 * k + p, 3 * k + q, cos, sin);
    }
    for (int k = 0; k < 3; k++) {
      mix(a, 3 * p + k, 3 * q + k, cos, sin);
      mix(axes, 3 * k + p, 3 * k + q, cos, sin);
    }
  }

  private static void mix(double[] m, int i, int j, double cos, double sin) {
    double mi = m[i];
    m[i] = cos * mi - sin * m[j];
    m[j] = sin * mi + cos * m[j];
  }
}
