package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.program.Trajectory;

/** Free bodies that come to rest on what is below them. */
class ContactEquilibriumTest {
  private static final double G = 9.81;
  private static final double K = 1e4;
  private static final String LEVEL = "1;0;0;0;0;0;";

  private static String body(String name, double mass, double offset) {
    return String.format(
        Locale.ROOT,
        "<body name='%s'><point name='o' x='0' y='0' z='0'/><vector name='z' vx='0' vy='0'"
            + " vz='1'/><cog x='%s' y='0' z='0'/><mass value='%s'/><inertiaTensor Ixx='0.1'"
            + " Iyy='0.1' Izz='0.1' Ixy='0' Ixz='0' Iyz='0'/></body>",
        name,
        offset,
        mass);
  }

  private static String free(String name) {
    return "<joint name='f"
        + name
        + "' type='F'><body1 name='G' point='o'/><body2 name='"
        + name
        + "' point='o'/></joint>";
  }

  private static String start(String name, String place) {
    return "<jointVal name='f" + name + "' posVals='" + place + "'/>";
  }

  private static MechModel model(String bodies, String joints, String forces, String starts)
      throws Exception {
    return MechModel.of(
        "rest.xml",
        "<MechML><MBSsimulation><static/></MBSsimulation><MBSmodel name='rest' massUnits='kg'"
            + " lengthUnits='m'><Bodies><body name='G'><point name='o' x='0' y='0' z='0'/>"
            + "<vector name='z' vx='0' vy='0' vz='1'/><vector name='y' vx='0' vy='1' vz='0'/>"
            + "<vector name='s' vx='0.17364817766693033' vy='0' vz='0.984807753012208'/></body>"
            + bodies
            + "</Bodies><Joints>"
            + joints
            + "</Joints><Forces><gravity gx='0' gy='0' gz='-9.81'/>"
            + forces
            + "</Forces><topology><root name='G'/><relCoorVals>"
            + starts
            + "</relCoorVals></topology></MBSmodel></MechML>");
  }

  private static String crateOn(String normal, String friction) {
    return "<boxContact name='floor' box='0.4;0.4;0.4' stiffness='1e4' "
        + friction
        + "><body1 name='G' point='o' vector='"
        + normal
        + "'/><body2 name='a' point='o'/></boxContact>";
  }

  private static String onFloor(String ball) {
    return "<contact name='on"
        + ball
        + "' radius='0.1' stiffness='1e4'><body1 name='G' point='o' vector='z'/><body2 name='"
        + ball
        + "' point='o'/></contact>";
  }

  private static String between(String first, String second) {
    return "<sphereContact name='"
        + first
        + second
        + "' radius1='0.1' radius2='0.1' stiffness='1e4'><body1 name='"
        + first
        + "' point='o'/><body2 name='"
        + second
        + "' point='o'/></sphereContact>";
  }

  /**
   * The mean depth of four corners carries the weight; the offset of its centre of mass tilts the
   * crate by m g d / (4 k h²), h half its edge.
   */
  @ParameterizedTest
  @ValueSource(doubles = {0.1, 0.21, 0.5, 2, 5})
  void crateAboveAFloorComesToRestFlat(double height) throws Exception {
    Trajectory rest =
        model(body("a", 2, 0.05), free("a"), crateOn("z", ""), start("a", LEVEL + height))
            .equilibrium();
    // lengths change by the square of the tilt, 4e-7
    assertThat(rest.column("fa.q[6]")[0]).isCloseTo(0.2 - 2 * G / (4 * K), within(1e-6));
    double tilt = 2 * G * 0.05 / (4 * K * 0.2 * 0.2);
    // the centre of mass wanders by the tilt times half the edge, a 400th of its offset
    assertThat(rest.column("fa.q[2]")[0]).isCloseTo(tilt / 2, within(tilt / 200));
    assertThat(rest.column("fa.q[1]")[0]).isCloseTo(0, within(1e-6));
  }

  @Test
  void crateThatFallsOnAnEdgeEndsOnAFace() throws Exception {
    String askew = "0.9689124217106447;0.24740395925452294;0;0;0;0;0.5";
    Trajectory rest =
        model(body("a", 2, 0.05), free("a"), crateOn("z", ""), start("a", askew)).equilibrium();
    assertThat(rest.column("fa.q[6]")[0]).isCloseTo(0.2 - 2 * G / (4 * K), within(1e-6));
  }

