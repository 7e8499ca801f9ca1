package org.mechservice.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.closure.model.ProjectionModel;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * A robot is the same in URDF, SDF and MJCF. {@code benchmarks/peers/robots.py} compares public
 * robots with Pinocchio and MuJoCo; what differs between the formats is tried here.
 */
class RobotFormatsTest {
  /** Rounding through a few joints, and what the shortest decimals of vectors leave. */
  private static final double ROUNDING = 1e-12;

  private static final String URDF =
      """
      <robot name="r">
        <link name="base"/>
        <link name="arm"><inertial><origin xyz="0.1 0.2 -0.3" rpy="0.2 -0.4 0.6"/>
          <mass value="2"/>
          <inertia ixx="0.1" iyy="0.12" izz="0.15" ixy="0.01" ixz="-0.02" iyz="0.005"/>
        </inertial></link>
        <link name="tip"><inertial><origin xyz="0 0 0.4"/><mass value="1.5"/>
          <inertia ixx="0.03" iyy="0.03" izz="0.02" ixy="0" ixz="0" iyz="0"/></inertial></link>
        <joint name="a" type="revolute"><parent link="base"/><child link="arm"/>
          <origin xyz="0.3 -0.1 0.5" rpy="0.3 0.5 -0.7"/><axis xyz="1 2 2"/>
          <limit lower="-2" upper="2"/><dynamics damping="0.4"/></joint>
        <joint name="b" type="prismatic"><parent link="arm"/><child link="tip"/>
          <origin xyz="0 0.2 0.1" rpy="-0.4 0.1 0.9"/><axis xyz="0 3 4"/>
          <limit lower="-3" upper="3"/><dynamics damping="0.7"/></joint>
      </robot>
      """;

  /**
   * Poses of links are relative to their parents, as in URDF; the axis of b is given in the arm.
   */
  private static final String SDF =
      """
      <sdf version="1.9"><world name="w"><gravity>0 0 -9.81</gravity><model name="r">
        <link name="base"/>
        <link name="arm"><pose relative_to="base">0.3 -0.1 0.5 0.3 0.5 -0.7</pose>
          <inertial><pose>0.1 0.2 -0.3 0.2 -0.4 0.6</pose><mass>2</mass>
            <inertia><ixx>0.1</ixx><iyy>0.12</iyy><izz>0.15</izz><ixy>0.01</ixy><ixz>-0.02</ixz>
              <iyz>0.005</iyz></inertia></inertial></link>
        <link name="tip"><pose relative_to="arm">0 0.2 0.1 -0.4 0.1 0.9</pose>
          <inertial><pose>0 0 0.4 0 0 0</pose><mass>1.5</mass>
            <inertia><ixx>0.03</ixx><iyy>0.03</iyy><izz>0.02</izz></inertia></inertial></link>
        <frame name="along" attached_to="tip"/>
        <joint name="held" type="fixed"><parent>world</parent><child>base</child></joint>
        <joint name="a" type="revolute"><parent>base</parent><child>arm</child>
          <pose>2 4 4 0 0 0</pose>
          <axis><xyz>1 2 2</xyz><limit><lower>-2</lower><upper>2</upper></limit>
            <dynamics><damping>0.4</damping></dynamics></axis></joint>
        <joint name="b" type="prismatic"><parent>arm</parent><child>tip</child>
          <pose degrees="true">0 0 0 40 50 60</pose>
          <axis><xyz expressed_in="along">0 3 4</xyz>
            <limit><lower>-3</lower><upper>3</upper></limit>
            <dynamics><damping>0.7</damping></dynamics></axis></joint>
      </model></world></sdf>
      """;

  private static final String MJCF =
      """
      <mujoco model="r">
        <compiler angle="radian" eulerseq="XYZ"/>
        <default><joint damping="0.4"/><default class="slow"><joint damping="0.7"/></default>
        </default>
        <worldbody><body name="base">
          <inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>
          <frame pos="0.3 -0.1 0.5"><body name="arm" euler="0.3 0.5 -0.7">
            <joint name="a" axis="1 2 2" pos="2 4 4" range="-2 2"/>
            <inertial pos="0.1 0.2 -0.3" euler="0.2 -0.4 0.6" mass="2"
                fullinertia="0.1 0.12 0.15 0.01 -0.02 0.005"/>
            <body name="tip" pos="0 0.2 0.1" euler="-0.4 0.1 0.9" childclass="slow">
              <joint name="b" type="slide" axis="0 3 4" range="-3 3"/>
              <inertial pos="0 0 0.4" mass="1.5" diaginertia="0.03 0.03 0.02"/>
            </body>
          </body></frame>
        </body></worldbody>
      </mujoco>
      """;

