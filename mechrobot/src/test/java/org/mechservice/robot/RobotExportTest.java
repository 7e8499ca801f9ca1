package org.mechservice.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.DocumentWriter;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Free;
import org.mechservice.solver.mechanism.joint.Joint;

/** An exported mechanism is the mechanism when it is imported again. */
class RobotExportTest {
  private static final Path EXAMPLES = Path.of("../examples");

  /** Rounding of some ten joints, relative to the largest acceleration, with ample room. */
  private static final double ROUNDING = 1e-10;

  private static MechmlModel read(String mechml) throws MechmlException {
    return MechmlReader.read("model.xml", mechml.getBytes(StandardCharsets.UTF_8));
  }

  private static RobotExport exported(String mechml) throws MechmlException {
    byte[] content = mechml.getBytes(StandardCharsets.UTF_8);
    return RobotExport.of("model.xml", read(mechml), MechmlReader.whole("model.xml", content));
  }

  private static MechmlModel imported(String urdf) throws MechmlException {
    RobotImport robot = RobotImport.of("model.urdf", urdf.getBytes(StandardCharsets.UTF_8));
    return read(DocumentWriter.write(robot.document()));
  }

  /** A tree of joints whose frames, inertias and directions are random. */
  private static String randomTree(long seed, List<String> types) {
    Random random = new Random(seed);
    StringBuilder bodies = new StringBuilder();
    StringBuilder joints = new StringBuilder();
    StringBuilder start = new StringBuilder();
    StringBuilder[] frames = new StringBuilder[9];
    frames[0] = new StringBuilder();
    for (int i = 1; i < frames.length; i++) {
      int parent = random.nextInt(i);
      String type = types.get(i % types.size());
      frames[i] = new StringBuilder();
      boolean oriented = !type.equals("F");
      frame(frames[parent], "j" + i, oriented, random);
      frame(frames[i], "j" + i, oriented, random);
      boolean outward = type.equals("F") || random.nextBoolean();
      joints
          .append("<joint name='j%d' type='%s'>".formatted(i, type))
          .append(end("body1", outward ? parent : i, i, oriented))
          .append(
              end("body2", outward ? i : parent, i, oriented)
                  .replaceFirst(type.equals("U") ? " vector2='.*?'" : "^", ""))
          .append("</joint>\n");
      if (type.equals("F")) {
        start.append("<jointVal name='j%d' posVals='0.6;0;0.8;0;0.3;-0.2;0.1'/>".formatted(i));
      }
    }
    for (int i = 0; i < frames.length; i++) {
      bodies.append("<body name='b%d'>".formatted(i)).append(frames[i]);
      if (i > 0) {
        double a = 0.1 + random.nextDouble();
        bodies.append(
            String.format(
                Locale.ROOT,
                "<cog x='%s' y='%s' z='%s'/><mass value='%s'/><inertiaTensor Ixx='%s' Iyy='%s'"
                    + " Izz='%s' Ixy='%s' Ixz='%s' Iyz='%s'/>",
                random.nextGaussian(),
                random.nextGaussian(),
                random.nextGaussian(),
                0.5 + random.nextDouble(),
                a,
                1.1 * a,
                1.2 * a,
                0.1 * a,
                -0.05 * a,
                0.08 * a));
      }
      bodies.append("</body>\n");
    }
    double up = random.nextDouble();
    return model(
        bodies.toString(),
        joints.toString(),
        "<gravity gx='%s' gy='0' gz='%s'/>".formatted(9.81 * Math.sin(up), -9.81 * Math.cos(up)),
        "<root name='b0'/><relCoorVals>" + start + "</relCoorVals>");
  }

  private static String model(String bodies, String joints, String forces, String topology) {
    return """
    <!DOCTYPE MechML SYSTEM "MechML.dtd">
    <MechML><MBSsimulation><dynamic>
      <timeSet tini="0" tend="1" tstep="0.1"/>
      <integrator name="ode113" relTol="1e-9" absTol="1e-9"/>
    </dynamic></MBSsimulation>
    <MBSmodel name="tree" massUnits="kg" lengthUnits="m">
    <Bodies>%s</Bodies><Joints>%s</Joints><Forces>%s</Forces><topology>%s</topology>
    </MBSmodel></MechML>
    """
        .formatted(bodies, joints, forces, topology);
  }

