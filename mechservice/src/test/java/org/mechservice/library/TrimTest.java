package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.program.RunFailedException;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Trim problems and equilibria of models with states. Newton's method ends where the residual needs
 * less than 1e-9 of the unknowns; its last step squares that, so that 1e-11 is left at most.
 */
class TrimTest {
  private static final String AXES =
      "<point name='o' x='0' y='0' z='0'/><vector name='x' vx='1' vy='0' vz='0'/><vector name='y'"
          + " vx='0' vy='1' vz='0'/><vector name='z' vx='0' vy='0' vz='1'/>";

  private static MechModel of(String simulation, String bodies, String parts)
      throws MechmlException {
    return MechModel.of(
        "m.xml",
        "<MechML><MBSsimulation>"
            + simulation
            + "</MBSsimulation><MBSmodel name='m' massUnits='kg' lengthUnits='m'><Bodies><body"
            + " name='Ground'>"
            + AXES
            + "<point name='far' x='2' y='0' z='0'/></body>"
            + bodies
            + "</Bodies>"
            + parts
            + "</MBSmodel></MechML>");
  }

  private static String joint(String name, String type, String body1, String body2, String axis) {
    return "<joint name='"
        + name
        + "' type='"
        + type
        + "'><body1 name='"
        + body1
        + "' point='o' vector='"
        + axis
        + "'/><body2 name='"
        + body2
        + "' point='o' vector='"
        + axis
        + "'/></joint>";
  }

  private static String trim(String unknowns, String conditions) {
    StringBuilder text = new StringBuilder("<trim>");
    for (String name : unknowns.split(" ", -1)) {
      text.append("<unknown name='").append(name).append("'/>");
    }
    for (String condition : conditions.split(" ", -1)) {
      String[] parts = condition.split("=", -1);
      text.append("<condition name='").append(parts[0]).append("' value='").append(parts[1]);
      text.append("'/>");
    }
    return text.append("</trim>").toString();
  }

  private static double only(Trajectory row, String column) {
    return row.column(column)[0];
  }

  /** A cart of 4 kg and a wheel of 1 kg, radius 0.3 m, which a torque drives against v² drag. */
  private static MechModel vehicle(String simulation) throws MechmlException {
    return of(
        simulation,
        "<body name='cart'>"
            + AXES
            + "<mass value='4'/></body><body name='wheel'>"
            + AXES
            + "<mass value='1'/><inertiaTensor Ixx='0.03' Iyy='0.05' Izz='0.03'/></body>",
        "<Joints>"
            + joint("slide", "P", "Ground", "cart", "x")
            + joint("axle", "R", "cart", "wheel", "y")
            + "</Joints><Constraints><CoordConstraint name='rolls' constant='0'><term joint='slide'"
            + " factor='1'/><term joint='axle' factor='-0.3'/></CoordConstraint></Constraints>"
            + "<States><input name='torque' unit='N*m'/></States><Forces><jointForce name='drag'"
            + " joint='slide' expression='-0.4*slide.v*abs(slide.v)'/><jointForce name='motor'"
            + " joint='axle' expression='torque'/><gravity gx='0' gy='0' gz='-9.81'/></Forces>"
            + "<Outputs><output name='speed' expression='slide.v' unit='m/s'/></Outputs><topology>"
            + "<root name='Ground'/></topology>");
  }

  @Test
  void torqueAtConstantSpeedIsThatOfTheDrag() throws Exception {
    String steady = trim("slide.v torque", "slide.a=0 speed=20");
    Trajectory row = vehicle("<static>" + steady + "</static>").simulate();

    assertThat(only(row, "torque")).isCloseTo(0.3 * 0.4 * 400, within(1e-9));
    assertThat(only(row, "slide.v")).isCloseTo(20, within(1e-11));
    assertThat(only(row, "axle.v")).isCloseTo(20 / 0.3, within(1e-10));
  }

  /** (4 + 1 + 0.05/0.09) v' = -0.8 · 20 v near the operating point. */
  @Test
  void modesAtConstantSpeedAreThoseOfTheLinearDrag() throws Exception {
    String steady = trim("slide.v torque", "slide.a=0 speed=20");
    Trajectory modes = vehicle("<linearize at='trim'>" + steady + "</linearize>").simulate();

    double[] growth = modes.column("eigenvalue.re");
    assertThat(growth[growth.length - 1]).isCloseTo(-16 / (5 + 0.05 / 0.09), within(1e-8));
  }

  @Test
  void trimThatNothingDeterminesIsSaid() throws Exception {
    Trajectory row =
        vehicle("<static>" + trim("slide.q torque", "slide.a=0 speed=0") + "</static>").simulate();

    assertThat(row.report().notes())
        .filteredOn(note -> note.code() == MessageCode.TRIM_NOT_UNIQUE)
        .singleElement()
        .satisfies(note -> assertThat(note.text()).contains("do not determine \"slide.q\""));
  }

  @Test
  void trimThatContradictsItselfIsSaid() throws Exception {
    MechModel model =
        vehicle("<static>" + trim("slide.q torque", "slide.a=0 speed=3") + "</static>");

    assertThatThrownBy(model::simulate)
        .isInstanceOf(RunFailedException.class)
        .hasMessageContaining("N-068")
        .hasMessageContaining("\"speed\" is 0")
        .hasMessageContaining("no unknown changes \"speed\"");
  }

