package org.mechservice.solver.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** How many digits of 50 the articulated bodies keep. */
class ArticulatedBodyDigitsTest {
  private static final List<Vector3> AXES =
      List.of(new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1));

  /** Within 1e-12 of the largest acceleration on chains of up to 100 bodies. */
  @ValueSource(ints = {1, 2, 5, 10, 20, 50, 100})
  @ParameterizedTest
  void accelerationsHaveTwelveDigits(int n) {
    Mechanism chain = chain(n);
    Evaluation at = new Evaluation(chain);
    double[] q = Arrays.copyOf(at.y, n);
    double[] expected = new PreciseChain(chain, q).accelerations(at.velocities());
    double bound = 1e-12 * Evaluation.largest(expected);
    double[] a = at.byArticulatedBodies();
    for (int i = 0; i < n; i++) {
      assertThat(a[i]).as("joint %d", i).isCloseTo(expected[i], within(bound));
    }
  }

  /** Revolute joints about random axes of the frames, bodies of a kilogram and decimetres. */
  private static Mechanism chain(int n) {
    Random random = new Random(50 + n);
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      Vector3 tip = new Vector3(0.3, 0.1 * random.nextGaussian(), 0.1 * random.nextGaussian());
      InertiaTensor inertia = new InertiaTensor(0.02, 0.03, 0.025, 0.001, -0.002, 0.0015);
      String name = "link" + i;
      bodies.add(new Body(name, 1 + random.nextDouble(), tip.times(0.5), inertia, Origin.NONE));
      Attachment attachment =
          new Attachment(i - 1, i == 0 ? Vector3.ZERO : tip, i, Vector3.ZERO, Rotation.IDENTITY);
      Vector3 axis = AXES.get(random.nextInt(3));
      double angle = random.nextGaussian();
      double rate = random.nextGaussian();
      joints.add(new Revolute("j" + i, attachment, axis, angle, rate, Origin.NONE));
    }
    Root root = new Root("ground", Vector3.ZERO, Rotation.IDENTITY);
    return new Mechanism("chain" + n, root, new Vector3(0.5, -1, -9.81), bodies, joints);
  }
}
