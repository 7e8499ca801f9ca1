package org.mechservice.view.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Euler parameters of a pose turn as its rotation matrix does. */
class BodyPoseTest {
  /** Half turns, for which e0 vanishes, a third of a turn, and the identity; row by row. */
  private static final List<double[]> ROTATIONS =
      List.of(
          new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1},
          new double[] {1, 0, 0, 0, -1, 0, 0, 0, -1},
          new double[] {-1, 0, 0, 0, 1, 0, 0, 0, -1},
          new double[] {-1, 0, 0, 0, -1, 0, 0, 0, 1},
          new double[] {0, 0, 1, 1, 0, 0, 0, 1, 0},
          new double[] {0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1});

  @Test
  void poseOfAMatrixTurnsLikeTheMatrix() {
    Point3 v = new Point3(0.3, -1.1, 2.7);
    for (double[] a : ROTATIONS) {
      Point3 turned = BodyPose.of(Point3.ZERO, a, 0).turn(v);
      Point3 expected =
          new Point3(
              a[0] * v.x() + a[1] * v.y() + a[2] * v.z(),
              a[3] * v.x() + a[4] * v.y() + a[5] * v.z(),
              a[6] * v.x() + a[7] * v.y() + a[8] * v.z());
      assertThat(turned.minus(expected).norm()).isLessThan(1e-14);
    }
  }

  @Test
  void pointOfABodyIsTurnedThenMoved() {
    BodyPose pose = BodyPose.of(new Point3(1, 2, 3), ROTATIONS.get(3), 0);

    assertThat(pose.toWorld(new Point3(1, 0, 0))).isEqualTo(new Point3(0, 2, 3));
  }
}