  /** Statics, which minimises, is the second way to the same position. */
  @Test
  void torqueThatHoldsAFourBarMakesItAnEquilibrium() throws Exception {
    String bars = bar("crank", 1, 2) + bar("coupler", 2, 3) + bar("rocker", 1.5, 2.5);
    String parts =
        "<Joints>"
            + link("A", "Ground", "o", "crank", "o")
            + link("B", "crank", "end", "coupler", "o")
            + link("D", "Ground", "far", "rocker", "o")
            + "</Joints><Constraints><DISTConstraint name='C' dist='0.5'><body1 name='coupler'"
            + " point='end'/><body2 name='rocker' point='end'/></DISTConstraint></Constraints>"
            + "<States><input name='torque' x0='TORQUE' unit='N*m'/></States><Forces><jointForce"
            + " name='motor' joint='A' expression='torque - 40*A.q'/><jointForce name='spring'"
            + " joint='D' expression='-30*D.q'/><gravity gx='0' gy='0' gz='-9.81'/></Forces>"
            + "<Outputs><output name='angle' expression='A.q'/></Outputs><topology><root"
            + " name='Ground'/><relCoorVals><jointVal name='A' posVals='-1.2'/><jointVal name='B'"
            + " posVals='1.2'/><jointVal name='D' posVals='-1.3'/></relCoorVals></topology>";
    String held =
        "<static>" + trim("A.q B.q D.q torque", "A.a=0 B.a=0 D.a=0 angle=-1") + "</static>";
    Trajectory trimmed = of(held, bars, parts.replace("TORQUE", "0")).simulate();
    String torque = Double.toString(only(trimmed, "torque"));
    Trajectory rest = of("<static/>", bars, parts.replace("TORQUE", torque)).simulate();

    assertThat(only(trimmed, "A.q")).isCloseTo(-1, within(1e-11));
    for (String joint : new String[] {"A.q", "B.q", "D.q"}) {
      // Statics ends at 1e-9 of the forces in play.
      assertThat(only(rest, joint)).isCloseTo(only(trimmed, joint), within(1e-8));
    }
  }

  private static String bar(String name, double length, double mass) {
    return "<body name='"
        + name
        + "'>"
        + AXES
        + "<point name='end' x='"
        + length
        + "' y='0' z='0'/><cog x='"
        + length / 2
        + "' y='0' z='0'/><mass value='"
        + mass
        + "'/></body>";
  }

  private static String link(
      String name, String body1, String point1, String body2, String point2) {
    return "<joint name='"
        + name
        + "' type='R'><body1 name='"
        + body1
        + "' point='"
        + point1
        + "' vector='y'/><body2 name='"
        + body2
        + "' point='"
        + point2
        + "' vector='y'/></joint>";
  }

  private static MechModel lift(String states, String force, String at) throws MechmlException {
    return of(
        at,
        "<body name='lift'>" + AXES + "<mass value='2'/></body>",
        "<Joints>"
            + joint("rise", "P", "Ground", "lift", "z")
            + "</Joints><States>"
            + states
            + "</States><Forces><jointForce name='motor' joint='rise' expression='"
            + force
            + "'/><gravity gx='0' gy='0' gz='-9.81'/></Forces><topology><root name='Ground'/>"
            + "</topology>");
  }

  /** The integral of the error carries the weight, so that the lift rests at the setpoint. */
  @Test
  void controllerWithAnIntegralRestsAtItsSetpoint() throws Exception {
    String pid =
        "<pid name='p' measured='rise.q' setpoint='0.7' kp='300' ki='200' kd='40' filter='0.02'/>";
    MechModel model = lift(pid, "p", "<static/>");
    Trajectory row = model.simulate();

    assertThat(only(row, "rise.q")).isCloseTo(0.7, within(1e-11));
    assertThat(only(row, "p.integral")).isCloseTo(2 * 9.81, within(1e-7));
    assertThat(row.report().notes()).isEmpty();
    assertThat(model.equilibrium().column("rise.q")).isEqualTo(row.column("rise.q"));
  }

  /** 2/(0.1 s + 1) of the position is 2 q at rest: 100 · 2 q = -m g. */
  @Test
  void filterAtRestHasItsSteadyGain() throws Exception {
    String filter = "<transferFunction name='f' input='rise.q' num='2' den='0.1; 1'/>";
    Trajectory row = lift(filter, "-100*f - 5*rise.v", "<static/>").simulate();

    assertThat(only(row, "rise.q")).isCloseTo(-2 * 9.81 / 200, within(1e-11));
  }

  @Test
  void integratorWhoseInputIsNotZeroHasNoEquilibrium() throws Exception {
    MechModel model = lift("<state name='s' derivative='0.5'/>", "-100*rise.q", "<static/>");

    assertThatThrownBy(model::simulate)
        .isInstanceOf(RunFailedException.class)
        .hasMessageContaining("N-063")
        .hasMessageContaining("\"s.rate\" is 0.5");
  }

  @Test
  void modesAtRestAreThoseOfTheLoop() throws Exception {
    String filter = "<transferFunction name='f' input='rise.q' num='2' den='0.1; 1'/>";
    String force = "-100*f - 5*rise.v";
    Trajectory atRest = lift(filter, force, "<linearize at='equilibrium'/>").simulate();
    Trajectory atStart = lift(filter, force, "<linearize/>").simulate();

    // The loop is linear, so that its modes do not depend on the position.
    assertThat(atRest.column("eigenvalue.re"))
        .containsExactly(atStart.column("eigenvalue.re"), within(1e-7));
  }

  @Test
  void elementExampleHoldsItsPendulum() throws Exception {
    MechModel model = MechModel.read(Path.of("../examples/elements/trim.xml"));

    assertThat(only(model.simulate(), "torque")).isCloseTo(9.81 * Math.sin(0.5), within(1e-11));
    assertThat(only(model.simulation("2").simulate(), "eigenvalue.im"))
        .isCloseTo(Math.sqrt(9.81 / 0.5 * Math.cos(0.5)), within(1e-8));
  }
}
