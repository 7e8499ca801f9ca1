package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.api.result.ColumnGroup;

/** Wheels, balls and edges that do not slip, against closed solutions and published figures. */
class RollingTest {
  private static final double G = 9.81;

  /** Radius, m, angle between the disc and the plane, and rate of precession of the disc. */
  private static final double RADIUS = 0.5;

  private static final double LEAN = Math.PI / 3;
  private static final double PRECESSION = 3;

  private static String run(String formulation, String closure, String integrator, double end) {
    return "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='"
        + end
        + "' tstep='"
        + end / 10
        + "'/><integrator name='"
        + integrator
        + "' relTol='1e-10' absTol='1e-12'/><formulation name='"
        + formulation
        + "' closure='"
        + closure
        + "'/></dynamic></MBSsimulation>";
  }

  private static String disc(String simulation, String start, String place) {
    return simulation
        + "<MBSmodel name='disc' massUnits='kg' lengthUnits='m'><Bodies><body name='Ground'><point"
        + " name='o' x='0' y='0' z='0'/><vector name='n' vx='0' vy='0' vz='1'/></body><body"
        + " name='disc'><point name='o' x='0' y='0' z='0'/><vector name='axle' vx='0' vy='0'"
        + " vz='1'/><mass value='1.7'/><inertiaTensor Ixx='1.7*0.25/4' Iyy='1.7*0.25/4'"
        + " Izz='1.7*0.25/2'/></body></Bodies><Joints><joint name='free' type='F'><body1"
        + " name='Ground' point='o'/><body2 name='disc' point='o'/></joint></Joints><Constraints>"
        + "<Rolling name='rim' radius='0.5'><body1 name='Ground' point='o' vector='n'/><body2"
        + " name='disc' point='o' vector='axle'/></Rolling></Constraints><Forces><gravity gx='0'"
        + " gy='0' gz='-9.81'/></Forces><topology><root name='Ground'/><relCoorVals><jointVal"
        + " name='free' posVals='"
        + place
        + "' velVals='"
        + start
        + "'/></relCoorVals></topology></MBSmodel></MechML>";
  }

  private static MechModel of(String text) throws MechmlException {
    return MechModel.of("m.xml", text);
  }

  /**
   * A disc that leans by a constant angle rolls in a circle. With the track e1, e2 up in the disc's
   * plane, e3 the axle, A = m r²/4 and C = m r²/2, the balance of moments about the centre is Ω (C
   * ω3 sin θ − A Ω sin θ cos θ) = −m r (r ω3 Ω sin θ + g cos θ).
   */
  @CsvSource({
    "DSR, projection, ode113, 1e-8",
    "DSR, penalty, ode113, 1e-8",
    "DSR, projection, ode15s, 1e-7",
    "RR, projection, ode15sR, 1e-7",
    "RR, penalty, ode15sR, 1e-7",
    "RR-JF, projection, ode15sR, 1e-7",
    "RR-JF, penalty, ode15sR, 1e-7"
  })
  @ParameterizedTest
  void leaningDiscRollsInItsCircle(
      String formulation, String closure, String integrator, double tolerance) throws Exception {
    double sin = Math.sin(LEAN);
    double cos = Math.cos(LEAN);
    double spin =
        (RADIUS / 4 * PRECESSION * PRECESSION * sin * cos - G * cos)
            / (1.5 * RADIUS * PRECESSION * sin);
    double relative = spin - PRECESSION * cos;
    double speed = -RADIUS * spin;
    String start =
        "0;" + -relative * sin + ";" + (PRECESSION + relative * cos) + ";" + speed + ";0;0";
    String place = Math.cos(LEAN / 2) + ";" + Math.sin(LEAN / 2) + ";0;0;0;0;" + RADIUS * sin;
    Trajectory rows =
        of(disc(run(formulation, closure, integrator, 1), start, place))
            .columns(ColumnGroup.JOINTS, ColumnGroup.ENERGY, ColumnGroup.CONSTRAINTS)
            .simulate();
    for (int i = 0; i < rows.rows(); i++) {
      double angle = PRECESSION * rows.time()[i];
      assertThat(rows.column("free.q[4]")[i])
          .isCloseTo(speed / PRECESSION * Math.sin(angle), within(tolerance));
      assertThat(rows.column("free.q[5]")[i])
          .isCloseTo(speed / PRECESSION * (1 - Math.cos(angle)), within(tolerance));
      assertThat(rows.column("free.q[6]")[i]).isCloseTo(RADIUS * sin, within(tolerance));
      // rows are interpolated between steps that obey the constraints
      assertThat(rows.column("constraint.velocity")[i]).isLessThan(1e-9);
    }
    // λ of the plane: the weight, as the centre keeps its height
    assertThat(rows.column("rim.lambda[0]")[10]).isCloseTo(-1.7 * G, within(1e3 * tolerance));
  }

