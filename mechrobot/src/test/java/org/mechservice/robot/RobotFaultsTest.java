package org.mechservice.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.DocumentWriter;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.Vector3;

/** What robots could lose on their way in: files, frames, masses, names, starts. */
class RobotFaultsTest {
  /** Rounding through a few frames. */
  private static final double ROUNDING = 1e-12;

  private static final String INERTIAL =
      "<inertial><pose>0.1 0.2 -0.3 0.3 0.2 0.1</pose><mass>2</mass><inertia><ixx>0.2</ixx>"
          + "<iyy>0.3</iyy><izz>0.4</izz><ixy>0.01</ixy></inertia></inertial>";

  @TempDir private Path folder = Path.of("");

  private static RobotImport read(String text) throws MechmlException {
    return RobotImport.of("robot", text.getBytes(StandardCharsets.UTF_8));
  }

  private static String mechml(RobotImport robot) {
    return DocumentWriter.write(robot.document());
  }

  private static List<String> codes(List<Diagnostic> said) {
    return said.stream().map(one -> one.code().code()).distinct().toList();
  }

  private static double[] accelerations(MechmlModel model, double... state) {
    Mechanism mechanism = model.mechanism();
    DataDrivenModel equations = new DataDrivenModel(mechanism, model.settings().run());
    double[] y = new double[mechanism.stateCount()];
    System.arraycopy(state, 0, y, 0, state.length);
    double[] rate = new double[y.length];
    equations.derivative(0, y, rate);
    double[] a = new double[mechanism.velocityCount()];
    System.arraycopy(rate, mechanism.positionCount(), a, 0, a.length);
    return a;
  }

  private static void assertSame(MechmlModel one, MechmlModel other, double... state) {
    double[] expected = accelerations(other, state);
    double[] a = accelerations(one, state);
    for (int i = 0; i < a.length; i++) {
      assertThat(a[i]).isCloseTo(expected[i], within(ROUNDING * (1 + Math.abs(expected[i]))));
    }
  }

  private Path write(String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    return Files.writeString(file, text);
  }

  private RobotImport imported(Path file, String... paths) throws IOException, MechmlException {
    List<Path> sought = List.of(paths).stream().map(folder::resolve).toList();
    return RobotImport.read(
        file,
        new ImportOptions(Optional.empty(), Optional.empty(), false, sought, Optional.empty()));
  }

  // Files.

  private static final String ARM =
      "<body name='arm'><joint name='j' axis='0 1 0'/><geom size='0.1' pos='0.3 0 0'/></body>";

