package org.mechservice.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.catalogue.MessageCode;

/** What MuJoCo 4.0 refuses is refused: it would mean one thing here and another there. */
class MjcfRefusalTest {
  private static final String MODEL =
      """
      <mujoco><worldbody><body name='a' BODY><joint name='j' axis='0 1 0' JOINT/>
      <geom size='0.1 0.1' GEOM/></body></worldbody>
      <tendon><spatial name='t'><site site='s'/><site site='w'/></spatial></tendon>
      <actuator>MOTOR</actuator></mujoco>
      """;

  private static RobotImport read(String place, String text) throws MechmlException {
    String model =
        MODEL
            .replace(place, text)
            .replaceAll("BODY|JOINT|GEOM|MOTOR", "")
            .replace("<geom", "<site name='s' pos='0.3 0 0'/><geom")
            .replace("<body name", "<site name='w' pos='1 0 1'/><body name");
    return RobotImport.of("robot", model.getBytes(StandardCharsets.UTF_8));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "JOINT | range='1 -1' | its range is empty",
        "JOINT | range='0.5 0.5' | its range is empty",
        "BODY | quat='1 0 0 0' euler='0 0 3' | several orientations",
        "BODY | mocap='true' | moved from outside",
        "GEOM | fromto='0 0 0 0 0 1' | no two ends",
        "GEOM | type='capsule' pos='0 0 1' fromto='0 0 0 0 0 1' | two ends",
        "MOTOR | <motor name='m'/> | a joint, tendon, site or body",
        "MOTOR | <position joint='j' inheritrange='1'/> | no range",
        "MOTOR | <position joint='j' kv='1' dampratio='0'/> | kv and dampratio",
        "MOTOR | <position joint='j' ctrlrange='0 1' inheritrange='1'/> | leave one of them out",
        "MOTOR | <motor joint='j' ctrllimited='true'/> | ctrlrange is missing or empty",
        "MOTOR | <motor joint='j' forcelimited='true' forcerange='1 0'/> | forcerange is missing",
        "MOTOR | <damper joint='j' kv='1'/> | a damper needs a ctrlrange",
        "MOTOR | <general joint='j' actrange='0 1'/> | no activation",
        "MOTOR | <general joint='j' dyntype='filter' actlimited='true'/> | actrange is missing",
        "MOTOR | <motor joint='j' delay='0.1'/> | needs nsample",
        "JOINT | type='ball' range='-1 1' | write 0 as its lower end",
        "JOINT | group='1.5' | takes whole ones",
        "GEOM | type='mesh' mesh='m' shellinertia='true' | not for meshes",
      })
  void contradictionsAreNamed(String place, String text, String said) {
    assertThatThrownBy(() -> read(place, text))
        .isInstanceOf(MechmlException.class)
        .hasMessageContaining(said);
  }

  private static RobotImport read(String model) throws MechmlException {
    return RobotImport.of("robot", model.getBytes(StandardCharsets.UTF_8));
  }

  /** What MuJoCo 4.0 refuses and what stands next to it, which it takes. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "diaginertia='1 1 2.1' | diaginertia='1 1 2' | | | sum of the others",
        "fullinertia='1 1 2.1 0 0 0' | fullinertia='1 1 2 0 0 0' | | | sum of the others",
        "diaginertia='1 1 1' fullinertia='1 1 1 0 0 0' | diaginertia='1 1 1' | | | leave one",
        "diaginertia='1 1 1' | diaginertia='1 1 1' | range='0 1' | range='0 1' limited='true'"
            + " | autolimits is off",
        "diaginertia='1 1 1' | diaginertia='1 1 1' | actuatorfrcrange='0 1' | actuatorfrcrange='0 0'"
            + " | autolimits is off",
      })
  void whatMujocoRefusesIsRefusedAndNoMore(
      String inertia, String taken, String joint, String takenJoint, String said)
      throws MechmlException {
    String model =
        "<mujoco><compiler autolimits='false'/><worldbody><body><joint %s/>"
            + "<inertial pos='0 0 0' mass='1' %s/></body></worldbody></mujoco>";
    String wrong = model.formatted(joint == null ? "" : joint, inertia);
    assertThatThrownBy(() -> read(wrong))
        .isInstanceOf(MechmlException.class)
        .hasMessageContaining(said);
    assertThat(read(model.formatted(takenJoint == null ? "" : takenJoint, taken)).losses())
        .noneMatch(MjcfRefusalTest::changesTheMotion);
  }

  /** MuJoCo bounds the sum of all motors of a joint, those of tendons over sites among them. */
  @Test
  void boundsThatMotorsOfSitesPassByAreALoss() throws MechmlException {
    String pull = "<motor tendon='t'/>";
    assertThat(read("MOTOR", pull).losses()).noneMatch(MjcfRefusalTest::changesTheMotion);
    String model = pull + "</actuator><actuator><motor joint='j'/>";
    assertThat(read("JOINT", "actuatorfrcrange='-1 1'").losses())
        .noneMatch(MjcfRefusalTest::changesTheMotion);
    RobotImport both =
        RobotImport.of(
            "robot",
            MODEL
                .replace("MOTOR", model)
                .replace("JOINT", "actuatorfrcrange='-1 1'")
                .replaceAll("BODY|GEOM", "")
                .replace("<geom", "<site name='s' pos='0.3 0 0'/><geom")
                .replace("<body name", "<site name='w' pos='1 0 1'/><body name")
                .getBytes(StandardCharsets.UTF_8));
    assertThat(both.losses())
        .filteredOn(MjcfRefusalTest::changesTheMotion)
        .singleElement()
        .satisfies(loss -> assertThat(loss.message()).contains("actuatorfrcrange"));
  }

  private static boolean changesTheMotion(Diagnostic loss) {
    return loss.code() == MessageCode.ROBOT_LOST;
  }
}
