package org.mechservice.mechml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/** Points, axes and the rotation at zero, as docs/mechml.md#joints defines them. */
class JointConventionTest {
  /** A dozen operations on numbers near 1. */
  private static final Offset<Double> ROUNDING = within(1e-14);

  @Test
  void vectorsAreNormalised() throws MechmlException {
    ModelText model =
        ModelText.of("R")
            .withGround("<point name='p' x='0' y='0' z='0'/>" + vector("u", 3, 0, 4))
            .withLink("<point name='p' x='0' y='0' z='0'/>" + vector("u", 0.3, 0, 0.4));
    assertThat(((Revolute) model.joint()).axis()).isEqualTo(new Vector3(0.6, 0, 0.8));
  }

  @Test
  void equalVectorsLeaveTheFramesExactlyParallel() throws MechmlException {
    ModelText model =
        ModelText.of("R")
            .withGround(point(0, 0, 0) + vector("u", 0.1, 0.7, -0.3))
            .withLink(point(0, 0, 0) + vector("u", 0.1, 0.7, -0.3));
    assertThat(model.joint().attachment().zeroRotation()).isEqualTo(Rotation.IDENTITY);
  }

  @RepeatedTest(20)
  void zeroRotationIsTheLeastThatBringsTheSecondVectorOntoTheFirst(RepetitionInfo repetition)
      throws MechmlException {
    Random random = new Random(repetition.getCurrentRepetition());
    Vector3 a1 = direction(random);
    Vector3 a2 = direction(random);
    ModelText model =
        ModelText.of("P")
            .withGround(point(1, 2, 3) + vector(a1))
            .withLink(point(0, 0, 0) + vector(a2));
    Rotation zero = model.joint().attachment().zeroRotation();
    assertClose(zero.apply(a2), a1);
    // The least rotation turns about a1 × a2 and so leaves that direction alone.
    assertClose(zero.apply(a1.cross(a2)), a1.cross(a2));
  }

  @RepeatedTest(20)
  void secondVectorsFixTheZeroOfTheAngle(RepetitionInfo repetition) throws MechmlException {
    Random random = new Random(repetition.getCurrentRepetition());
    Vector3 a1 = direction(random);
    Vector3 b1 = direction(random);
    Vector3 a2 = direction(random);
    Vector3 b2 = direction(random);
    ModelText model =
        ModelText.of("R")
            .withGround(point(0, 0, 0) + vector(a1) + vector("w", b1.x(), b1.y(), b1.z()))
            .withLink(point(0, 0, 0) + vector(a2) + vector("w", b2.x(), b2.y(), b2.z()))
            .withEnds(
                "name='Ground' point='p' vector='u' vector2='w'",
                "name='link' point='p' vector='u' vector2='w'");
    Rotation zero = model.joint().attachment().zeroRotation();
    assertClose(zero.apply(a2), a1);
    assertClose(zero.apply(normalPart(b2, a2)), normalPart(b1, a1));
  }

  @Test
  void oppositeVectorsAreFineWithSecondVectors() throws MechmlException {
    ModelText model =
        ModelText.of("R")
            .withGround(point(0, 0, 0) + vector("u", 0, 0, 1) + vector("w", 1, 0, 0))
            .withLink(point(0, 0, 0) + vector("u", 0, 0, -1) + vector("w", 1, 0, 0))
            .withEnds(
                "name='Ground' point='p' vector='u' vector2='w'",
                "name='link' point='p' vector='u' vector2='w'");
    Rotation zero = model.joint().attachment().zeroRotation();
    assertClose(zero.apply(new Vector3(0, 0, -1)), new Vector3(0, 0, 1));
    assertClose(zero.apply(new Vector3(1, 0, 0)), new Vector3(1, 0, 0));
  }

  @Test
  void pointsAreThoseNamed() throws MechmlException {
    ModelText model =
        ModelText.of("R")
            .withGround(point(1, 2, 3) + vector("u", 1, 0, 0))
            .withLink(point(4, 5, 6) + vector("u", 1, 0, 0));
    Attachment attachment = model.joint().attachment();
    assertThat(attachment.parentPoint()).isEqualTo(new Vector3(1, 2, 3));
    assertThat(attachment.childPoint()).isEqualTo(new Vector3(4, 5, 6));
  }

  /** body1 is the outer body: the tree needs the other direction. */
  @ParameterizedTest
  @ValueSource(strings = {"R", "P"})
  void jointWrittenFromTheOuterBodyKeepsItsSense(String type) throws MechmlException {
    ModelText outward =
        ModelText.of(type)
            .withGround(point(1, 0, 0) + vector("u", 0.6, 0.8, 0))
            .withLink(point(0, 2, 0) + vector("u", 0, 0, 1))
            .withJointVal("<jointVal name='j' posVals='0.3' velVals='0.7'/>");
    ModelText inward =
        outward.withEnds("name='link' point='p' vector='u'", "name='Ground' point='p' vector='u'");
    Joint expected = outward.joint();
    Joint joint = inward.joint();
    assertThat(joint.attachment().parent()).isEqualTo(Mechanism.ROOT);
    assertThat(joint.attachment().child()).isZero();
    assertThat(joint.attachment().parentPoint()).isEqualTo(expected.attachment().parentPoint());
    assertThat(joint.attachment().childPoint()).isEqualTo(expected.attachment().childPoint());
    assertClose(axis(joint), axis(expected).negated());
    assertThat(initialState(joint)).containsExactly(0.3, 0.7);
  }

  @Test
  void jointsStandInFileOrderWhateverTheTreeNeeds() throws Exception {
    String text = Resources.text("FiveBarPendulum.xml");
    int first = text.indexOf("<joint name=\"j1\"");
    int second = text.indexOf("<joint name=\"j2\"");
    String swapped =
        text.substring(0, first)
            + text.substring(second, text.indexOf("</Joints>"))
            + text.substring(first, second)
            + text.substring(text.indexOf("</Joints>"));
    Mechanism mechanism =
        MechmlReader.read("swapped.xml", swapped.getBytes(java.nio.charset.StandardCharsets.UTF_8))
            .mechanism();
    assertThat(mechanism.joints())
        .extracting(Joint::name)
        .containsExactly("j2", "j3", "j4", "j5", "j1");
    assertThat(mechanism.outward()).containsExactly(4, 0, 1, 2, 3);
  }

  private static Vector3 axis(Joint joint) {
    return joint instanceof Revolute revolute ? revolute.axis() : ((Prismatic) joint).axis();
  }

  private static double[] initialState(Joint joint) {
    double[] state = new double[2];
    joint.initialPositions(state, 0);
    joint.initialVelocities(state, 1);
    return state;
  }

  private static Vector3 normalPart(Vector3 b, Vector3 a) {
    return b.minus(a.times(a.dot(b))).normalized();
  }

  private static Vector3 direction(Random random) {
    return new Vector3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
        .normalized();
  }

  private static String point(double x, double y, double z) {
    return "<point name='p' x='%s' y='%s' z='%s'/>".formatted(x, y, z);
  }

  private static String vector(Vector3 v) {
    return vector("u", v.x(), v.y(), v.z());
  }

  private static String vector(String name, double x, double y, double z) {
    return "<vector name='%s' vx='%s' vy='%s' vz='%s'/>".formatted(name, x, y, z);
  }

  private static void assertClose(Vector3 actual, Vector3 expected) {
    assertThat(actual.minus(expected).norm()).isCloseTo(0, ROUNDING);
  }
}
