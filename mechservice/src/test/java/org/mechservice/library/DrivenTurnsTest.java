package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.api.result.ColumnGroup;

/** Driven spherical and free joints: motion, forces and power, against closed solutions. */
class DrivenTurnsTest {
  private static final double A = 0.11;
  private static final double B = 0.16;
  private static final double C = 0.23;

  /** Cone: nutation 0.6 rad, precession 2 rad/s, spin 5 rad/s. */
  private static final double NUTATION = 0.6;

  private static final double PRECESSION = 2;
  private static final double SPIN = 5;

  private static final String DYNAMIC =
      "<dynamic><timeSet tini='0' tend='1.5' tstep='0.05'/><integrator name='ode113'"
          + " relTol='1e-10' absTol='1e-10'/></dynamic>";
  private static final String TIMES = "<timeSet tini='0' tend='1.5' tstep='0.05'/>";
  private static final String INVERSE = "<inverseDynamic>" + TIMES + "</inverseDynamic>";

  private static String top(String task, String type, String driven, String body, String joint) {
    return "<MechML><MBSsimulation>"
        + task
        + "</MBSsimulation><MBSmodel name='top' massUnits='kg' lengthUnits='m'"
        + " silence='no-gravity'><Bodies><body name='Ground'><point name='o' x='0' y='0'"
        + " z='0'/></body><body name='top'><point name='o' x='0' y='0' z='0'/><point name='p'"
        + " x='0' y='0' z='1'/>"
        + AXES
        + "<mass value='3'/><inertiaTensor Ixx='0.11' Iyy='0.16' Izz='0.23'"
        + " Ixy='0' Ixz='0' Iyz='0'/></body>"
        + body
        + "</Bodies><Joints><joint name='j' type='"
        + type
        + "'><body1 name='Ground' point='o'/><body2 name='top' point='o'/></joint>"
        + joint
        + "</Joints><Outputs><output name='z' expression='top.p.z'/></Outputs><topology><root"
        + " name='Ground'/><relCoorVals><jointVal name='j' "
        + driven
        + "/></relCoorVals></topology></MBSmodel></MechML>";
  }

  private static final String ANGLES = "driven='2*t; 0.6; 5*t' rotation='zxz'";

  /** The same path as a quaternion that is not normalised. */
  private static final String QUATERNION =
      "driven='(2+t)*cos(0.3)*cos(3.5*t); (2+t)*sin(0.3)*cos(-1.5*t); (2+t)*sin(0.3)*sin(-1.5*t);"
          + " (2+t)*cos(0.3)*sin(3.5*t)'";

  private static MechModel of(String text) throws MechmlException {
    return MechModel.of("top.xml", text)
        .columns(ColumnGroup.DRIVES, ColumnGroup.FORCES, ColumnGroup.ENERGY, ColumnGroup.OUTPUTS);
  }

  /**
   * Torque of Euler's equations about body axes for the regular motion of Euler's angles, turned
   * into the axes of the base.
   */
  private static double[] torque(double t) {
    double sn = Math.sin(NUTATION);
    double cn = Math.cos(NUTATION);
    double s = Math.sin(SPIN * t);
    double c = Math.cos(SPIN * t);
    double[] w = {PRECESSION * sn * s, PRECESSION * sn * c, PRECESSION * cn + SPIN};
    double[] rate = {PRECESSION * SPIN * sn * c, -PRECESSION * SPIN * sn * s, 0};
    double[] m = {
      A * rate[0] + (C - B) * w[1] * w[2],
      B * rate[1] + (A - C) * w[2] * w[0],
      C * rate[2] + (B - A) * w[0] * w[1]
    };
    double[] spun = {c * m[0] - s * m[1], s * m[0] + c * m[1], m[2]};
    double[] tilted = {spun[0], cn * spun[1] - sn * spun[2], sn * spun[1] + cn * spun[2]};
    double sp = Math.sin(PRECESSION * t);
    double cp = Math.cos(PRECESSION * t);
    return new double[] {
      cp * tilted[0] - sp * tilted[1], sp * tilted[0] + cp * tilted[1], tilted[2]
    };
  }