  /** Euler's disc without friction losses: it wobbles, and its energy stays. */
  @Test
  void tumblingDiscKeepsItsEnergy() throws Exception {
    String start = "0.4;1.1;6;0;0;0";
    String place = Math.cos(0.3) + ";" + Math.sin(0.3) + ";0;0;0;0;0.3";
    Trajectory rows =
        of(disc(run("DSR", "projection", "ode113", 2), start, place))
            .columns(ColumnGroup.JOINTS, ColumnGroup.ENERGY)
            .simulate();
    double first = rows.column("energy.kinetic")[0] + rows.column("energy.potential")[0];
    for (int i = 0; i < rows.rows(); i++) {
      assertThat(rows.column("energy.kinetic")[i] + rows.column("energy.potential")[i])
          .isCloseTo(first, within(1e-8 * first));
    }
    assertThat(rows.column("free.q[6]")[10])
        .isNotCloseTo(rows.column("free.q[6]")[0], within(1e-3));
  }

  /**
   * A skate that turns at a constant rate ω on a slope has the speed (g sin α / ω) sin ωt: it goes
   * across the slope and not down.
   */
  @CsvSource({
    "DSR, projection, ode113, 1e-8",
    "DSR, penalty, ode113, 1e-8",
    "RR, projection, ode15sR, 1e-7",
    "RR, penalty, ode15sR, 1e-7",
    "RR-JF, projection, ode15sR, 1e-7",
    "RR-JF, penalty, ode15sR, 1e-7"
  })
  @ParameterizedTest
  void skateGoesAcrossTheSlope(
      String formulation, String closure, String integrator, double tolerance) throws Exception {
    String text =
        run(formulation, closure, integrator, 3)
            + "<MBSmodel name='skate' massUnits='kg' lengthUnits='m'><Bodies><body name='Ground'>"
            + "<point name='o' x='0' y='0' z='0'/><vector name='x' vx='1' vy='0' vz='0'/><vector"
            + " name='z' vx='0' vy='0' vz='1'/></body><body name='skate'><point name='o' x='0'"
            + " y='0' z='0'/><vector name='side' vx='0' vy='1' vz='0'/><vector name='z' vx='0'"
            + " vy='0' vz='1'/><mass value='3'/><inertiaTensor Ixx='1' Iyy='1' Izz='2'/></body>"
            + "</Bodies><Joints><joint name='ice' type='PL'><body1 name='Ground' point='o'"
            + " vector='z' vector2='x'/><body2 name='skate' point='o' vector='z'/></joint></Joints>"
            + "<Constraints><KnifeEdge name='blade'><body1 name='Ground' point='o'/><body2"
            + " name='skate' point='o' vector='side'/></KnifeEdge></Constraints><Forces><gravity"
            + " gx='2' gy='0' gz='-9'/></Forces><topology><root name='Ground'/><relCoorVals>"
            + "<jointVal name='ice' posVals='0;0;0' velVals='0;0;1.5'/></relCoorVals></topology>"
            + "</MBSmodel></MechML>";
    Trajectory rows = of(text).columns(ColumnGroup.JOINTS, ColumnGroup.CONSTRAINTS).simulate();
    assertThat(rows.rows()).isGreaterThan(1);
    double factor = 2 / (2 * 1.5 * 1.5);
    for (int i = 0; i < rows.rows(); i++) {
      double angle = 1.5 * rows.time()[i];
      double sin = Math.sin(angle);
      assertThat(rows.column("ice.q[0]")[i]).isCloseTo(factor * sin * sin, within(tolerance));
      assertThat(rows.column("ice.q[1]")[i])
          .isCloseTo(factor * (angle - 0.5 * Math.sin(2 * angle)), within(tolerance));
      // the blade bears the weight across it and turns the velocity: m (2 g_x sin ωt)
      assertThat(rows.column("blade.lambda")[i])
          .isCloseTo(-3 * 2 * 2 * sin, within(1e2 * tolerance));
    }
  }

  private static MechModel bicycle(double speed) throws Exception {
    return MechModel.read(Path.of("../examples/bicycle/bicycle.xml")).set("speed", speed);
  }

  /**
   * Meijaard, Papadopoulos, Ruina and Schwab 2007, table 2 and section 5: the eigenvalues at 5 m/s,
   * and those of M λ² + v C1 λ + g K0 + v² K2 with the published matrices.
   */
  @Test
  void bicycleHasThePublishedEigenvalues() throws Exception {
    Trajectory modes = bicycle(5).simulate();
    assertThat(largestMiss(modes, -0.322866429004090, 0)).isLessThan(1e-12);
    assertThat(largestMiss(modes, -0.775341882195845, 4.464867713788230)).isLessThan(1e-12);
    assertThat(largestMiss(modes, -14.078389692798200, 0)).isLessThan(1e-12);
  }

