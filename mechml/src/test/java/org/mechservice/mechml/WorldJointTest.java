package org.mechservice.mechml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.closure.assembly.ClosedStart;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/** Joints that are given by a point and an axis in the world at assembly. */
class WorldJointTest {
  /** A few dozen operations on numbers near 1. */
  private static final double ROUNDING = 1e-14;

  private static final String FRAME =
      "<point name='p' x='0.1' y='0.2' z='0.3'/><vector name='x' vx='1' vy='0' vz='0'/>"
          + "<vector name='y' vx='0' vy='1' vz='0'/><mass value='1'/>"
          + "<inertiaTensor Ixx='1' Iyy='1' Izz='1'/>";

  private static Mechanism mechanism(String bodies, String joints, String topology)
      throws Exception {
    String text =
        """
        <MechML>
          <MBSsimulation><dynamic><timeSet tini='0' tend='1' tstep='0.1'/></dynamic></MBSsimulation>
          <MBSmodel name='World' massUnits='kg' lengthUnits='m'>
            <Bodies><body name='ground'>%s</body>%s</Bodies>
            <Joints>%s</Joints>
            <topology>%s</topology>
          </MBSmodel>
        </MechML>
        """
            .formatted(
                "<point name='p' x='0' y='0' z='0'/><vector name='x' vx='1' vy='0' vz='0'/>"
                    + "<vector name='y' vx='0' vy='1' vz='0'/>",
                bodies,
                joints,
                topology);
    return MechmlReader.read("world.xml", text.getBytes(StandardCharsets.UTF_8)).mechanism();
  }

  private static String body(String name) {
    return "<body name='" + name + "'>" + FRAME + "</body>";
  }