  private static String end(String tag, int body, int joint, boolean oriented) {
    return "<%s name='b%d' point='j%d'%s/>"
        .formatted(
            tag,
            body,
            joint,
            oriented ? " vector='j%d' vector2='j%ds'".formatted(joint, joint) : "");
  }

  private static void frame(StringBuilder body, String name, boolean oriented, Random random) {
    body.append(
        String.format(
            Locale.ROOT,
            "<point name='%s' x='%s' y='%s' z='%s'/>",
            name,
            random.nextGaussian(),
            random.nextGaussian(),
            random.nextGaussian()));
    if (oriented) {
      double a = 6 * random.nextDouble();
      double b = 3 * random.nextDouble();
      body.append(vector(name, Math.cos(a) * Math.sin(b), Math.sin(a) * Math.sin(b), Math.cos(b)))
          .append(
              vector(
                  name + "s", Math.cos(a) * Math.cos(b), Math.sin(a) * Math.cos(b), -Math.sin(b)));
    }
  }

  private static String vector(String name, double x, double y, double z) {
    return String.format(Locale.ROOT, "<vector name='%s' vx='%s' vy='%s' vz='%s'/>", name, x, y, z);
  }

  private static double[] accelerations(MechmlModel model, double[] y) {
    DataDrivenModel equations = new DataDrivenModel(model.mechanism(), model.settings().run());
    double[] rate = new double[y.length];
    equations.derivative(0, y, rate);
    return rate;
  }