  private static MechmlModel read(String robot) throws MechmlException {
    return RobotImport.of("robot", robot.getBytes(StandardCharsets.UTF_8)).model();
  }

  private static double[] accelerations(MechmlModel robot, double[] y) {
    double[] rate = new double[y.length];
    new DataDrivenModel(robot.mechanism(), robot.settings().run()).derivative(0, y, rate);
    return rate;
  }

  @Test
  void robotIsTheSameInThreeFormats() throws MechmlException {
    MechmlModel urdf = read(URDF);
    MechmlModel sdf = read(SDF);
    MechmlModel mjcf = read(MJCF);
    Random random = new Random(5);
    for (int i = 0; i < 20; i++) {
      double[] y = random.doubles(4, -1.5, 1.5).toArray();
      double[] expected = accelerations(urdf, y);
      assertThat(accelerations(sdf, y)).containsExactly(expected, within(ROUNDING * 100));
      assertThat(accelerations(mjcf, y)).containsExactly(expected, within(ROUNDING * 100));
    }
  }

  private static MechmlModel body(String parts) throws MechmlException {
    return read(
        "<mujoco><compiler angle='radian'/><worldbody><body><freejoint/>"
            + parts
            + "</body></worldbody></mujoco>");
  }

  /** Moments by the midpoint rule over slices across z: its error falls with their square. */
  @Test
  void capsuleIsTheSumOfItsSlices() throws MechmlException {
    double r = 0.2;
    double h = 0.3;
    MechmlModel robot = body("<geom type='capsule' size='0.2 0.3' density='700'/>");
    double mass = 0;
    double along = 0;
    double across = 0;
    int slices = 20_000;
    for (int i = 0; i < slices; i++) {
      double z = (h + r) * (2 * (i + 0.5) / slices - 1);
      double over = Math.max(0, Math.abs(z) - h);
      double square = r * r - over * over;
      double m = 700 * Math.PI * square * 2 * (h + r) / slices;
      mass += m;
      along += m * square / 2;
      across += m * (square / 4 + z * z);
    }
    assertThat(energy(robot, 1, 0, 0)).isCloseTo(across / 2, within(1e-7 * across));
    assertThat(energy(robot, 0, 0, 1)).isCloseTo(along / 2, within(1e-7 * along));
    assertThat(robot.mechanism().bodies().get(0).mass()).isCloseTo(mass, within(1e-7 * mass));
  }

  /** Returns the kinetic energy of a free body that turns. */
  private static double energy(MechmlModel robot, double x, double y, double z) {
    double[] state = {1, 0, 0, 0, 0, 0, 0, x, y, z, 0, 0, 0};
    double[] energy = new double[2];
    new DataDrivenModel(robot.mechanism(), robot.settings().run()).energy(0, state, energy);
    return energy[0];
  }

  /** Two equal spheres on a rod without mass: 2 m (2/5 r² + d²) across, 2 m 2/5 r² along. */
  @Test
  void shapesAddUpAboutTheirCommonCentre() throws MechmlException {
    MechmlModel robot =
        body(
            "<geom size='0.1' mass='3' pos='1 0 0.5'/><frame pos='1 0 0'>"
                + "<geom size='0.1' mass='3' pos='0 0 -0.5'/></frame>");
    double sphere = 2.0 / 5 * 0.01;
    // About the body's origin, 1 m beside the centre: the whole mass adds 6 kg · 1 m².
    assertThat(energy(robot, 0, 0, 1)).isCloseTo((6 * sphere + 6) / 2, within(ROUNDING));
    assertThat(energy(robot, 1, 0, 0)).isCloseTo((6 * sphere + 6 * 0.25) / 2, within(ROUNDING));
  }

