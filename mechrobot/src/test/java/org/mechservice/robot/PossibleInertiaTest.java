package org.mechservice.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.InertiaTensor;

/** Links whose inertia no body can have. */
class PossibleInertiaTest {
  private static final String URDF =
      """
      <robot name='r'><link name='base'/><link name='arm'><inertial><mass value='2'/>
      <inertia ixx='%s' iyy='%s' izz='%s' ixy='%s' ixz='0' iyz='0'/></inertial></link>
      <joint name='j' type='revolute'><parent link='base'/><child link='arm'/><axis xyz='0 0 1'/>
      <limit lower='-1' upper='1' effort='1' velocity='1'/></joint></robot>
      """;

  private static final String SDF =
      """
      <sdf version='1.9'><model name='r'><link name='arm'><inertial><mass>2</mass><inertia>
      <ixx>%s</ixx><iyy>%s</iyy><izz>%s</izz><ixy>%s</ixy></inertia></inertial></link></model></sdf>
      """;

  /** With ixx = iyy = a and ixy = b > a the moments are a - b, about (1, -1, 0), and a + b. */
  @ParameterizedTest
  @CsvSource({"0.1, 0.12", "1e-8, 1e-7", "0, 0.001", "0, 2.4e-35"})
  void negativeMomentBecomesZeroAndIsALoss(double a, double b) throws MechmlException {
    for (String format : new String[] {URDF, SDF}) {
      RobotImport robot =
          RobotImport.of("robot", format.formatted(a, a, a, b).getBytes(StandardCharsets.UTF_8));
      assertThat(robot.losses())
          .filteredOn(loss -> loss.code() == MessageCode.ROBOT_LOST)
          .singleElement()
          .satisfies(loss -> assertThat(loss.message()).contains("principal moments"));
      InertiaTensor inertia =
          robot.model().mechanism().bodies().stream()
              .filter(body -> body.name().equals("arm"))
              .findFirst()
              .orElseThrow()
              .inertia();
      // (a + b) n n' with n = (1, 1, 0)/sqrt 2, and a about z
      double rounding = 1e-15 * (a + b);
      assertThat(inertia.xx()).isCloseTo((a + b) / 2, within(rounding));
      assertThat(inertia.yy()).isCloseTo((a + b) / 2, within(rounding));
      assertThat(inertia.xy()).isCloseTo((a + b) / 2, within(rounding));
      assertThat(inertia.zz()).isCloseTo(a, within(rounding));
    }
  }

  @ParameterizedTest
  @CsvSource({"0.1, 0.09", "0.1, 0.1", "0.1, 0.1000000001"})
  void possibleMomentsStayToTheBit(double a, double b) throws MechmlException {
    for (String format : new String[] {URDF, SDF}) {
      RobotImport robot =
          RobotImport.of("robot", format.formatted(a, a, a, b).getBytes(StandardCharsets.UTF_8));
      assertThat(robot.losses()).noneMatch(loss -> loss.code() == MessageCode.ROBOT_LOST);
      assertThat(robot.model().mechanism().bodies())
          .anySatisfy(body -> assertThat(body.inertia().xy()).isEqualTo(b));
    }
  }
}