  @ParameterizedTest
  @ValueSource(strings = {ANGLES, QUATERNION})
  void torqueOfARegularPrecessionIsEulers(String driven) throws Exception {
    Trajectory rows = of(top(INVERSE, "S", driven, "", "")).inverseDynamics();
    assertThat(rows.rows()).isGreaterThan(1);
    double[] time = rows.column("t");
    for (int i = 0; i < time.length; i++) {
      double t = time[i];
      double[] expected = torque(t);
      double sn = Math.sin(NUTATION);
      double[] omega = {
        SPIN * sn * Math.sin(PRECESSION * t),
        -SPIN * sn * Math.cos(PRECESSION * t),
        PRECESSION + SPIN * Math.cos(NUTATION)
      };
      double[] alpha = {
        PRECESSION * SPIN * sn * Math.cos(PRECESSION * t),
        PRECESSION * SPIN * sn * Math.sin(PRECESSION * t),
        0
      };
      for (int k = 0; k < 3; k++) {
        String of = "[" + k + "]";
        assertThat(rows.column("j.v" + of)[i]).isCloseTo(omega[k], within(1e-13));
        assertThat(rows.column("j.a" + of)[i]).isCloseTo(alpha[k], within(1e-12));
        assertThat(rows.column("j.drive" + of)[i]).isCloseTo(expected[k], within(1e-12));
        assertThat(rows.column("j.power" + of)[i]).isCloseTo(expected[k] * omega[k], within(1e-11));
      }
      assertThat(rows.column("j.q[0]")[i])
          .isCloseTo(Math.cos(0.3) * Math.cos(3.5 * t), within(1e-14));
      assertThat(rows.column("z")[i]).isCloseTo(Math.cos(NUTATION), within(1e-14));
    }
  }

  /** A pendulum on the driven top: its energy changes by the work of the drive. */
  @ParameterizedTest
  @CsvSource({
    "DTR, ode113",
    "DSR, DE",
    "DTR, ode15s",
    "RR, ode15sR",
    "RR-JF, ode15sR",
    "DTR, auto"
  })
  void energyChangesByTheWorkOfTheDrive(String formulation, String integrator) throws Exception {
    Trajectory rows =
        of(top(DYNAMIC, "F", FREE, BOB, HINGE))
            .formulation(formulation)
            .integrator(integrator)
            .simulate();
    double[] kinetic = rows.column("energy.kinetic");
    double[] work = rows.column("energy.work");
    for (int i = 0; i < kinetic.length; i++) {
      assertThat(kinetic[i] - kinetic[0] - work[i]).isCloseTo(0, within(2e-7));
    }
    Trajectory reference = of(top(DYNAMIC, "F", FREE, BOB, HINGE)).simulate();
    assertThat(rows.column("h.q")).containsExactly(reference.column("h.q"), within(1e-7));
  }

  /** A motion that begins at rest in no coordinate, and passes the angles of a gimbal lock. */
  private static final String FREE =
      "driven='0.5*sin(2*t); 0.4*t^2; 3*t; 0.1*t^3; 0.2*sin(t); 0.3*t' rotation='xyz'";

  private static final String BOB =
      "<body name='bob'><point name='o' x='0' y='0' z='0'/><vector name='y' vx='0' vy='1'"
          + " vz='0'/><cog x='0.2' y='0.1' z='-0.4'/><mass value='2'/><inertiaTensor Ixx='0.1'"
          + " Iyy='0.2' Izz='0.15' Ixy='0.01' Ixz='0' Iyz='0'/></body>";

  private static final String HINGE =
      "<joint name='h' type='R'>"
          + "<body1 name='top' point='p' vector='y'/><body2 name='bob' point='o'"
          + " vector='y'/></joint>";

  /**
   * Three hinges without mass in between are the same motion; the driven ball has no gimbal lock.
   */
  @Test
  void ballMovesAsThreeDrivenHingesDo() throws Exception {
    String gimbal =
        hinge("j1", "Ground", "x", "g1")
            + hinge("j2", "g1", "y", "g2")
            + hinge("j3", "g2", "z", "top");
    String text =
        top(DYNAMIC, "S", "driven='0.5*sin(2*t); 0.4*t^2; 3*t' rotation='xyz'", BOB, HINGE);
    Trajectory ball = of(text).simulate();
    String ground = "<point name='o' x='0' y='0' z='0'/>" + AXES + "</body>";
    String chain =
        text.replace(
                "<point name='o' x='0' y='0' z='0'/></body><body name='top'>",
                ground
                    + "<body name='g1'>"
                    + ground
                    + "<body name='g2'>"
                    + ground
                    + "<body name='top'>")
            .replaceAll("<joint name='j'.*?</joint>", gimbal)
            .replaceAll(
                "<jointVal name='j'.*?/>",
                "<jointVal name='j1' driven='0.5*sin(2*t)'/><jointVal name='j2'"
                    + " driven='0.4*t^2'/><jointVal name='j3' driven='3*t'/>");
    Trajectory hinges = of(chain).simulate();
    assertThat(ball.column("h.q")).containsExactly(hinges.column("h.q"), within(1e-9));
    assertThat(ball.column("energy.work"))
        .containsExactly(hinges.column("energy.work"), within(1e-8));
  }

