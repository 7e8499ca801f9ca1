package org.mechservice.solver.mechanism;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

class MechanismTest {
  @Test
  void outwardOrderPutsEveryParentFirstWhateverTheFileOrder() {
    // file order: j0 moves b0 on b1, j1 moves b1 on the root
    Mechanism mechanism = mechanism(2, joint("j0", 1, 0), joint("j1", Mechanism.ROOT, 1));
    assertThat(mechanism.outward()).containsExactly(1, 0);
  }

  @Test
  void statesKeepTheFileOrder() {
    Mechanism mechanism = mechanism(2, joint("j0", 1, 0), joint("j1", Mechanism.ROOT, 1));
    assertThat(mechanism.positionOffset(0)).isZero();
    assertThat(mechanism.positionOffset(1)).isEqualTo(1);
  }

  @Test
  void refusesABodyWithTwoJoints() {
    assertThatThrownBy(
            () -> mechanism(1, joint("j0", Mechanism.ROOT, 0), joint("j1", Mechanism.ROOT, 0)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("b0");
  }

  @Test
  void refusesABodyThatHangsOnNothing() {
    assertThatThrownBy(() -> mechanism(2, joint("j0", Mechanism.ROOT, 0)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("b1");
  }

  @Test
  void refusesBodiesThatHangOnEachOtherOnly() {
    assertThatThrownBy(() -> mechanism(2, joint("j0", 1, 0), joint("j1", 0, 1)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("root");
  }

  @Test
  void refusesABodyIndexThatIsNotThere() {
    assertThatThrownBy(() -> mechanism(1, joint("j0", 7, 0)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("j0");
  }

  @Test
  void drivenJointHasNoStates() {
    Mechanism mechanism = driven(new PrescribedMotion(0, List.of(Expression.ZERO)));
    assertThat(mechanism.positionOffset(0)).isEqualTo(-1);
    assertThat(mechanism.velocityOffset(1)).isZero();
    assertThat(mechanism.positionCount()).isEqualTo(1);
  }

  @Test
  void refusesAMotionWithAnotherNumberOfCoordinates() {
    assertThatThrownBy(() -> driven(new PrescribedMotion(0, List.of())))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("joint j0 has 1 coordinates but 0 motions");
  }

  @Test
  void refusesTwoMotionsOfOneJoint() {
    PrescribedMotion motion = new PrescribedMotion(1, List.of(Expression.ZERO));
    assertThatThrownBy(() -> driven(motion, motion)).hasMessage("joint j1 is driven twice");
  }

  private static Mechanism driven(PrescribedMotion... motions) {
    Mechanism free = mechanism(2, joint("j0", Mechanism.ROOT, 0), joint("j1", 0, 1));
    return new Mechanism(
        free.name(),
        free.root(),
        free.gravity(),
        free.bodies(),
        free.joints(),
        List.of(motions),
        free.startRoles(),
        List.of(),
        List.of(),
        List.of());
  }

  private static Mechanism mechanism(int bodyCount, Joint... joints) {
    List<Body> bodies =
        IntStream.range(0, bodyCount)
            .mapToObj(i -> new Body("b" + i, 1, Vector3.ZERO, InertiaTensor.ZERO, Origin.NONE))
            .toList();
    Root root = new Root("ground", Vector3.ZERO, Rotation.IDENTITY);
    return new Mechanism("m", root, Vector3.ZERO, bodies, List.of(joints));
  }

  private static Joint joint(String name, int parent, int child) {
    Attachment attachment =
        new Attachment(parent, Vector3.ZERO, child, Vector3.ZERO, Rotation.IDENTITY);
    return new Prismatic(name, attachment, new Vector3(1, 0, 0), 0, 0, Origin.NONE);
  }
}
