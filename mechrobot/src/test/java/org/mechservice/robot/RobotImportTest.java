package org.mechservice.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.DocumentWriter;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.mechanism.Mechanism;

/** An imported robot is the robot. */
class RobotImportTest {
  /** Rounding through a dozen joints, and what the shortest decimals of vectors leave. */
  private static final double ROUNDING = 1e-12;

  private static final String ARM =
      """
      <robot name="r">
        <link name="base"/>
        <link name="arm">
          <inertial>
            <mass value="2"/>
            <inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/>
          </inertial>
        </link>
        <link name="tip">
          <inertial>
            <mass value="1"/>
            <inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/>
          </inertial>
        </link>
        <joint name="a" type="revolute">
          <parent link="base"/>
          <child link="arm"/>
          <axis xyz="0 1 0"/>
          <limit lower="0.25" upper="1"/>
          <dynamics damping="0.5" friction="0.3"/>
        </joint>
        <joint name="b" type="prismatic">
          <parent link="arm"/>
          <child link="tip"/>
          <limit lower="-1" upper="1"/>
          <mimic joint="a" multiplier="-2" offset="0.125"/>
        </joint>
      </robot>
      """;

  private static String imported(String urdf) throws MechmlException {
    return DocumentWriter.write(
        RobotImport.of("robot.urdf", urdf.getBytes(StandardCharsets.UTF_8)).document());
  }

  private static MechmlModel read(String text) throws MechmlException {
    return MechmlReader.read("robot.xml", text.getBytes(StandardCharsets.UTF_8));
  }

  /** Energies decide the equations of motion: these are Lagrange's. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void energiesAreThoseOfTheRobotInEveryState(long seed) throws MechmlException {
    RandomRobot robot = new RandomRobot(seed);
    MechmlModel model = read(imported(robot.urdf()));
    Mechanism mechanism = model.mechanism();
    DataDrivenModel equations = new DataDrivenModel(mechanism, model.settings().run());
    double[] first = new double[2];
    double[] offset = new double[2];
    for (int i = 0; i < 20; i++) {
      double[] y = robot.state();
      double[] energy = new double[2];
      equations.energy(0, y, energy);
      double[] expected = robot.energy(y, mechanism.positionCount());
      if (i == 0) {
        first = energy;
        offset = expected;
      }
      assertThat(energy[0]).isCloseTo(expected[0], within(ROUNDING * expected[0]));
      // Where potential energy is zero is anybody's choice.
      assertThat(energy[1] - first[1]).isCloseTo(expected[1] - offset[1], within(ROUNDING * 1e3));
    }
  }

  @Test
  void whatIsWrittenIsReadAsItWas() throws MechmlException {
    String text = imported(new RandomRobot(7).urdf());
    String again =
        DocumentWriter.write(
            MechmlReader.document("robot.xml", text.getBytes(StandardCharsets.UTF_8)));
    assertThat(again).isEqualTo(text);
  }

  @Test
  void dampingFrictionAndLimitsBecomeThoseOfTheJoint() throws MechmlException {
    assertThat(imported(ARM))
        .contains(
            "<joint name=\"a\" type=\"R\" damping=\"0.5\" friction=\"0.3\""
                + " frictionSpeed=\"angleFrictionSpeed\" lower=\"0.25\" upper=\"1\"");
  }

  @Test
  void jointThatFollowsAnotherIsCoupledToItAndStartsWhereItBelongs() throws MechmlException {
    String text = imported(ARM);
    assertThat(text)
        .contains(
            "<CoordConstraint name=\"b follows a\" constant=\"0.125\">",
            "<term joint=\"b\" factor=\"1\"/>",
            "<term joint=\"a\" factor=\"2\"/>",
            // As near to zero as its limits allow.
            "<jointVal name=\"a\" posVals=\"0.25\"/>",
            "<jointVal name=\"b\" posVals=\"-0.375\"/>");
    assertThat(read(text).mechanism().closures()).hasSize(1);
  }

  @Test
  void robotWithoutLossesHasNone() throws MechmlException {
    assertThat(RobotImport.of("robot.urdf", ARM.getBytes(StandardCharsets.UTF_8)).losses())
        .isEmpty();
  }

  /** base - l1 - l2 - ..., a hinge each. */
  private static String chain(int length) {
    StringBuilder text = new StringBuilder("<robot name='r'><link name='l0'/>");
    for (int i = 1; i <= length; i++) {
      text.append(
          ("<link name='l%d'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0'"
                  + " ixz='0' iyz='0'/></inertial></link><joint name='j%d' type='continuous'>"
                  + "<parent link='l%d'/><child link='l%d'/></joint>")
              .formatted(i, i, i - 1, i));
    }
    return text.append("</robot>").toString();
  }

  private static List<String> codes(String robot) {
    try {
      RobotImport.of("r.urdf", robot.getBytes(StandardCharsets.UTF_8));
      return List.of();
    } catch (MechmlException e) {
      return e.diagnostics().stream().map(said -> said.code().code()).distinct().toList();
    }
  }

  @Test
  void longChainIsReadAndOneBeyondTheLimitIsRefusedOnce() {
    assertThat(codes(chain(5_000))).isEmpty();
    assertThat(codes(chain(50_000))).containsExactly("M-004");
  }

  /** Each file with one thing wrong ends in one message about it. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<link name=\"tip\"> | <link name=\"arm\"> | M-015",
        "<joint name=\"b\" | <joint name=\"a\" | M-015",
        "<child link=\"tip\"/> | <child link=\"top\"/> | M-014",
        "<child link=\"tip\"/> | <child link=\"base\"/> | M-083",
        "<mass value=\"2\"/> | <mass value=\"NaN\"/> | M-082",
        "<mass value=\"2\"/> | <mass value=\"1e999\"/> | M-082",
        "joint=\"a\" multiplier | joint=\"b\" multiplier | M-084",
        "multiplier=\"-2\" | multiplier=\"inf\" | M-082",
        "type=\"prismatic\" | type=\"sliding\" | M-009",
        "<robot name=\"r\"> | <!DOCTYPE robot [<!ENTITY a '1'>]><robot name=\"r\"> | M-005"
      })
  void oneFaultIsOneMessage(String right, String wrong, String code) {
    assertThat(ARM).contains(right);
    assertThat(codes(ARM.replaceFirst(Pattern.quote(right), Matcher.quoteReplacement(wrong))))
        .containsExactly(code);
  }
}