  private static final String AXES =
      "<vector name='x' vx='1' vy='0' vz='0'/><vector name='y' vx='0' vy='1' vz='0'/><vector"
          + " name='z' vx='0' vy='0' vz='1'/>";

  private static String hinge(String name, String on, String axis, String body) {
    return "<joint name='%s' type='R'><body1 name='%s' point='o' vector='%s'/><body2 name='%s' point='o' vector='%s'/></joint>"
        .formatted(name, on, axis, body, axis);
  }

  /** Poses from tables are followed with the derivatives of the normalised curve. */
  @Test
  void posesOfTablesAreFollowed() throws Exception {
    StringBuilder c = new StringBuilder();
    StringBuilder s = new StringBuilder();
    StringBuilder times = new StringBuilder();
    for (int i = 0; i <= 40; i++) {
      double t = i / 20.0;
      times.append(i == 0 ? "" : ";").append(t);
      c.append(i == 0 ? "" : ";").append(Math.cos(t * t / 2));
      s.append(i == 0 ? "" : ";").append(Math.sin(t * t / 2));
    }
    String tables =
        "<Tables><table name='c' x='%1$s' y='%2$s' method='cubic'/><table name='s' x='%1$s' y='%3$s'"
            + " method='cubic'/></Tables><Bodies>";
    String text =
        top(INVERSE, "S", "driven='c(t);0;s(t);0'", "", "")
            .replace("<Bodies>", tables.formatted(times, c, s));
    Trajectory rows = of(text).inverseDynamics();
    assertThat(rows.rows()).isGreaterThan(1);
    double[] time = rows.column("t");
    for (int i = 0; i < time.length; i++) {
      // the angle about y is t^2; h^2/12 of the fourth derivative of the path, below 4
      assertThat(rows.column("j.v[1]")[i]).isCloseTo(2 * time[i], within(2e-4));
      assertThat(rows.column("j.drive[1]")[i]).isCloseTo(B * 2, within(2e-2));
      assertThat(rows.column("j.v[0]")[i]).isCloseTo(0, within(1e-13));
    }
  }

  @Test
  void kinematicsAndStaticsFollowTheMotion() throws Exception {
    Trajectory moved =
        of(top("<kinematic>" + TIMES + "</kinematic>", "S", ANGLES, "", "")).kinematics();
    assertThat(moved.column("z")).containsOnly(new double[] {Math.cos(NUTATION)}, within(1e-14));
    // held at t = 0 the bob hangs below the point p, in the plane of its hinge
    String text =
        top("<static/>", "S", ANGLES, BOB, HINGE)
            .replace("</Joints>", "</Joints><Forces><gravity gx='0' gy='0' gz='-9.81'/></Forces>");
    Trajectory rest = of(text).equilibrium();
    double q = rest.column("h.q")[0];
    // torque about y of the turned hinge: (Ry(q) cog)_x = 0 along the projected gravity
    assertThat(Math.cos(q) * 0.2 + Math.sin(q) * -0.4).isCloseTo(0, within(1e-9));
  }

  @Test
  void jumpOfTheAngularVelocityIsAnImpulse() throws Exception {
    // momentum of the bob about the hinge's axis y: its spin relative to the world is kept
    String driven = "driven='0; 0.5*abs(t-0.5); 0' rotation='xyz'";
    String level = BOB.replace("x='0.2' y='0.1' z='-0.4'", "x='0' y='0' z='0'");
    Trajectory rows =
        of(top(DYNAMIC, "S", driven, level, HINGE)
                .replace(
                    "<point name='p' x='0' y='0' z='1'/>", "<point name='p' x='0' y='0' z='0'/>"))
            .simulate();
    double[] v = rows.column("h.v");
    assertThat(v[v.length - 1] - v[0]).isCloseTo(-1, within(1e-8));
  }

  @Test
  void mistakesAreNamed() {
    assertSaid("S", "driven='t;0;0' rotation='xxy'", "write the axes of the three turns");
    assertSaid("S", "driven='t;0;0'", "holds 3 values; 4 are needed");
    assertSaid("F", "driven='t;0;0;1;2' rotation='xyz'", "holds 5 values; 6 are needed");
    assertSaid("S", "driven='0;0;0;0'", "no finite value at the start");
    assertSaid("S", "driven='step(t-1);0;0' rotation='xyz'", "jumps at t = 1 s");
  }

  private static void assertSaid(String type, String driven, String words) {
    assertThatThrownBy(() -> of(top(DYNAMIC, type, driven, "", "")))
        .isInstanceOf(MechmlException.class)
        .hasMessageContaining(words);
  }
}
