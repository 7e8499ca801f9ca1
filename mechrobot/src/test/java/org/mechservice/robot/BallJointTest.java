package org.mechservice.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.DocumentWriter;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.PairLaw;
import org.mechservice.solver.mechanism.force.LawForce;

/**
 * Damping and dry friction of balls from MJCF; motion beside MuJoCo is in {@link MjcfMotionTest}.
 */
class BallJointTest {
  private static RobotImport ball(String attributes) throws MechmlException {
    String text =
        "<mujoco><worldbody><body><joint name='j' type='ball' "
            + attributes
            + "/><geom size='0.1' pos='0.2 0 0'/></body></worldbody></mujoco>";
    return RobotImport.of("r.xml", text.getBytes(StandardCharsets.UTF_8));
  }

  @Test
  void dampingIsAnAttributeOfTheJoint() throws MechmlException {
    RobotImport robot = ball("damping='0.4'");
    assertThat(DocumentWriter.write(robot.document())).contains("damping=\"0.4\"");
    assertThat(robot.losses()).extracting(Diagnostic::code).doesNotContain(LossGrade.MOTION.code());
  }

  /** MuJoCo bounds the torque along each axis of the body, so that it is larger across them. */
  @Test
  void frictionActsAndItsDifferenceIsTold() throws MechmlException {
    RobotImport robot = ball("frictionloss='0.3'");
    assertThat(robot.model().mechanism().forces())
        .singleElement()
        .isInstanceOfSatisfying(
            LawForce.class,
            force -> {
              assertThat(force.law()).isEqualTo(PairLaw.ROTATION_FRICTION);
              assertThat(force.numbers().get(1)).isEqualTo(new Expression.Constant(0.3));
            });
    assertThat(robot.losses())
        .filteredOn(loss -> loss.code() == LossGrade.MOTION.code())
        .singleElement()
        .satisfies(loss -> assertThat(loss.message()).contains("along each of three axes"));
  }
}