  /** Returns the state in the coordinates of the exported tree: free bodies from their start. */
  private static double[] shifted(Mechanism mechanism, double[] y) {
    double[] other = y.clone();
    for (int j = 0; j < mechanism.joints().size(); j++) {
      Joint joint = mechanism.joints().get(j);
      if (joint instanceof Free free) {
        for (int k = 4; k < 7; k++) {
          other[mechanism.positionOffset(j) + k] -= free.start().positions().get(k);
        }
      }
    }
    return other;
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
  void randomTreesMoveTheSame(long seed) throws MechmlException {
    String mechml = randomTree(seed, List.of("R", "P", "F", "W"));
    RobotExport robot = exported(mechml);
    assertThat(robot.losses()).isEmpty();
    assertSameMotion(read(mechml), imported(robot.text()), new Random(seed));
  }

  /** Joints C and U are two joints each, whose coordinates have the names of the one. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
  void jointsOfTwoCoordinatesMoveAsTheirChains(long seed) throws MechmlException {
    String mechml = randomTree(seed, List.of("U", "C", "R"));
    RobotExport robot = exported(mechml);
    assertThat(robot.losses()).isEmpty();
    MechmlModel model = read(mechml);
    MechmlModel chains = imported(robot.text());
    Mechanism one = model.mechanism();
    Mechanism other = chains.mechanism();
    assertThat(other.stateCount()).isEqualTo(one.stateCount());
    List<String> names = other.joints().stream().map(Joint::name).toList();
    Random random = new Random(seed);
    for (int i = 0; i < 10; i++) {
      double[] y = new double[one.stateCount()];
      double[] same = new double[y.length];
      int[] place = new int[y.length];
      for (int j = 0; j < one.joints().size(); j++) {
        int count = one.joints().get(j).type().velocityCount();
        for (int k = 0; k < count; k++) {
          String name = one.joints().get(j).name();
          int there = names.indexOf(count == 1 ? name : name + "_" + (k + 1));
          place[one.positionOffset(j) + k] = other.positionOffset(there);
          place[one.positionCount() + one.velocityOffset(j) + k] =
              other.positionCount() + other.velocityOffset(there);
        }
      }
      for (int k = 0; k < y.length; k++) {
        y[k] = random.nextGaussian();
        same[place[k]] = y[k];
      }
      double[] here = accelerations(model, y);
      double[] there = accelerations(chains, same);
      double largest = Math.max(1, Arrays.stream(here).map(Math::abs).max().orElseThrow());
      for (int k = 0; k < y.length; k++) {
        assertThat(there[place[k]] - here[k]).isBetween(-ROUNDING * largest, ROUNDING * largest);
      }
    }
  }

  /** The dampers of a joint C are each at the joint of its coordinate. */
  @Test
  void forcesOfTwoCoordinatesAreKept() throws Exception {
    RobotExport robot = exported(Files.readString(EXAMPLES.resolve("elements/joint-C.xml")));
    assertThat(robot.losses()).hasSize(2);
    assertThat(robot.losses().get(1).toString()).contains("start values of joint \"bead\"");
    assertThat(robot.text().replaceAll("\\s+", " "))
        .contains(
            "<joint name=\"bead_1\" type=\"prismatic\">",
            "<dynamics damping=\"1\"/>",
            "<joint name=\"bead_2\" type=\"continuous\">");
  }

  private static void assertSameMotion(MechmlModel model, MechmlModel again, Random random) {
    Mechanism mechanism = model.mechanism();
    assertThat(again.mechanism().joints().stream().map(Joint::name))
        .containsSubsequence(mechanism.joints().stream().map(Joint::name).toList());
    for (int i = 0; i < 10; i++) {
      double[] y = new double[mechanism.stateCount()];
      mechanism.initialState(y);
      for (int j = 0; j < mechanism.joints().size(); j++) {
        int free = mechanism.joints().get(j) instanceof Free ? 4 : 0;
        for (int k = free; k < mechanism.joints().get(j).type().positionCount(); k++) {
          y[mechanism.positionOffset(j) + k] += random.nextGaussian();
        }
      }
      for (int k = mechanism.positionCount(); k < y.length; k++) {
        y[k] = random.nextGaussian();
      }
      double[] here = accelerations(model, y);
      double[] there = accelerations(again, shifted(mechanism, y));
      double largest = 1;
      for (double a : here) {
        largest = Math.max(largest, Math.abs(a));
      }
      for (int k = 0; k < here.length; k++) {
        assertThat(there[k] - here[k]).isBetween(-ROUNDING * largest, ROUNDING * largest);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"pendulum/pendulum.xml", "elements/joint-W.xml"})
  void examplesMoveTheSame(String example) throws Exception {
    String mechml = Files.readString(EXAMPLES.resolve(example));
    RobotExport robot = exported(mechml);
    List<Diagnostic> ofMotion =
        robot.losses().stream().filter(l -> !l.toString().contains("start values")).toList();
    assertThat(ofMotion).isEmpty();
    assertSameMotion(read(mechml), imported(robot.text()), new Random(1));
  }

  /** The export gives back what was imported, with limits, damping, friction and mimics. */
  @Test
  void robotGoesAndComes() throws MechmlException {
    String urdf =
        """
        <robot name="arm">
          <link name="base"/>
          <link name="upper"><inertial><mass value="2"/>
            <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
            <visual><geometry><mesh filename="upper.stl"/></geometry></visual></link>
          <link name="lower"><inertial><origin xyz="0 0 -1"/><mass value="1"/>
            <inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0.5" izz="1"/></inertial></link>
          <joint name="a" type="revolute"><origin xyz="0 0 1" rpy="0.5 0 0"/><parent link="base"/>
            <child link="upper"/><axis xyz="0 1 0"/><limit lower="-1" upper="2" effort="1"
            velocity="1"/><dynamics damping="0.5" friction="0.25"/></joint>
          <joint name="b" type="continuous"><parent link="upper"/><child link="lower"/>
            <axis xyz="1 0 0"/><mimic joint="a" multiplier="-2" offset="0.125"/></joint>
        </robot>
        """;
    RobotImport robot = RobotImport.of("arm.urdf", urdf.getBytes(StandardCharsets.UTF_8));
    RobotExport back = exported(DocumentWriter.write(robot.document()));
    assertThat(back.losses()).isEmpty();
    assertThat(back.text())
        .contains(
            "<mesh filename=\"upper.stl\"/>",
            "<origin xyz=\"0 0 1\" rpy=\"0.5 0 0\"/>",
            "<limit lower=\"-1\" upper=\"2\"",
            "<dynamics damping=\"0.5\" friction=\"0.25\"/>",
            "<mimic joint=\"a\" multiplier=\"-2\" offset=\"0.125\"/>");
    RobotImport again = RobotImport.of("arm.urdf", back.text().getBytes(StandardCharsets.UTF_8));
    assertThat(again.model().mechanism().forces()).hasSize(4);
    assertThat(again.model().mechanism().closures()).hasSize(1);
  }

  /** A free body starts where its coordinates put it, from whichever side they count. */
  @Test
  void freeBodyStartsWhereItWas() throws MechmlException {
    String mechml =
        model(
            "<body name='ground'><point name='o' x='0' y='0' z='0'/></body><body name='bar'>"
                + "<point name='o' x='0' y='0' z='0'/><mass value='1'/>"
                + "<inertiaTensor Ixx='1' Iyy='1' Izz='1'/></body>",
            "<joint name='f' type='F'><body1 name='bar' point='o'/>"
                + "<body2 name='ground' point='o'/></joint>",
            "<gravity gx='0' gy='0' gz='-9.81'/>",
            "<root name='ground'/><relCoorVals><jointVal name='f'"
                + " posVals='0.7071067811865476;0;0;0.7071067811865476;1;2;3'/></relCoorVals>");
    // A quarter about z takes the ground's axes to the bar's; so the bar is turned back by it, and
    // lies at -(2, -1, 3).
    assertThat(exported(mechml).text()).contains("<origin xyz=\"-2");
    double[] origin =
        Arrays.stream(
                exported(mechml)
                    .text()
                    .replaceAll("(?s).*<origin xyz=\"([^\"]*)\" rpy=\"([^\"]*)\".*", "$1 $2")
                    .split(" ", -1))
            .mapToDouble(Double::parseDouble)
            .toArray();
    double[] expected = {-2, 1, -3, 0, 0, -Math.PI / 2};
    for (int i = 0; i < expected.length; i++) {
      assertThat(origin[i] - expected[i]).isBetween(-1e-15, 1e-15);
    }
  }

  @Test
  void whatMakesAnotherMechanismIsRefusedByName() throws Exception {
    MechmlException loop =
        catchThrowableOfType(
            MechmlException.class,
            () -> exported(Files.readString(EXAMPLES.resolve("four-bar/four-bar.xml"))));
    assertThat(loop.diagnostics()).hasSize(1);
    assertThat(loop.diagnostics().get(0).code()).isEqualTo(MessageCode.URDF_CANNOT);
    MechmlException joint =
        catchThrowableOfType(
            MechmlException.class,
            () -> exported(Files.readString(EXAMPLES.resolve("elements/joint-S.xml"))));
    assertThat(joint).hasMessageContaining("is of type S");
  }

  @Test
  void sizesAreShownWhateverTheyAreWrittenAs() throws MechmlException {
    String mechml =
        model(
            "<body name='g'><point name='o' x='0' y='0' z='0'/><vector name='z' vx='0' vy='0'"
                + " vz='1'/></body><body name='b'><point name='o' x='0' y='0' z='0'/><vector"
                + " name='z' vx='0' vy='0' vz='1'/><point name='e' x='0' y='0' z='-2*1'/><cylinder"
                + " radius='0.2/2' from='0;0;0' to='e' mass='1'/></body>",
            "<joint name='j' type='R'><body1 name='g' point='o' vector='z'/>"
                + "<body2 name='b' point='o' vector='z'/></joint>",
            "<gravity gx='0' gy='0' gz='-9.81'/>",
            "<root name='g'/>");
    RobotExport robot = exported(mechml);
    assertThat(robot.text()).contains("<cylinder radius=\"0.1\" length=\"2\"/>");
    assertThat(robot.losses()).isEmpty();
  }

  @Test
  void shapesAreShown() throws MechmlException {
    String mechml =
        model(
            "<body name='g'><point name='o' x='0' y='0' z='0'/><vector name='z' vx='0' vy='0'"
                + " vz='1'/></body><body name='b'><point name='o' x='0' y='0' z='0'/><vector"
                + " name='z' vx='0' vy='0' vz='1'/><point name='e' x='0' y='0' z='-2'/><cylinder"
                + " radius='0.1' from='0;0;0' to='e' mass='1'/><box x='1' y='2' z='3' point='e'"
                + " mass='1'/><sphere radius='0.5' mass='1'/><cone radius='0.1' from='0;0;0' to='e'"
                + " mass='1'/></body>",
            "<joint name='j' type='R'><body1 name='g' point='o' vector='z'/>"
                + "<body2 name='b' point='o' vector='z'/></joint>",
            "<gravity gx='0' gy='0' gz='-9.81'/>",
            "<root name='g'/>");
    RobotExport robot = exported(mechml);
    assertThat(robot.text())
        .contains(
            "<cylinder radius=\"0.1\" length=\"2\"/>",
            "<box size=\"1 2 3\"/>",
            "<origin xyz=\"0 0 -2\"/>",
            "<sphere radius=\"0.5\"/>");
    assertThat(robot.losses()).hasSize(1);
    assertThat(robot.losses().get(0).toString())
        .startsWith("model.xml:")
        .contains("cone of body \"b\"");
  }
}