  private static double largestMiss(Trajectory modes, double re, double im) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < modes.rows(); i++) {
      double real = modes.column("eigenvalue.re")[i] - re;
      double imaginary = modes.column("eigenvalue.im")[i] - im;
      least = Math.min(least, Math.hypot(real, imaginary) / Math.hypot(re, im));
    }
    return least;
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 1, 3, 8})
  void bicyclesModesSolveThePublishedEquations(double v) throws Exception {
    Trajectory modes = bicycle(v).simulate();
    int found = 0;
    for (int i = 0; i < modes.rows(); i++) {
      double re = modes.column("eigenvalue.re")[i];
      double im = modes.column("eigenvalue.im")[i];
      if (re != 0 || im != 0) {
        found += im == 0 ? 1 : 2;
        assertThat(distanceToRoot(v, re, im)).isLessThan(1e-10);
      }
    }
    assertThat(found).isEqualTo(4);
  }

  /** One Newton step of det(M λ² + v C1 λ + g K0 + v² K2) = 0 from λ, relative to |λ|. */
  private static double distanceToRoot(double v, double re, double im) {
    double[][] m = {{80.81722, 2.31941332208709}, {2.31941332208709, 0.29784188199686}};
    double[][] c = {{0, 33.86641391492494}, {-0.85035641456978, 1.68540397397560}};
    double[][] k0 = {{-80.95, -2.59951685249872}, {-2.59951685249872, -0.80329488458618}};
    double[][] k2 = {{0, 76.59734589573222}, {0, 2.65431523794604}};
    double[] polynomial = new double[5];
    for (int sign = 1; sign >= -1; sign -= 2) {
      int j = sign > 0 ? 0 : 1;
      double[] a = {G * k0[0][j] + v * v * k2[0][j], v * c[0][j], m[0][j]};
      double[] b = {G * k0[1][1 - j] + v * v * k2[1][1 - j], v * c[1][1 - j], m[1][1 - j]};
      for (int p = 0; p < 3; p++) {
        for (int q = 0; q < 3; q++) {
          polynomial[p + q] += sign * a[p] * b[q];
        }
      }
    }
    double[] value = {0, 0};
    double[] slope = {0, 0};
    for (int p = 4; p >= 0; p--) {
      slope =
          new double[] {
            slope[0] * re - slope[1] * im + value[0], slope[0] * im + slope[1] * re + value[1]
          };
      value =
          new double[] {
            value[0] * re - value[1] * im + polynomial[p], value[0] * im + value[1] * re
          };
    }
    return Math.hypot(value[0], value[1]) / (Math.hypot(slope[0], slope[1]) * Math.hypot(re, im));
  }

  /** A ride after a push at a stable speed: the lean of small motions obeys the eigenvalues. */
  @Test
  void pushedBicycleRightsItself() throws Exception {
    Trajectory ride = bicycle(5).set("kick", 0.1).simulation("ride").until(10).simulate();
    double[] lean = ride.column("frame.q[1]");
    double largest = 0;
    for (double part : lean) {
      largest = Math.max(largest, Math.abs(part));
    }
    assertThat(largest).isGreaterThan(1e-3);
    assertThat(Math.abs(lean[lean.length - 1])).isLessThan(0.1 * largest);
    assertThat(ride.report().energyDrift().orElseThrow()).isLessThan(1e-5);
  }

  @Test
  void kinematicsSaysThatRollingLeavesPositionsFree() throws Exception {
    String text =
        disc(
            "<MechML><MBSsimulation><kinematic><timeSet tini='0' tend='1' tstep='0.1'/>"
                + "</kinematic></MBSsimulation>",
            "0;0;0;0;0;0",
            "sqrt(0.5);sqrt(0.5);0;0;0;0;0.5");
    assertThatThrownBy(() -> of(text).simulate())
        .hasMessageContaining("constraint \"rim\"")
        .hasMessageContaining("velocities alone");
  }

  /** A wheel on a plane along x, its axle along y. */
  private static String wheel(String simulation, String joints, String topology) {
    return simulation
        + "<MBSmodel name='wheel' massUnits='kg' lengthUnits='m'><Bodies><body name='Ground'><point"
        + " name='o' x='0' y='0' z='0'/><point name='floor' x='0' y='0' z='-0.4'/><vector name='x'"
        + " vx='1' vy='0' vz='0'/><vector name='y' vx='0' vy='1' vz='0'/><vector name='n' vx='0'"
        + " vy='0' vz='1'/></body><body name='cart'>"
        + "<point name='o' x='0' y='0' z='0'/><vector name='x' vx='1' vy='0' vz='0'/><vector"
        + " name='y' vx='0' vy='1' vz='0'/><mass value='2'/></body><body name='wheel'><point"
        + " name='o' x='0' y='0' z='0'/><vector name='y' vx='0' vy='1' vz='0'/><cog x='0.1' y='0'"
        + " z='0'/><mass value='3'/><inertiaTensor Ixx='0.1' Iyy='0.2' Izz='0.1'/></body></Bodies>"
        + joints
        + "<Constraints><Rolling name='tread' radius='0.3' tube='0.1'><body1 name='Ground'"
        + " point='floor' vector='n'/><body2 name='wheel' point='o' vector='y'/></Rolling>"
        + "</Constraints><Forces><gravity gx='0' gy='0' gz='-9.81'/></Forces><topology><root"
        + " name='Ground'/>"
        + topology
        + "</topology></MBSmodel></MechML>";
  }

  private static final String DRIVEN =
      "<Joints><joint name='way' type='P'><body1 name='Ground' point='o' vector='x'/><body2"
          + " name='cart' point='o' vector='x'/></joint><joint name='hub' type='R'><body1"
          + " name='cart' point='o' vector='y'/><body2 name='wheel' point='o' vector='y'/></joint>"
          + "</Joints>";

  /** Nothing is free: the wheel turns by the way over its radius, redundant equations hold too. */
  @CsvSource({
    "DSR, projection, ode113",
    "DSR, penalty, ode113",
    "RR, projection, ode15sR",
    "RR-JF, penalty, ode15sR"
  })
  @ParameterizedTest
  void drivenWheelTurnsByItsWay(String formulation, String closure, String integrator)
      throws Exception {
    String topology = "<relCoorVals><jointVal name='way' driven='t^2'/></relCoorVals>";
    Trajectory rows =
        of(wheel(run(formulation, closure, integrator, 1), DRIVEN, topology)).simulate();
    assertThat(rows.rows()).isGreaterThan(1);
    for (int i = 0; i < rows.rows(); i++) {
      double t = rows.time()[i];
      assertThat(rows.column("hub.q")[i]).isCloseTo(t * t / 0.4, within(1e-8));
      assertThat(rows.column("hub.v")[i]).isCloseTo(2 * t / 0.4, within(1e-8));
    }
  }

  /** A wheel that is heavier on one side rolls until that side is down, and is elsewhere then. */
  @Test
  void heavySideRollsDown() throws Exception {
    String joints =
        "<Joints><joint name='fixed' type='W'><body1 name='Ground' point='o'/><body2 name='cart'"
            + " point='o'/></joint><joint name='plane' type='PL'><body1 name='Ground' point='o'"
            + " vector='y' vector2='x'/><body2 name='wheel' point='o' vector='y'/></joint>"
            + "</Joints>";
    String topology = "<relCoorVals><jointVal name='plane' posVals='0; 0; 0.3'/></relCoorVals>";
    Trajectory rest =
        of(wheel("<MechML><MBSsimulation><static/></MBSsimulation>", joints, topology)).simulate();
    // the angle is about y: a positive one turns x downwards, and rolls along x
    assertThat(rest.column("plane.q[2]")[0]).isCloseTo(Math.PI / 2, within(1e-7));
    assertThat(rest.column("plane.q[0]")[0]).isCloseTo(0.4 * (Math.PI / 2 - 0.3), within(1e-7));
  }

  /** A wheel and a ball of the same inertia roll down a slope alike, 5/14 g sin 30° t². */
  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void ballRollsDownTheSlope(boolean ball) throws Exception {
    String text = Files.readString(Path.of("../examples/elements/Rolling.xml"));
    if (ball) {
      text =
          text.replace("radius=\"400\" tube=\"100\"", "radius=\"500\"")
              .replace("point=\"o\" vector=\"axle\"", "point=\"o\"");
      assertThat(text).doesNotContain("tube");
    }
    Trajectory rows = of(text).columns(ColumnGroup.JOINTS, ColumnGroup.CONSTRAINTS).simulate();
    double way = 5.0 / 14 * G * 0.5;
    assertThat(rows.column("flight.q[4]")[10])
        .isCloseTo(0.25 + way * Math.sqrt(0.75), within(1e-8));
    assertThat(rows.column("flight.q[6]")[10])
        .isCloseTo(Math.sqrt(3) / 4 - 0.5 * way, within(1e-8));
    // the friction that turns it is 2/7 of the weight along the slope
    double friction =
        Math.hypot(rows.column("slope.lambda[1]")[5], rows.column("slope.lambda[2]")[5]);
    double pressure = -rows.column("slope.lambda[0]")[5];
    assertThat(friction / pressure).isCloseTo(2.0 / 7 / Math.sqrt(3), within(1e-8));
  }
}
