package org.mechservice.mechml.resolve.body;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

class PrincipalMomentsTest {
  /** Some thirty operations on numbers up to 3. */
  private static final double ROUNDING = 1e-14;

  @RepeatedTest(50)
  void turningTheAxesLeavesTheMoments(RepetitionInfo repetition) {
    Random random = new Random(repetition.getCurrentRepetition());
    Vector3 axis =
        new Vector3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
            .normalized();
    InertiaTensor turned =
        new InertiaTensor(1, 2, 3, 0, 0, 0).in(Rotation.about(axis, 6 * random.nextDouble()));
    assertMoments(PrincipalMoments.of(turned), 1, 2, 3);
  }

  @RepeatedTest(20)
  void equalMomentsAreFound(RepetitionInfo repetition) {
    Random random = new Random(repetition.getCurrentRepetition());
    Vector3 axis = new Vector3(random.nextGaussian(), random.nextGaussian(), 1).normalized();
    InertiaTensor rod =
        new InertiaTensor(0, 1, 1, 0, 0, 0).in(Rotation.about(axis, 6 * random.nextDouble()));
    assertMoments(PrincipalMoments.of(rod), 0, 1, 1);
  }

  /** The paper's wheel: its spin axis is principal, moments 0.740, 0.740, 1.460. */
  @ParameterizedTest
  @ValueSource(doubles = {0.877918562e-2, -0.877918562e-2})
  void wheelOfThePaper(double yz) {
    double[] moments =
        PrincipalMoments.of(new InertiaTensor(0.74, 1.459892943, 0.740107067, 0, 0, yz));
    // The file gives its elements to nine digits, the moments to three.
    assertThat(moments[0]).isCloseTo(0.74, within(1e-8));
    assertThat(moments[1]).isCloseTo(0.74, within(1e-8));
    assertThat(moments[2]).isCloseTo(1.46, within(1e-8));
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-200, 1, 1e200})
  void sizeDoesNotMatter(double scale) {
    InertiaTensor inertia = new InertiaTensor(2 * scale, 2 * scale, scale, scale, 0, 0);
    double[] moments = PrincipalMoments.of(inertia);
    assertMoments(
        new double[] {moments[0] / scale, moments[1] / scale, moments[2] / scale}, 1, 1, 3);
  }

  private static void assertMoments(double[] actual, double... expected) {
    assertThat(actual).containsExactly(expected, within(ROUNDING));
  }
}