  /** Friction is zero at rest, so the crate slides for ever. */
  @ParameterizedTest
  @ValueSource(strings = {"", "friction='0.5' frictionSpeed='0.01'"})
  void crateOnASlopeHasNoRest(String friction) throws Exception {
    MechModel model =
        model(body("a", 2, 0), free("a"), crateOn("s", friction), start("a", LEVEL + "0.5"));
    assertThatThrownBy(model::equilibrium)
        .hasMessageContaining("N-063")
        .hasMessageContaining("a body on a slope slides");
  }

  /** A ball falls onto a ball that has fallen onto the floor, and not through it. */
  @Test
  void ballsRestOnEachOther() throws Exception {
    Trajectory rest =
        model(
                body("a", 2, 0) + body("b", 1, 0),
                free("a") + free("b"),
                onFloor("a") + onFloor("b") + between("a", "b"),
                start("a", LEVEL + "1") + start("b", LEVEL + "2"))
            .equilibrium();
    double lower = 0.1 - 3 * G / K;
    assertThat(rest.column("fa.q[6]")[0]).isCloseTo(lower, within(1e-8));
    assertThat(rest.column("fb.q[6]")[0]).isCloseTo(lower + 0.2 - G / K, within(1e-8));
  }

  @Test
  void ballsBesideEachOtherRestOnTheFloor() throws Exception {
    Trajectory rest =
        model(
                body("a", 2, 0) + body("b", 1, 0) + body("c", 3, 0),
                free("a") + free("b") + free("c"),
                onFloor("a") + onFloor("b") + onFloor("c") + between("a", "b") + between("b", "c"),
                start("a", LEVEL + "1")
                    + start("b", "1;0;0;0;1;0;0.5")
                    + start("c", "1;0;0;0;0;1;3"))
            .equilibrium();
    assertThat(rest.column("fa.q[6]")[0]).isCloseTo(0.1 - 2 * G / K, within(1e-8));
    assertThat(rest.column("fb.q[6]")[0]).isCloseTo(0.1 - G / K, within(1e-8));
    assertThat(rest.column("fc.q[6]")[0]).isCloseTo(0.1 - 3 * G / K, within(1e-8));
  }

  /** A pendulum of 1 m falls on a ball that lies in its way. */
  @ParameterizedTest
  @CsvSource({"0", "0.3", "-0.5"})
  void pendulumLeansOnABallInItsWay(double angle) throws Exception {
    String bob =
        "<body name='p'><point name='o' x='0' y='0' z='0'/><point name='e' x='1' y='0' z='0'/>"
            + "<vector name='y' vx='0' vy='1' vz='0'/><cog x='1' y='0' z='0'/><mass value='1'/>"
            + "</body>";
    String hinge =
        "<joint name='h' type='R'><body1 name='G' point='o' vector='y'/><body2 name='p' point='o'"
            + " vector='y'/></joint>";
    String stop =
        "<sphereContact name='stop' radius1='0.2' radius2='0.1' stiffness='1e4'><body1 name='G'"
            + " point='b'/><body2 name='p' point='e'/></sphereContact>";
    MechModel model =
        MechModel.of(
            "stop.xml",
            "<MechML><MBSsimulation><static/></MBSsimulation><MBSmodel name='stop' massUnits='kg'"
                + " lengthUnits='m'><Bodies><body name='G'><point name='o' x='0' y='0' z='0'/>"
                + "<point name='b' x='0.5' y='0' z='-0.8660254037844386'/><vector name='y' vx='0'"
                + " vy='1' vz='0'/></body>"
                + bob
                + "</Bodies><Joints>"
                + hinge
                + "</Joints><Forces><gravity gx='0' gy='0' gz='-9.81'/>"
                + stop
                + "</Forces><topology><root name='G'/><relCoorVals>"
                + start("", "").replace("name='f'", "name='h'").replace("''", "'" + angle + "'")
                + "</relCoorVals></topology></MBSmodel></MechML>");
    double found = model.equilibrium().column("h.q")[0];
    // the chord between the centres, 2 sin of half the angle, is 0.3 less the depth
    double away = Math.PI / 3 - found;
    double depth = 0.3 - 2 * Math.sin(away / 2);
    assertThat(away).isPositive();
    assertThat(depth).isPositive();
    assertThat(K * depth * Math.cos(away / 2)).isCloseTo(G * Math.cos(found), within(1e-6));
  }
}
