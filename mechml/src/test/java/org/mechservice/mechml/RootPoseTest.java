package org.mechservice.mechml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/** Where inipos puts the root (docs/mechml.md#topology-and-start). */
class RootPoseTest {
  /** A dozen operations on numbers near 10. */
  private static final Offset<Double> ROUNDING = within(1e-13);

  private static final String GROUND =
      "<point name='p' x='1' y='2' z='3'/><vector name='u' vx='1' vy='0' vz='0'/>"
          + "<vector name='w' vx='0' vy='1' vz='0'/>";
  private static final Vector3 POINT = new Vector3(1, 2, 3);

  private static Root root(String inipos) throws MechmlException {
    String element = inipos.isEmpty() ? "" : "<inipos>" + inipos + "</inipos>";
    return ModelText.of("R").withGround(GROUND).withInipos(element).mechanism().root();
  }

  @Test
  void withoutIniposTheRootIsTheWorld() throws MechmlException {
    assertThat(root("")).isEqualTo(new Root("Ground", Vector3.ZERO, Rotation.IDENTITY));
  }

  @Test
  void aPointAloneShiftsTheRoot() throws MechmlException {
    Root root = root("<point name='p' x='11' y='2' z='3'/>");
    assertThat(root).isEqualTo(new Root("Ground", new Vector3(10, 0, 0), Rotation.IDENTITY));
  }

  @Test
  void aVectorTurnsTheRootByTheLeastRotation() throws MechmlException {
    Root root = root("<point name='p' x='7' y='8' z='9'/><vector name='u' vx='0' vy='2' vz='0'/>");
    assertClose(root.orientation().apply(new Vector3(1, 0, 0)), new Vector3(0, 1, 0));
    assertClose(root.orientation().apply(new Vector3(0, 0, 1)), new Vector3(0, 0, 1));
    assertClose(world(root, POINT), new Vector3(7, 8, 9));
  }

  @RepeatedTest(20)
  void twoVectorsGiveTheFullPose(RepetitionInfo repetition) throws MechmlException {
    Random random = new Random(repetition.getCurrentRepetition());
    Vector3 axis =
        new Vector3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
            .normalized();
    Rotation pose = Rotation.about(axis, 6 * random.nextDouble());
    Root root =
        root(
            "<point name='p' x='7' y='8' z='9'/>"
                + vector("u", pose.apply(new Vector3(1, 0, 0)))
                + vector("w", pose.apply(new Vector3(0, 1, 0))));
    assertClose(root.orientation().apply(new Vector3(1, 0, 0)), pose.apply(new Vector3(1, 0, 0)));
    assertClose(root.orientation().apply(new Vector3(0, 0, 1)), pose.apply(new Vector3(0, 0, 1)));
    assertClose(world(root, POINT), new Vector3(7, 8, 9));
  }

  private static Vector3 world(Root root, Vector3 own) {
    return root.position().plus(root.orientation().apply(own));
  }

  private static String vector(String name, Vector3 v) {
    return "<vector name='%s' vx='%s' vy='%s' vz='%s'/>".formatted(name, v.x(), v.y(), v.z());
  }

  private static void assertClose(Vector3 actual, Vector3 expected) {
    assertThat(actual.minus(expected).norm()).isCloseTo(0, ROUNDING);
  }
}
