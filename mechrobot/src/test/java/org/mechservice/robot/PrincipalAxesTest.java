package org.mechservice.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

class PrincipalAxesTest {
  @Test
  void turnedMomentsAreFoundAgain() {
    Random random = new Random(47);
    for (int i = 0; i < 200; i++) {
      Vector3 about =
          new Vector3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
      Rotation turn = Rotation.about(about.normalized(), 6 * random.nextDouble());
      List<Double> moments = List.of(2e-9, 3e-9, i % 2 == 0 ? 3e-9 : 4e-9, 0.0, 0.0, 0.0);
      double[] j = MechmlRobot.turned(turn, moments);
      PrincipalAxes axes = PrincipalAxes.of(List.of(j[0], j[1], j[2], j[3], j[4], j[5]));
      for (int k = 0; k < 3; k++) {
        Vector3 e = axes.axis(k);
        Vector3 je =
            new Vector3(
                j[0] * e.x() + j[3] * e.y() + j[4] * e.z(),
                j[3] * e.x() + j[1] * e.y() + j[5] * e.z(),
                j[4] * e.x() + j[5] * e.y() + j[2] * e.z());
        assertThat(je.minus(e.times(axes.moments()[k])).norm()).isLessThan(1e-23);
      }
      assertThat(axes.axis(0).cross(axes.axis(1)).dot(axes.axis(2))).isCloseTo(1, within(1e-14));
    }
  }

  @Test
  void principalAxesStay() {
    PrincipalAxes axes = PrincipalAxes.of(List.of(2.0, 1.0, 2.0, 0.0, 0.0, 0.0));
    assertThat(axes.axis(0)).isEqualTo(new Vector3(1, 0, 0));
    assertThat(axes.moments()).containsExactly(2, 1, 2);
  }
}