  @Test
  void includedPartsOfMjcfStandInTheirPlaces() throws IOException, MechmlException {
    write("defaults.xml", "<x><default><geom density='300'/></default></x>");
    write("parts/arm.xml", "<mujocoinclude>" + ARM + "</mujocoinclude>");
    Path main =
        write(
            "main.xml",
            "<mujoco><include file='defaults.xml'/><worldbody><include file='parts/arm.xml'/>"
                + "</worldbody></mujoco>");
    MechmlModel whole =
        read("<mujoco><default><geom density='300'/></default><worldbody>"
                + ARM
                + "</worldbody></mujoco>")
            .model();
    assertSame(imported(main).model(), whole, 0.3, -0.2);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "<include file='nowhere.xml'/>",
        "<include file='main.xml'/>",
        "<include file='broken.xml'/>",
      })
  void includeThatCannotBeReadIsNamed(String include) throws IOException {
    write("broken.xml", "<mujoco><worldbody>");
    Path main =
        write("main.xml", "<mujoco>" + include + "<worldbody>" + ARM + "</worldbody></mujoco>");
    assertThatThrownBy(() -> imported(main))
        .isInstanceOf(MechmlException.class)
        .hasMessageMatching("(?s).*(M-096|M-001).*");
  }

  /** Messages about an included file name it. */
  @Test
  void faultInAnIncludedFileIsPlacedThere() throws IOException {
    Path part = write("arm.xml", "<x>\n<body name='a' gravitcomp='1'/></x>");
    Path main =
        write("main.xml", "<mujoco><worldbody><include file='arm.xml'/></worldbody></mujoco>");
    assertThatThrownBy(() -> imported(main)).hasMessageContaining(part + ":2:1: M-007");
  }

  @Test
  void attachedModelKeepsItsUnitsAndClasses() throws IOException, MechmlException {
    write(
        "sub.xml",
        "<mujoco><compiler angle='radian'/><default><joint damping='0.3'/></default><worldbody>"
            + "<body name='s' pos='0 0 -0.5' euler='0.3 0 0'><joint name='k' axis='1 0 0'/>"
            + "<geom size='0.05' pos='0 0 -0.2'/></body></worldbody></mujoco>");
    Path main =
        write(
            "main.xml",
            "<mujoco><asset><model name='sub' file='sub.xml'/></asset><worldbody><body name='a'>"
                + "<joint name='j' axis='0 1 0'/><geom size='0.1' pos='0.3 0 0'/>"
                + "<attach model='sub' body='s' prefix='p_'/></body></worldbody></mujoco>");
    RobotImport robot = imported(main);
    assertThat(mechml(robot)).contains("<body name=\"p_s\"", "<joint name=\"p_k\"");
    MechmlModel written =
        read("<mujoco><worldbody><body name='a'><joint name='j' axis='0 1 0'/>"
                + "<geom size='0.1' pos='0.3 0 0'/><body pos='0 0 -0.5' euler='"
                + Math.toDegrees(0.3)
                + " 0 0'><joint axis='1 0 0' damping='0.3'/><geom size='0.05' pos='0 0 -0.2'/>"
                + "</body></body></worldbody></mujoco>")
            .model();
    assertSame(robot.model(), written, 0.3, 0.2, 0.5, -0.7);
  }

  @Test
  void modelWithoutANameAmongTheAssetsHasThatOfItsFile() throws IOException, MechmlException {
    write("sub.xml", "<mujoco model='Arm'><worldbody>" + ARM + "</worldbody></mujoco>");
    Path main =
        write(
            "main.xml",
            "<mujoco><asset><model file='sub.xml'/></asset><worldbody>"
                + "<attach model='Arm' body='arm' prefix='p_'/></worldbody></mujoco>");
    MechmlModel whole = read("<mujoco><worldbody>" + ARM + "</worldbody></mujoco>").model();
    assertSame(imported(main).model(), whole, 0.3, -0.2);
  }

  @Test
  void partOfTheFileItselfIsAttached() throws MechmlException {
    MechmlModel twice =
        read("<mujoco><worldbody><frame name='f'>"
                + ARM
                + "</frame><frame pos='0 1 0'><attach frame='f' prefix='p_'/></frame>"
                + "</worldbody></mujoco>")
            .model();
    double[] a = accelerations(twice, 0.3, 0.3, -0.2, -0.2);
    assertThat(a[0]).isNotZero().isEqualTo(a[1]);
  }

  /**
   * A mass of 2 kg hangs on a tendon at its upper end: it sinks by weight over stiffness, and the
   * stiffness is mass over the square of time constant and damping ratio.
   */
  @ParameterizedTest
  @ValueSource(strings = {"spatial", "fixed"})
  void tendonIsHeldAtTheEndsOfItsRange(String kind) throws MechmlException {
    String way =
        kind.equals("spatial")
            ? "<site site='top'/><site site='hook'/>"
            : "<joint joint='j' coef='-1'/>";
    String range = kind.equals("spatial") ? "0 0.5" : "-1 0";
    RobotImport robot =
        read(
            "<mujoco><worldbody><site name='top' pos='0 0 1'/><body name='b' pos='0 0 0.5'>"
                + "<joint name='j' type='slide' axis='0 0 1'/><inertial mass='2' pos='0 0 0'"
                + " diaginertia='1 1 1'/><site name='hook'/></body></worldbody><tendon><"
                + kind
                + " range='"
                + range
                + "' solreflimit='0.1 0.5'>"
                + way
                + "</"
                + kind
                + "></tendon></mujoco>");
    assertThat(codes(robot.losses())).doesNotContain("M-085");
    double k = 2 / Math.pow(0.1 * 0.5, 2);
    double sunk = 2 * 9.81 / k;
    assertThat(accelerations(robot.model(), -sunk, 0)[0]).isCloseTo(0, within(1e-12));
    assertThat(accelerations(robot.model(), 0.01, 0)[0]).isCloseTo(-9.81, within(1e-12));
    assertThat(accelerations(robot.model(), -2 * sunk, 0)[0]).isCloseTo(9.81, within(1e-12));
    double c = 2 * 2 / 0.1;
    assertThat(accelerations(robot.model(), -sunk, -1e-3)[0])
        .isCloseTo(c * 1e-3 / 2, within(1e-12));
  }

  @Test
  void keyOfAnAlignedJointIsALoss() throws IOException, MechmlException {
    Path file =
        write(
            "aligned.xml",
            "<mujoco><worldbody><body><freejoint align='true'/><geom size='0.1' pos='1 0 0'/></body>"
                + "</worldbody><keyframe><key name='k' qpos='0 0 0 1 0 0 0'/></keyframe></mujoco>");
    RobotImport robot =
        RobotImport.read(
            file,
            new ImportOptions(
                Optional.empty(), Optional.of("k"), false, List.of(), Optional.empty()));
    assertThat(codes(robot.losses())).contains("M-085");
  }

  @Test
  void modelThatAttachesItselfIsRefused() throws IOException {
    Path main =
        write(
            "main.xml",
            "<mujoco><asset><model name='m' file='main.xml'/></asset><worldbody><body name='a'><joint/>"
                + "<geom size='1'/><attach model='m' body='a' prefix='p_'/></body></worldbody></mujoco>");
    assertThatThrownBy(() -> imported(main)).hasMessageContaining("20 deep");
  }

  /** Two replicates with the same suffixes, and shapes beside bodies in them. */
  @Test
  void motorOfReplicasIsReadOnceForEach() throws MechmlException {
    String one =
        "<replicate count='2' offset='0 1 0'><geom size='0.1'/><body name='%1$s'><joint name='j%1$s'"
            + " axis='0 1 0'/><geom size='0.1' pos='0.3 0 0'/></body></replicate>";
    String text =
        mechml(
            read(
                "<mujoco><worldbody>"
                    + one.formatted("a")
                    + one.formatted("b")
                    + "</worldbody><actuator><motor name='m' joint='ja'/><motor name='n' joint='jb'/>"
                    + "</actuator></mujoco>"));
    assertThat(text.lines().filter(line -> line.contains("<input ")))
        .extracting(line -> line.replaceAll(".*name=\"([^\"]*)\".*", "$1"))
        .containsExactlyInAnyOrder("m0", "m1", "n0", "n1");
  }

  @Test
  void replicasWithoutEndAreRefused() {
    String inner = "<replicate count='1000'><geom size='1'/></replicate>";
    assertThatThrownBy(
            () ->
                read(
                    "<mujoco><worldbody><replicate count='1000'><body><joint/>"
                        + inner
                        + "</body></replicate></worldbody></mujoco>"))
        .hasMessageContaining("M-004");
  }

  @Test
  void meshesOfMjcfGiveMassesFromTheirFolder() throws IOException, MechmlException {
    write(
        "meshes/tetra.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    String text =
        "<mujoco><compiler meshdir='meshes'/><asset><mesh file='tetra.obj'/></asset><worldbody>"
            + "<body name='a'><joint axis='0 1 0'/><geom type='mesh' mesh='tetra'/></body></worldbody>"
            + "</mujoco>";
    Body body = imported(write("main.xml", text)).model().mechanism().bodies().get(0);
    // A sixth of a cubic metre of water.
    assertThat(body.mass()).isCloseTo(1000 / 6.0, within(1e-9));
    // Without its folder the mass is lost, and that is said.
    assertThat(codes(read(text).losses())).contains("M-085");
  }

  @Test
  void includedModelsOfSdfMayBePackages() throws IOException, MechmlException {
    write(
        "models/arm/model.config",
        "<model><sdf version='1.5'>old.sdf</sdf><sdf version='1.9'>arm.sdf</sdf></model>");
    write(
        "models/arm/arm.sdf",
        "<sdf version='1.9'><model name='arm'><link name='l'>"
            + INERTIAL
            + "</link></model></sdf>");
    Path main =
        write(
            "worlds/main.world",
            "<sdf version='1.9'><world name='w'><include><uri>model://arm</uri><name>left</name>"
                + "<pose>1 2 3 0 0 0</pose></include><include><uri>model://arm</uri></include>"
                + "</world></sdf>");
    String text = mechml(imported(main, "models"));
    assertThat(text)
        .contains("<body name=\"left::l\"", "<body name=\"arm::l\"", "x=\"1\" y=\"2\" z=\"3\"");
    assertThatThrownBy(() -> imported(main)).hasMessageContaining("M-096", "--path");
  }

  // Frames.

  @Test
  void placementFrameIsWhereTheModelIs() throws MechmlException {
    String model =
        "<link name='base'>%2$s</link><joint name='w' type='fixed'><parent>world</parent>"
            + "<child>base</child></joint><link name='l1'><pose>0.2 0.1 0.5 0.3 -0.4 0.5</pose>%2$s"
            + "</link><joint name='j' type='revolute'><parent>base</parent><child>l1</child><axis>"
            + "<xyz>0 1 0.2</xyz></axis></joint></model></sdf>";
    String placed =
        ("<sdf version='1.9'><model name='m' placement_frame='l1'><pose>1 2 3 0.3 0.2 0.1</pose>"
                + model)
            .formatted("", INERTIAL);
    // The same by hand: the link is where the pose says, and the base beyond it.
    Robot.Frame link =
        Robot.Frame.ofRollPitchYaw(new Vector3(0.2, 0.1, 0.5), new Vector3(0.3, -0.4, 0.5));
    Robot.Frame pose = Robot.Frame.ofRollPitchYaw(new Vector3(1, 2, 3), new Vector3(0.3, 0.2, 0.1));
    Robot.Frame base = pose.times(link.inverse());
    List<Double> e = base.eulerParameters();
    String byHand =
        ("<sdf version='1.9'><model name='m'><pose rotation_format='quat_xyzw'>%s %s %s %s %s %s %s"
                    + "</pose>")
                .formatted(
                    base.at().x(),
                    base.at().y(),
                    base.at().z(),
                    e.get(1),
                    e.get(2),
                    e.get(3),
                    e.get(0))
            + model.formatted("", INERTIAL);
    assertSame(read(placed).model(), read(byHand).model(), 0.4, -0.3);
  }

  @Test
  void quaternionsOfUrdfAreFrames() throws MechmlException {
    String robot =
        "<robot name='r' version='1.1'><link name='b'/><link name='l'><inertial><origin xyz='1 2 3'/>"
            + "<mass value='2'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial>"
            + "</link><joint name='j' type='continuous'><parent link='b'/><child link='l'/>"
            + "<origin xyz='0.1 0.2 0.3' %s/><axis xyz='0 1 0'/></joint></robot>";
    // A third of a turn about (1, 1, 1): x to y to z to x.
    MechmlModel quaternion = read(robot.formatted("quat_xyzw='0.5 0.5 0.5 0.5'")).model();
    MechmlModel angles =
        read(robot.formatted("rpy='" + Math.PI / 2 + " 0 " + Math.PI / 2 + "'")).model();
    assertSame(quaternion, angles, 0.3, 0.2);
  }

  // Masses.

  /** A box of 0.1, 0.2 and 0.3 m with 500 kg/m³. */
  @Test
  void automaticInertiaOfSdfIsThatOfItsShapes() throws MechmlException {
    String text =
        "<sdf version='1.11'><model name='m'><link name='l1'><inertial auto='true'>%s<density>500"
            + "</density></inertial><collision name='c'><pose>1 0 0 0 0 0</pose><geometry><box>"
            + "<size>0.1 0.2 0.3</size></box></geometry></collision></link></model></sdf>";
    Body body = read(text.formatted("")).model().mechanism().bodies().get(0);
    assertThat(body.mass()).isCloseTo(3, within(ROUNDING));
    assertThat(body.centerOfMass().x()).isCloseTo(1, within(ROUNDING));
    assertThat(body.inertia().xx()).isCloseTo(3 * (0.04 + 0.09) / 12, within(ROUNDING));
    // A mass that is given holds.
    Body heavy = read(text.formatted("<mass>6</mass>")).model().mechanism().bodies().get(0);
    assertThat(heavy.inertia().xx()).isCloseTo(6 * (0.04 + 0.09) / 12, within(ROUNDING));
  }

  @Test
  void secondWorldAndAddedMassAreLossesOfMotion() throws MechmlException {
    String world =
        "<world name='%s'><model name='a'><link name='l'>" + INERTIAL + "</link></model></world>";
    assertThat(
            codes(
                read("<sdf version='1.9'>" + world.formatted("w") + world.formatted("v") + "</sdf>")
                    .losses()))
        .containsExactly("M-085");
  }

  /** The robot goes out and comes back, floating: its accelerations need the root's mass. */
  @Test
  void exportKeepsTheMassOfTheRoot() throws MechmlException {
    String urdf =
        "<robot name='r'><link name='trunk'><inertial><origin xyz='0.1 0 0'/><mass value='6'/>"
            + "<inertia ixx='0.1' iyy='0.2' izz='0.3' ixy='0.01' ixz='0' iyz='0'/></inertial></link>"
            + "<link name='leg'><inertial><origin xyz='0 0 -0.1'/><mass value='1'/><inertia ixx='0.01'"
            + " iyy='0.01' izz='0.001' ixy='0' ixz='0' iyz='0'/></inertial></link><joint name='hip'"
            + " type='revolute'><origin xyz='0.2 0 0'/><parent link='trunk'/><child link='leg'/>"
            + "<axis xyz='0 1 0'/><limit lower='-1' upper='1'/></joint></robot>";
    String model = mechml(read(urdf));
    byte[] bytes = model.getBytes(StandardCharsets.UTF_8);
    RobotExport back =
        RobotExport.of("m", MechmlReader.read("m", bytes), MechmlReader.whole("m", bytes));
    assertThat(back.losses()).isEmpty();
    ImportOptions floating =
        new ImportOptions(Optional.empty(), Optional.empty(), true, List.of(), Optional.empty());
    MechmlModel there =
        RobotImport.read("r", urdf.getBytes(StandardCharsets.UTF_8), folder, floating).model();
    MechmlModel again =
        RobotImport.read("r", back.text().getBytes(StandardCharsets.UTF_8), folder, floating)
            .model();
    assertSame(again, there, 1, 0, 0, 0, 0, 0, 0, 0.3, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7);
    assertThat(there.mechanism().velocityCount()).isEqualTo(7);
  }

  /**
   * The pose of the file closes the loops of a robot, even where a joint is outside of its range,
   * as the legs of Cassie are. Without loops joints start within their ranges.
   */
  @ParameterizedTest
  @CsvSource({"<connect body1='b' body2='c' anchor='1 0 0'/>, 0", "'', 0.3"})
  void loopsStartInThePoseOfTheFile(String equality, double start) throws MechmlException {
    String text =
        """
        <mujoco><compiler angle="radian"/><worldbody>
          <body name="a"><joint name="j" axis="0 1 0" range="0.3 1"/><geom size="0.1"/>
            <body name="b" pos="0 0 1"><joint axis="0 1 0"/><geom size="0.1"/></body></body>
          <body name="c" pos="1 0 0"><joint axis="0 1 0"/><geom size="0.1" pos="0 0 0.5"/></body>
          </worldbody><equality>EQUALITY</equality></mujoco>
        """
            .replace("EQUALITY", equality);
    RobotImport robot = RobotImport.of("r.xml", text.getBytes(StandardCharsets.UTF_8));
    double[] y = new double[robot.model().mechanism().stateCount()];
    robot.model().mechanism().initialState(y);
    assertThat(y[0]).isEqualTo(start);
  }

  /**
   * A ball that closes a loop in the file, and is of the tree here: the rod that it holds is turned
   * by a right angle, and the loop is closed at the start all the same.
   */
  @Test
  void ballThatClosesALoopHasItsTurn() throws MechmlException {
    String inertial =
        "<inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>";
    String text =
        """
        <sdf version="1.9"><model name="r">
          <link name="base"/>
          <link name="crank"><pose>1 0 0 0 0 0</pose>INERTIAL</link>
          <link name="rod"><pose>0 0 0 0 0 1.5707963267948966</pose>INERTIAL</link>
          <joint name="fixed" type="fixed"><parent>world</parent><child>base</child></joint>
          <joint name="turn" type="revolute"><parent>base</parent><child>crank</child>
            <axis><xyz>0 0 1</xyz></axis></joint>
          <joint name="ball" type="ball"><parent>rod</parent><child>base</child></joint>
          <joint name="pin" type="revolute"><parent>crank</parent><child>rod</child>
            <pose relative_to="crank">0 0 0 0 0 0</pose><axis><xyz>0 0 1</xyz></axis></joint>
        </model></sdf>
        """
            .replace("INERTIAL", inertial);
    Mechanism mechanism =
        RobotImport.of("r.sdf", text.getBytes(StandardCharsets.UTF_8)).model().mechanism();
    assertThat(mechanism.joints()).extracting(Joint::name).contains("ball");
    double[] y = new double[mechanism.stateCount()];
    mechanism.initialState(y);
    int at = 0;
    while (!mechanism.joints().get(at).name().equals("ball")) {
      at++;
    }
    double root = Math.sqrt(0.5);
    assertThat(y[mechanism.positionOffset(at)]).isCloseTo(root, within(1e-15));
    assertThat(Math.abs(y[mechanism.positionOffset(at) + 3])).isCloseTo(root, within(1e-15));
  }

  /** As the acrobot of Drake, which is welded to a world that its file does not have. */
  @Test
  void urdfMayHangInAWorldThatItDoesNotName() throws MechmlException {
    String text =
        """
        <robot name="r"><joint name="weld" type="fixed"><parent link="world"/><child link="base"/>
          </joint>
          <link name="base"><inertial><mass value="1"/>
            <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
          <link name="arm"><inertial><mass value="1"/>
            <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
          <joint name="j" type="continuous"><parent link="base"/><child link="arm"/></joint></robot>
        """;
    RobotImport robot = RobotImport.of("r.urdf", text.getBytes(StandardCharsets.UTF_8));
    assertThat(robot.model().mechanism().velocityCount()).isEqualTo(1);
    assertThat(robot.losses()).isEmpty();
  }

  @Test
  void urdfOfOneLinkMovesFreely() throws MechmlException {
    RobotImport ball =
        read(
            "<robot name='r'><link name='ball'><inertial><mass value='2'/><inertia ixx='1' iyy='1'"
                + " izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link></robot>");
    assertThat(ball.model().mechanism().velocityCount()).isEqualTo(6);
    assertThat(codes(ball.notes())).containsExactly("M-097");
  }

  // Stops.

  /**
   * A finger of grams: its stops hold its inertia, so that their time is that of the parameter and
   * not the one of an arm.
   */
  @ParameterizedTest
  @ValueSource(doubles = {1e-9, 1e-3, 1, 1e6})
  void stopsAreAsStiffAsTheInertiaTheyHoldAsksFor(double mass) throws MechmlException {
    String text =
        mechml(
            read(
                ("<robot name='r'><link name='p'/><link name='a'><inertial><origin xyz='1 0 0'/>"
                        + "<mass value='%s'/><inertia ixx='0' iyy='0' izz='0' ixy='0' ixz='0'"
                        + " iyz='0'/></inertial></link><joint name='j' type='revolute'><parent"
                        + " link='p'/><child link='a'/><axis xyz='0 1 0'/><limit lower='0'"
                        + " upper='1.5'/></joint></robot>")
                    .formatted(mass)));
    MechmlModel model = MechmlReader.read("m", text.getBytes(StandardCharsets.UTF_8));
    // Beyond the stop by d the stop pushes back with m d/(5 ms)².
    double[] inside = accelerations(model, 1.5, 0);
    double[] beyond = accelerations(model, 1.51, 0);
    assertThat(beyond[0] - inside[0]).isCloseTo(-0.01 / 2.5e-5, within(4.0));
  }

  // Names.

  @Test
  void madeNameDoesNotMeetOneOfTheFile() throws MechmlException {
    RobotImport robot =
        read(
            "<mujoco><worldbody><body><joint axis='0 1 0'/><geom size='0.1' pos='0.3 0 0'/></body>"
                + "<body name='body1'><joint axis='0 1 0'/><geom size='0.1' pos='0.3 0 0'/></body>"
                + "</worldbody></mujoco>");
    assertThat(robot.model().mechanism().bodies()).extracting(Body::name).doesNotHaveDuplicates();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<worldbody><body><joint class='nope'/></body></worldbody> | M-014",
        "<worldbody><body childclass='nope'/></worldbody> | M-014",
        "<worldbody/><equality><joint joint1='a' joint2='b'/></equality> | M-014",
        "<worldbody/><equality><connect body1='a' anchor='0 0 0'/></equality> | M-014",
        "<worldbody><body><geom type='mesh' mesh='m'/></body></worldbody> | M-014",
        "<worldbody><body><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/><inertial pos='0 0 0'"
            + " mass='1' diaginertia='1 1 1'/></body></worldbody> | M-084",
        "<compiler eulerseq='xyy2'/><worldbody/> | M-084",
      })
  void nameThatDoesNotExistAndSecondThingIsRefused(String inside, String code) {
    assertThatThrownBy(() -> read("<mujoco>" + inside + "</mujoco>")).hasMessageContaining(code);
  }

  @Test
  void secondOfAPartThatUrdfHasOnceIsRefused() {
    assertThatThrownBy(
            () ->
                read(
                    "<robot name='r'><link name='a'><inertial><mass value='1'/><mass value='2'/>"
                        + "<inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial>"
                        + "</link></robot>"))
        .hasMessageContaining("M-010");
  }

  @Test
  void jointThatFollowsAFixedOneIsToldWhy() {
    assertThatThrownBy(
            () ->
                read(
                    "<robot name='r'><link name='a'/><link name='b'/><link name='c'/><joint name='j'"
                        + " type='continuous'><parent link='a'/><child link='b'/><mimic joint='k'/>"
                        + "</joint><joint name='k' type='fixed'><parent link='b'/><child link='c'/>"
                        + "</joint></robot>"))
        .hasMessageContaining("joint \"k\" is fixed or has several coordinates")
        .hasMessageNotContaining("did you mean");
  }

  // Loops and starts.

  @Test
  void connectClosesALoopAndWeldFixesABody() throws MechmlException {
    String fourBar =
        "<mujoco><compiler angle='radian'/><worldbody><body name='crank'><joint name='a' axis='0 1 0'/>"
            + "<inertial pos='0 0 0.5' mass='1' diaginertia='0.08 0.08 0.001'/><body name='coupler'"
            + " pos='0 0 1'><joint name='b' axis='0 1 0'/><inertial pos='0.5 0 0' mass='1'"
            + " diaginertia='0.001 0.08 0.08'/></body></body><body name='rocker' pos='1 0 0'><joint"
            + " name='c' axis='0 1 0'/><inertial pos='0 0 0.5' mass='1' diaginertia='0.08 0.08 0.001'/>"
            + "</body></worldbody><equality>%s</equality></mujoco>";
    RobotImport connected =
        read(fourBar.formatted("<connect body1='coupler' body2='rocker' anchor='1 0 0'/>"));
    assertThat(connected.losses()).isEmpty();
    assertThat(mechml(connected))
        .contains("<JointConstraint name=\"connect1\" type=\"S\">", "z=\"1\"");
    assertThat(mechml(read(fourBar.formatted("<weld body1='rocker'/>"))))
        .contains("<JointConstraint name=\"weld1\" type=\"W\">");
    assertThat(mechml(read(fourBar.formatted("<joint joint1='c' joint2='a' polycoef='0 1 0.5'/>"))))
        .contains("expression=\"c.q - (0) - (1)*(a.q) - (0.5)*(a.q)^2\"");
    // Two equations of one joint are two.
    assertThat(
            read(fourBar.formatted(
                    "<joint joint1='c' joint2='a'/><joint joint1='c' polycoef='0.5 0 0 0 0'/>"))
                .model()
                .mechanism()
                .closures())
        .hasSize(2);
  }

  @Test
  void keyframeIsTheStartThatIsAskedFor() throws MechmlException {
    String text =
        "<mujoco><worldbody><body name='f' pos='0 0 1'><freejoint name='f'/><geom size='0.1'/><body>"
            + "<joint name='h' axis='0 1 0' ref='30'/><geom size='0.1' pos='0.3 0 0'/></body></body>"
            + "</worldbody><keyframe><key qpos='0 0 1 1 0 0 0 0'/><key name='home'"
            + " qpos='1 2 3 0.5 0.5 0.5 0.5 0.9' qvel='1 2 3 0.1 0.2 0.3 -2'/></keyframe></mujoco>";
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    RobotImport home =
        RobotImport.read(
            "r",
            bytes,
            folder,
            new ImportOptions(
                Optional.empty(), Optional.of("home"), false, List.of(), Optional.empty()));
    // The angular velocity is in body axes there, in world axes here: x to y to z to x.
    assertThat(mechml(home))
        .contains(
            "<jointVal name=\"f\" posVals=\"0.5;0.5;0.5;0.5;1;2;2\"",
            "velVals=\"0.30000000000000004;0.1;0.2;1;2;3\"".replace("0.30000000000000004", "0.3"),
            "<jointVal name=\"h\" posVals=\"" + (0.9 - Math.toRadians(30)) + "\" velVals=\"-2\"");
    assertThatThrownBy(
            () ->
                RobotImport.read(
                    "r",
                    bytes,
                    folder,
                    new ImportOptions(
                        Optional.empty(), Optional.of("hom"), false, List.of(), Optional.empty())))
        .hasMessageContaining("did you mean \"home\"");
  }

  @Test
  void nestingHasNoSmallLimit() throws MechmlException {
    int depth = 200;
    String text =
        "<mujoco><worldbody>"
            + "<body><joint axis='0 1 0'/><geom size='0.1' pos='0.1 0 0'/>".repeat(depth)
            + "</body>".repeat(depth)
            + "</worldbody></mujoco>";
    assertThat(read(text).model().mechanism().bodies()).hasSize(depth);
  }
}