  @Test
  void universalJointOfSdfIsTwoHinges() throws MechmlException {
    String ends =
        "<joint name='u' type='%s'><parent>world</parent><child>l</child>"
            + "<axis><xyz>1 0 0</xyz></axis><axis2><xyz>0 1 0</xyz></axis2></joint>";
    String sdf =
        "<sdf version='1.8'><model name='m'><link name='l'><inertial><pose>0 0 -1 0 0 0</pose>"
            + "<mass>2</mass><inertia><ixx>.1</ixx><iyy>.2</iyy><izz>.3</izz></inertia></inertial>"
            + "</link>"
            + ends.formatted("universal")
            + "</model></sdf>";
    String mjcf =
        "<mujoco><worldbody><body name='l'><joint name='u' axis='1 0 0'/><joint name='w'"
            + " axis='0 1 0'/><inertial pos='0 0 -1' mass='2' diaginertia='.1 .2 .3'/></body>"
            + "</worldbody></mujoco>";
    double[] y = {0.3, -0.8, 1.2, 0.4};
    assertThat(accelerations(read(sdf), y))
        .containsExactly(accelerations(read(mjcf), y), within(ROUNDING * 100));
  }

  private static String sdf(String parts) {
    return "<sdf version='1.8'><model name='m'>" + parts + "</model></sdf>";
  }

  @Test
  void linkWithoutJointFallsUnlessItsModelIsStatic() throws MechmlException {
    assertThat(read(sdf("<link name='l'/>")).mechanism().velocityCount()).isEqualTo(6);
    assertThat(
            read(sdf(
                    "<link name='l'/><model name='post'><static>true</static>"
                        + "<link name='foot'/></model>"))
                .mechanism()
                .velocityCount())
        .isEqualTo(6);
  }

  @Test
  void jointToALinkThatHasOneClosesALoop() throws MechmlException {
    Mechanism mechanism =
        read(sdf(
                "<link name='a'/><link name='b'><pose>1 0 0 0 0 0</pose></link>"
                    + "<joint name='1' type='revolute'><parent>world</parent><child>a</child>"
                    + "<axis><xyz>0 1 0</xyz></axis></joint>"
                    + "<joint name='2' type='revolute'><parent>a</parent><child>b</child>"
                    + "<axis><xyz>0 1 0</xyz></axis></joint>"
                    + "<joint name='3' type='revolute'><parent>world</parent><child>b</child>"
                    + "<pose>1 0 0 0 0 0</pose><axis><xyz>0 1 0</xyz></axis></joint>"))
            .mechanism();
    assertThat(mechanism.closures()).hasSize(1);
  }

  @Test
  void springPositionsCountFromThePoseOfTheFile() throws MechmlException {
    String text =
        "<mujoco><compiler angle='degree'/><worldbody><body name='l'><joint name='j'"
            + " stiffness='5' springref='30' ref='30' range='-60 90'/>"
            + "<inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/></body></worldbody></mujoco>";
    // At the pose of the file the spring is at rest.
    assertThat(accelerations(read(text), new double[] {0, 0})[1]).isCloseTo(0, within(ROUNDING));
    assertThat(accelerations(read(text), new double[] {0.1, 0})[1])
        .isCloseTo(-0.5, within(ROUNDING));
  }

  /**
   * A gear between two wheels about z, 1 and 0.4 kg·m²: a torque of 2 N·m at the first turns both
   * as one of 1 + 3² · 0.4 kg·m², the second -3 times as fast. The second hinge is written from the
   * wheel to the frame, and its axis and that of the gear point down.
   */
  @ParameterizedTest
  @CsvSource({"base, b, 1, 1, 3", "b, base, 1, 1, -3", "base, b, -1, 1, -3", "base, b, 1, -1, -3"})
  void gearTurnsTheSecondWheelByItsRatio(
      String parent, String child, int ofHinge, int ofGear, double factor) throws MechmlException {
    String wheel =
        "<link name='%s'><inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>%s</izz>"
            + "</inertia></inertial></link>";
    String hinge =
        "<joint name='%s' type='revolute'><parent>%s</parent><child>%s</child><axis><xyz>0 0 %d</xyz>"
            + "<dynamics>%s</dynamics></axis></joint>";
    MechmlModel robot =
        read(
            sdf(
                "<link name='base'/><joint name='w' type='fixed'><parent>world</parent>"
                    + "<child>base</child></joint>"
                    + wheel.formatted("a", "1")
                    + wheel.formatted("b", "0.4")
                    + hinge.formatted(
                        "ja",
                        "base",
                        "a",
                        1,
                        "<spring_stiffness>2</spring_stiffness>"
                            + "<spring_reference>1</spring_reference>")
                    + hinge.formatted("jb", parent, child, ofHinge, "")
                    + "<joint name='g' type='gearbox'><parent>a</parent><child>b</child>"
                    + "<axis><xyz>0 0 1</xyz></axis><axis2><xyz>0 0 "
                    + ofGear
                    + "</xyz></axis2><gearbox_ratio>3</gearbox_ratio>"
                    + "<gearbox_reference_body>base</gearbox_reference_body></joint>"));
    double[] a = acceleration(robot);
    int ja = velocity(robot, "ja");
    int jb = velocity(robot, "jb");
    assertThat(a[ja]).isCloseTo(2 / (1 + 9 * 0.4), within(ROUNDING));
    assertThat(a[jb]).isCloseTo(-factor * a[ja], within(ROUNDING));
  }