  /** Bodies whose way to the root begins in the world have their frames in the world's. */
  @ParameterizedTest
  @EnumSource(JointType.class)
  void framesCoincideWithTheWorldsAtAssembly(JointType type) throws Exception {
    String axes =
        switch (type) {
          case R, P, C -> "axis='0.3;-2;1'";
          case H -> "axis='0.3;-2;1' pitch='0.1'";
          case U -> "axis='1;-2;1' axis2='1;1;1'";
          case PL -> "axis='1;-2;1' axis2='3;1;1'";
          case S, F, W -> "";
        };
    String[] pair = {"ground", "first", "second"};
    StringBuilder joints = new StringBuilder();
    for (int i = 1; i < pair.length; i++) {
      // The second joint is turned about: its body1 is the outer one.
      joints.append(
          String.format(
              "<joint name='j%d' type='%s' body1='%s' body2='%s' at='%d;0.5;-1' %s/>",
              i, type, pair[i == 1 ? 0 : 2], pair[1], i, axes));
    }
    Mechanism mechanism =
        mechanism(
            body("first") + body("second"),
            joints.toString(),
            "<root name='ground'><inipos><point name='p' x='1' y='2' z='3'/>"
                + "<vector name='x' vx='0' vy='0' vz='1'/><vector name='y' vx='1' vy='0' vz='0'/>"
                + "</inipos></root>");
    TreeMotion motion = atStart(mechanism);
    for (int body = 0; body < 2; body++) {
      for (double[] point : new double[][] {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, -2, 5}}) {
        assertThat(world(motion, body, new Vector3(point[0], point[1], point[2])))
            .containsExactly(point, within(8 * ROUNDING));
      }
    }
    for (Joint joint : mechanism.joints()) {
      assertThat(world(motion, joint.attachment().child(), joint.attachment().childPoint()))
          .containsExactly(
              new double[] {joint.name().equals("j1") ? 1 : 2, 0.5, -1}, within(8 * ROUNDING));
    }
  }

  /** Behind a joint in the bodies, the point and the axis are where the start puts that body. */
  @ParameterizedTest
  @CsvSource({
    "C,'0.4; 0.7'",
    "U,'0.4; 0.7'",
    "PL,'0.2; 0.1; 0.7'",
    "H,0.7",
    "F,'1;0.5;0.2;0.3;1;2;3'"
  })
  void pointLiesWhereTheFileSaysBehindAJointInTheBodies(String type, String start)
      throws Exception {
    double norm = Math.sqrt(1 + 0.25 + 0.04 + 0.09);
    String posVals =
        type.equals("F")
            ? String.format(
                Locale.ROOT,
                "%.17g;%.17g;%.17g;%.17g;1;2;3",
                1 / norm,
                0.5 / norm,
                0.2 / norm,
                0.3 / norm)
            : start;
    String axes =
        switch (type) {
          case "F" -> "point='p'";
          case "PL" -> "point='p' vector='y' vector2='x'";
          default -> "point='p' vector='y'";
        };
    String other =
        switch (type) {
          case "F" -> "point='p'";
          case "U" -> "point='p' vector='x'";
          default -> "point='p' vector='y'";
        };
    String pitch = type.equals("H") ? "pitch='0.3'" : "";
    Mechanism mechanism =
        mechanism(
            body("first") + body("second"),
            "<joint name='a' type='"
                + type
                + "' "
                + pitch
                + "><body1 name='ground' "
                + axes
                + "/><body2 name='first' "
                + other
                + "/></joint>"
                + "<joint name='b' type='R' body1='first' body2='second' at='1;2;3'"
                + " axis='0;0.6;0.8'/>",
            "<root name='ground'/><relCoorVals><jointVal name='a' posVals='"
                + posVals
                + "'/></relCoorVals>");
    TreeMotion motion = atStart(mechanism);
    Joint joint = mechanism.joints().get(1);
    assertThat(world(motion, 0, joint.attachment().parentPoint()))
        .containsExactly(new double[] {1, 2, 3}, within(20 * ROUNDING));
    assertThat(world(motion, 1, new Vector3(0.3, -2, 5)))
        .containsExactly(new double[] {0.3, -2, 5}, within(40 * ROUNDING));
    double[] tip = world(motion, 0, joint.attachment().parentPoint().plus(joint.axes().get(0)));
    assertThat(tip).containsExactly(new double[] {1, 2.6, 3.8}, within(20 * ROUNDING));
  }

  /** Cut joints close where the tree puts their bodies, so that a loop is closed at the start. */
  @Test
  void loopOfWorldJointsIsClosedAtTheStart() throws Exception {
    Random random = new Random(5);
    StringBuilder joints = new StringBuilder();
    String[] ring = {"ground", "first", "second", "third", "ground"};
    for (int i = 0; i < 4; i++) {
      joints.append(
          String.format(
              Locale.ROOT,
              "<joint name='j%d' type='R' body1='%s' body2='%s' at='%.3f;%.3f;%.3f' axis='0;1;0'/>",
              i,
              ring[i],
              ring[i + 1],
              random.nextDouble(),
              0.5,
              random.nextDouble()));
    }
    Mechanism mechanism =
        mechanism(
            body("first") + body("second") + body("third"),
            joints.toString(),
            "<root name='ground'/>");
    ClosedStart start = new ClosedStart(mechanism, 0);
    assertThat(start.isAssembled()).isTrue();
    assertThat(IntStream.range(0, 3).mapToDouble(i -> start.state()[i]).toArray())
        .containsExactly(0, 0, 0);
  }

  /** The short form is the long form with the same numbers in both bodies, to the bit. */
  @Test
  void jointInTheWorldIsTheJointOfEqualPointsInBothBodies() throws Exception {
    List<Joint> brief =
        mechanism(
                body("first"),
                "<joint name='j' type='R' body1='ground' body2='first' at='0.1;0.2;0.3'"
                    + " axis='0;1;0'/>",
                "<root name='ground'/>")
            .joints();
    List<Joint> paired =
        mechanism(
                body("first"),
                "<joint name='j' type='R'><body1 name='ground' point='p' vector='y'/>"
                    + "<body2 name='first' point='p' vector='y'/></joint>",
                "<root name='ground'><inipos><point name='p' x='0.1' y='0.2' z='0.3'/></inipos>"
                    + "</root>")
            .joints();
    assertThat(brief.get(0).attachment().childPoint())
        .isEqualTo(paired.get(0).attachment().childPoint());
    assertThat(brief.get(0).axes()).isEqualTo(paired.get(0).axes());
    assertThat(brief.get(0).attachment().zeroRotation()).isEqualTo(Rotation.IDENTITY);
  }

  private static double[] world(TreeMotion motion, int body, Vector3 point) {
    double[] r = new double[3];
    motion.tree().fromReference(new BodyPoint(body, point), r, 0);
    double[] at = new double[3];
    motion.points.position(motion.tree().linkOf(body), r, 0, at, 0);
    return at;
  }

  private static TreeMotion atStart(Mechanism mechanism) {
    ClosedStart start = new ClosedStart(mechanism, 0);
    TreeMotion motion = new TreeMotion(start.tree());
    motion.sweep(0, start.state());
    return motion;
  }
}