  private static int velocity(MechmlModel robot, String joint) {
    Mechanism mechanism = robot.mechanism();
    for (int i = 0; i < mechanism.joints().size(); i++) {
      if (mechanism.joints().get(i).name().equals(joint)) {
        return mechanism.velocityOffset(i);
      }
    }
    throw new AssertionError(joint);
  }

  /** Returns dv/dt of a closed mechanism at its start. */
  private static double[] acceleration(MechmlModel robot) {
    Mechanism mechanism = robot.mechanism();
    ClosedMechanism closed = new ClosedMechanism(mechanism, "DSR", robot.settings().run());
    double[] y = closed.start().state();
    double[] rate = new double[y.length];
    new ProjectionModel(closed, UserForceSource.NONE).derivative(0, y, rate);
    int at = mechanism.positionCount();
    return Arrays.copyOfRange(rate, at, at + mechanism.velocityCount());
  }

  private static List<String> codes(String robot) {
    try {
      return RobotImport.of("r", robot.getBytes(StandardCharsets.UTF_8)).losses().stream()
          .map(said -> said.code().code())
          .distinct()
          .toList();
    } catch (MechmlException e) {
      return e.diagnostics().stream().map(said -> said.code().code()).distinct().toList();
    }
  }

  /** Each file with one thing wrong ends in one message about it. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "type=\"prismatic\" | type=\"helical\" | M-009",
        "<child>tip</child> | <child>top</child> | M-014",
        "<child>tip</child> |  | M-081",
        "relative_to=\"arm\" | relative_to=\"tip\" | M-084",
        "relative_to=\"arm\" | relative_to=\"nothing\" | M-014",
        "<xyz>1 2 2</xyz> | <xyz>0 0 0</xyz> | M-033",
        "<mass>2</mass> | <mass>two</mass> | M-082",
        "<frame name=\"along\" | <frame name=\"tip\"/><frame name=\"along\" | M-015",
        "<link name=\"base\"/> | <include/><link name=\"base\"/> | M-096",
        "<lower>-2</lower> | <lower>5</lower> | M-084"
      })
  void oneFaultInSdfIsOneMessage(String right, String wrong, String code) {
    String text = wrong == null ? "" : wrong;
    assertThat(SDF).contains(right);
    assertThat(codes(SDF.replaceFirst(Pattern.quote(right), Matcher.quoteReplacement(text))))
        .containsExactly(code);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "type=\"slide\" | type=\"screw\" | M-009",
        "childclass=\"slow\" | childclass=\"fast\" | M-014",
        "name=\"b\" | name=\"a\" | M-015",
        "axis=\"0 3 4\" | axis=\"0 0 0\" | M-033",
        "mass=\"1.5\" | mass=\"much\" | M-082",
        "mass=\"1.5\" |  | M-081",
        "range=\"-2 2\" | range=\"2 -2\" | M-084",
        "angle=\"radian\" | angle=\"radian\" coordinate=\"global\" | M-080",
        "name=\"a\" axis | name=\"a\" armature=\"-1\" axis | M-084"
      })
  void oneFaultInMjcfIsOneMessage(String right, String wrong, String code) {
    String text = wrong == null ? "" : wrong;
    assertThat(MJCF).contains(right);
    assertThat(codes(MJCF.replaceFirst(Pattern.quote(right), Matcher.quoteReplacement(text))))
        .containsExactly(code);
  }
}
