package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.program.Trajectory;

/**
 * Scenes in which something happens between two points of a step: hits, forces over a short way,
 * pulses in time, bumps of a road, events. Values that are not derived here come from SciPy's
 * DOP853 or LSODA with steps far shorter than what happens.
 */
final class NothingUnseenTest {
  private static final String GROUND = body("G", "", "");

  private static String body(String name, String points, String mass) {
    return "<body name='"
        + name
        + "'><point name='o' x='0' y='0' z='0'/>"
        + points
        + "<vector name='x' vx='1' vy='0' vz='0'/><vector name='y' vx='0' vy='1' vz='0'/>"
        + "<vector name='z' vx='0' vy='0' vz='1'/>"
        + mass
        + "</body>";
  }

  private static String point(String name, double x, double z) {
    return "<point name='%s' x='%s' y='0' z='%s'/>".formatted(name, x, z);
  }

  private static String mass(double m) {
    return "<mass value='%s'/>".formatted(m);
  }

  private static String mass(double m, double inertia) {
    return "<mass value='%s'/><inertiaTensor Ixx='%s' Iyy='%s' Izz='%s'/>"
        .formatted(m, inertia, inertia, inertia);
  }

  private static String joint(
      String name, String type, String body1, String point, String axis, String body2) {
    return joint(name, type, body1, point, axis, body2, "");
  }

  private static String joint(
      String name,
      String type,
      String body1,
      String point,
      String axis,
      String body2,
      String more) {
    return ("<joint name='%s' type='%s' %s><body1 name='%s' point='%s' vector='%s'/><body2 name='%s'"
            + " point='o' vector='%s'/></joint>")
        .formatted(name, type, more, body1, point, axis, body2, axis);
  }

  private static String model(
      String run, String bodies, String joints, String forces, String starts) {
    return model(run, "", bodies, joints, forces, starts);
  }

  private static String model(
      String run, String before, String bodies, String joints, String forces, String starts) {
    return "<MechML><MBSsimulation name='run'><dynamic>"
        + run
        + "</dynamic></MBSsimulation><MBSmodel name='m' massUnits='kg' lengthUnits='m'"
        + " silence='no-gravity'>"
        + before
        + "<Bodies>"
        + bodies
        + "</Bodies><Joints>"
        + joints
        + "</Joints><Forces>"
        + forces
        + "</Forces><topology><root name='G'/><relCoorVals>"
        + starts
        + "</relCoorVals></topology></MBSmodel></MechML>";
  }

  private static String until(double end) {
    return "<timeSet tini='0' tend='%s' tstep='%s'/>".formatted(end, end / 20);
  }

  private static double last(String model, String column) throws Exception {
    return last(MechModel.of("scene.xml", model), column);
  }

  private static double last(MechModel model, String column) throws Exception {
    Trajectory run = model.simulate();
    double[] values = run.column(column);
    return values[values.length - 1];
  }

  private static String slider(String run, String forces, double velocity) {
    return slider(run, "", forces, velocity);
  }

  private static String slider(String run, String tables, String forces, double velocity) {
    return model(
        run,
        tables,
        GROUND + body("a", "", mass(1)),
        joint("x", "P", "G", "o", "x", "a"),
        forces,
        "<jointVal name='x' velVals='" + velocity + "'/>");
  }

  private static String force(String formula) {
    return "<jointForce name='f' joint='x' expression='" + formula + "'/>";
  }

  private static String drop(double end, double damping) {
    return model(
        until(end),
        GROUND + body("a", "", mass(1)),
        joint("x", "P", "G", "o", "z", "a"),
        "<gravity gx='0' gy='0' gz='-9.81'/><sphereContact name='c' box1='1;1;0.02' radius2='0.02'"
            + " stiffness='1e7' damping='"
            + damping
            + "'><body1 name='G' point='o' vector='z'/><body2 name='a' point='o'/>"
            + "</sphereContact>",
        "<jointVal name='x' posVals='0.5'/>");
  }

  /**
   * A ball falls by 0.47 m on a plate and leaves it as fast as it came, with 3.037 m/s after some 1
   * ms of contact: half the time of the fall later it rises with 1.528 m/s (1.518 if rigid).
   */
  @ParameterizedTest
  @CsvSource({
    "ode113, 1e-4",
    "ode113, 1e-6",
    "ode113, 1e-9",
    "ode113, 1e-12",
    "DE, 1e-5",
    "DE, 1e-8",
    "ode15s, 1e-4",
    "ode15s, 1e-8"
  })
  void ballDroppedOnAPlateBounces(String integrator, double tolerance) throws Exception {
    MechModel model =
        MechModel.of("drop.xml", drop(0.46432351897704827, 0))
            .integrator(integrator)
            .tolerances(tolerance, tolerance / 100);
    assertThat(last(model, "x.v")).isCloseTo(1.528, within(Math.max(1e-3, 100 * tolerance)));
  }

  @Test
  void bobOfAPendulumHitsABall() throws Exception {
    String pendulum = "<cog x='0' y='0' z='-1'/>" + mass(0.5, 1e-4);
    String scene =
        model(
            "<timeSet tini='0' tend='3' tstep='0.05'/><integrator name='auto' relTol='1e-6'"
                + " absTol='1e-8'/>",
            body("G", point("r", 0.03, -1), "")
                + body("p", point("b", 0, -1), pendulum)
                + body("b", "", mass(0.2, 1e-5)),
            joint("a", "R", "G", "o", "y", "p") + joint("x", "P", "G", "r", "x", "b"),
            "<gravity gx='0' gy='0' gz='-9.81'/><sphereContact name='c' radius1='0.02'"
                + " radius2='0.02' stiffness='1e6' exponent='1.5' damping='20'><body1 name='p'"
                + " point='b' vector='z'/><body2 name='b' point='o'/></sphereContact>",
            "<jointVal name='a' posVals='1.5'/>");
    // Runge-Kutta's method by itself, steps of 2 us near the touch; a damper that pulls: 12.536
    assertThat(last(scene, "x.q")).isCloseTo(12.76298, within(2e-3));
  }

  @Test
  void ballsExchangeTheirVelocities() throws Exception {
    String scene =
        model(
            until(3),
            GROUND + body("a", "", mass(0.1)) + body("b", "", mass(0.1)),
            joint("x", "P", "G", "o", "x", "a") + joint("y", "P", "G", "o", "x", "b"),
            "<sphereContact name='c' radius1='0.02' radius2='0.02' stiffness='1e6'"
                + " exponent='1.5'><body1 name='a' point='o' vector='z'/><body2 name='b'"
                + " point='o'/></sphereContact>",
            "<jointVal name='x' posVals='-10' velVals='10'/>");
    assertThat(last(scene, "x.v")).isCloseTo(0, within(1e-4));
    assertThat(last(scene, "y.v")).isCloseTo(10, within(1e-4));
  }

  @Test
  void bufferBetweenTwoBodiesIsMet() throws Exception {
    String scene =
        model(
            until(10),
            GROUND + body("a", "", mass(1)) + body("b", "", mass(1)),
            joint("x", "P", "G", "o", "x", "a") + joint("y", "P", "G", "o", "x", "b"),
            "<springDamper name='k' k='1e5' length0='0.05' side='compression'><body1 name='a'"
                + " point='o'/><body2 name='b' point='o'/></springDamper>",
            "<jointVal name='x' velVals='10'/><jointVal name='y' posVals='50'/>");
    assertThat(last(scene, "x.v")).isCloseTo(0, within(1e-3));
    assertThat(last(scene, "y.v")).isCloseTo(10, within(1e-3));
  }

  /** Whips of a fast rotor against a slow mass: 160 turns a second. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-5, 1e-6, 1e-8})
  void everyWhipOfARotorIsFelt(double tolerance) throws Exception {
    String scene =
        model(
            until(2),
            GROUND + body("r", point("e", 0.05, 0), mass(1, 0.1)) + body("a", "", mass(5)),
            joint("h", "R", "G", "o", "z", "r")
                + joint("x", "P", "G", "o", "x", "a", "stiffness='100'"),
            "<springDamper name='s' k='200' length0='0.1' side='tension'><body1 name='r'"
                + " point='e'/><body2 name='a' point='o'/></springDamper>",
            "<jointVal name='h' velVals='1000'/><jointVal name='x' posVals='0.12'/>");
    MechModel model = MechModel.of("whips.xml", scene).tolerances(tolerance, tolerance / 100);
    // an error of the tolerance at each of 300 corners: 3.5 times its root; the digits given
    assertThat(last(model, "x.q")).isCloseTo(-0.05701, within(5e-6 + 60 * tolerance));
  }

  @Test
  void everyToothMeetsThePawl() throws Exception {
    String scene =
        model(
            until(10),
            body("G", point("p", 0.32, 0), "")
                + body("r", point("t", 0.3, 0), mass(1, 0.05))
                + body("w", "", mass(0.2)),
            joint("h", "R", "G", "o", "z", "r")
                + joint("s", "P", "G", "p", "x", "w", "stiffness='50' damping='2'"),
            "<sphereContact name='c' radius1='0.01' radius2='0.015' stiffness='1e5'"
                + " damping='50'><body1 name='r' point='t'/><body2 name='w' point='o'/>"
                + "</sphereContact>",
            "<jointVal name='h' velVals='6' posVals='1'/>");
    // Runge-Kutta's method by itself, steps of 4 us near the touch; a damper that pulls: 1.97737
    assertThat(last(scene, "h.v")).isCloseTo(1.92213, within(1e-4));
  }

  /** Ten times the energy of 1 kg at 10 m/s to the relative tolerance 1e-9, J. */
  private static final double TEN_TOLERANCES = 1e-6;

  /** Returns the energy that a force has added to 1 kg at 10 m/s, J. */
  private static double energyAdded(String scene) throws Exception {
    double v = last(MechModel.of("scene.xml", scene).tolerances(1e-9, 1e-11), "x.v");
    return 0.5 * (v * v - 100);
  }

  /** v²/2 = v0²/2 + ∫ F dx; the table's integral is 100 (0.04 + 0.01) N·m. */
  @Test
  void forceOfATableOverAShortWayActs() throws Exception {
    String table =
        "<Tables><table name='tb' x='0;50;50.01;50.05;50.06;200' y='0;0;100;100;0;0'"
            + " extrapolation='hold' method='linear'/></Tables>";
    String scene = slider(until(10), table, force("tb(x.q)"), 10);
    assertThat(energyAdded(scene)).isCloseTo(5, within(TEN_TOLERANCES));
  }

  @Test
  void forceOverAShortWayWithSoftEndsActs() throws Exception {
    String formula = "100*(smoothStep((x.q-50)/0.01)-smoothStep((x.q-50.05)/0.01))";
    // both ramps are 0.01 m long, 0.05 m apart
    assertThat(energyAdded(slider(until(10), force(formula), 10)))
        .isCloseTo(5, within(TEN_TOLERANCES));
  }

  /** A bump without a corner: ∫ 100 exp(−((x − 50)/w)²) dx = 100 w √π. */
  @ParameterizedTest
  @ValueSource(doubles = {1, 0.05, 1e-3, 1e-5})
  void bumpOfAnyWidthActs(double width) throws Exception {
    String formula = "100*exp(-((x.q-50)/" + width + ")^2)";
    double work = 100 * width * Math.sqrt(Math.PI);
    assertThat(energyAdded(slider(until(10), force(formula), 10)))
        .isCloseTo(work, within(TEN_TOLERANCES));
  }

  @Test
  void stateThatChangesOverAShortWayChanges() throws Exception {
    String states =
        "<States><state name='n' derivative='100*step(x.q-50)*step(50.1-x.q)'/></States>";
    String scene = slider(until(10), "", 10).replace("<Forces>", states + "<Forces>");
    assertThat(last(scene, "n")).isCloseTo(1, within(1e-6));
  }

  /** Once a turn, over 2 acos(0.9998) rad. */
  @ParameterizedTest
  @ValueSource(doubles = {1, 10, 1000})
  void pushOnceATurnIsFeltEachTime(double speed) throws Exception {
    double end = 20 * Math.PI / speed;
    String scene =
        model(
            until(end),
            GROUND + body("r", "", mass(1, 1)) + body("a", "", mass(1)),
            joint("h", "R", "G", "o", "z", "r") + joint("x", "P", "G", "o", "x", "a"),
            force("100*step(cos(h.q)-0.9998)"),
            "<jointVal name='h' velVals='" + speed + "' posVals='1'/>");
    double impulse = 10 * 100 * 2 * Math.acos(0.9998) / speed;
    assertThat(last(scene, "x.v")).isCloseTo(impulse, within(1e-4 * impulse));
  }

  /** Pulses of time of different forms; the impulse is their integral. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "100*(min(1,max(0,1000*(t-7)))*min(1,max(0,1000*(7.02-t)))) | 1.9",
        "100*(smoothStep((t-7)/0.01)-smoothStep((t-7.1)/0.01)) | 10",
        "100*exp(-((t-7.1031)/0.003)^2) | 0.531736155",
        "100*step(sin(t)-0.9999) | 5.656901",
        "100*step(0.0001-(t-7.123456)^2) | 2",
        "100*step(1e-12-(t-7.123456)^2) | 2e-4",
        "100/(1+((t-5)/0.001)^2) | 0.31409263",
        "100*(tanh((t-7)/0.001)-tanh((t-7.01)/0.001)) | 2"
      })
  void pulseInTimeActs(String formula, double impulse) throws Exception {
    double v = last(slider(until(10), force(formula), 0), "x.v");
    assertThat(v).isCloseTo(impulse, within(2e-4 * impulse));
  }

  /** The same in the rate of a state, in gravity and in the argument of a table. */
  @Test
  void pulsesOfTimeActWhereverFormulasStand() throws Exception {
    String pulse = "100*(smoothStep((t-7)/0.01)-smoothStep((t-7.02)/0.01))";
    String states = "<States><state name='y' derivative='" + pulse + "'/></States>";
    String scene = slider(until(10), force("y"), 0).replace("<Forces>", states + "<Forces>");
    assertThat(last(scene, "y")).isCloseTo(2, within(1e-6));
    String gravity = "<gravity gx='" + pulse + "' gy='0' gz='0'/>";
    assertThat(last(slider(until(10), gravity, 0), "x.v")).isCloseTo(2, within(1e-6));
    String table =
        "<Tables><table name='tb' x='0;7;7.01;7.05;7.06;20' y='0;0;1;1;0;0'"
            + " extrapolation='hold'/></Tables>";
    double v = last(slider(until(10), table, force("100*tb(t*t/7)"), 0), "x.v");
    // ∫ tb(t²/7) dt with dt = √7 ds / (2 √s): Simpson's rule on each of the three straight parts
    assertThat(v).isCloseTo(2.4947, within(1e-4));
  }

  /** A driven base shakes a passenger for a hundredth of a second, wherever the drive stands. */
  @ParameterizedTest
  @ValueSource(strings = {"0.1*smoothStep((t*t-49)/0.1)", "0.1*smoothStep((t-7)/0.00713)"})
  void shortMoveOfADriveIsFelt(String drive) throws Exception {
    String scene =
        model(
            until(10),
            GROUND + body("b", "", mass(1)) + body("a", "", mass(1)),
            joint("x", "P", "G", "o", "x", "b")
                + joint("y", "P", "b", "o", "x", "a", "stiffness='100' damping='1'"),
            "",
            "<jointVal name='x' driven='" + drive + "'/>");
    double[] away = MechModel.of("drive.xml", scene).simulate().column("y.q");
    double most = 0;
    for (double y : away) {
      most = Math.max(most, Math.abs(y));
    }
    assertThat(most).as("of 0.1 m").isGreaterThan(0.02);
  }

  /**
   * The body of a quarter of a car behind a bump, by Runge-Kutta's method by itself with steps of
   * 50 us, from the least distance of the road: of a wheel that fits into its hollows, and of one
   * that touches both sides of them, pushed by each local minimum of the distance. Steps of 100 us
   * change these by 1e-4 and 0.01 mm. How far a side pushes a wheel that is pressed deeper than the
   * hollow is not the same in both.
   */
  @ParameterizedTest
  @CsvSource({"50;50.5;51.5;52, -22.006, 0.02", "50;50.1;50.3;50.4, 15.48, 0.1"})
  void bumpOfARoadIsFeltAtSpeed(String stations, double millimetres, double close)
      throws Exception {
    String scene =
        model(
            "<timeSet tini='0' tend='1.7333333333333334' tstep='0.06666666666666667'/>"
                + "<integrator name='auto' relTol='1e-6' absTol='1e-8'/>",
            GROUND + body("car", "", "") + body("w", "", mass(20, 1)) + body("b", "", mass(250, 1)),
            joint("x", "P", "G", "o", "x", "car")
                + joint("w", "P", "car", "o", "z", "w")
                + joint(
                    "z",
                    "P",
                    "w",
                    "o",
                    "z",
                    "b",
                    "stiffness='15000' damping='1200' freePosition='0.3635'"),
            "<gravity gx='0' gy='0' gz='-9.81'/><contact name='c' radius='0.3' stiffness='200000'"
                + " damping='500' smoothing='1e-4'><body1 name='G' point='o' vector='z'"
                + " vector2='x'/><body2 name='w' point='o'/><profile stations='"
                + stations
                + "' heights='0;0.05;0.05;0'/></contact>",
            "<jointVal name='x' driven='30*t'/><jointVal name='w' posVals='0.2867565'/><jointVal"
                + " name='z' posVals='0.2'/>");
    assertThat(1000 * (last(scene, "z.q") - 0.2)).isCloseTo(millimetres, within(close));
  }

  /** An encoder: 100 marks of 0.4 % of a turn. */
  @Test
  void noMarkOfAnEncoderIsSkipped() throws Exception {
    String event =
        "<event name='a' expression='sin(2*PI*x.q)-0.999' direction='rising' action='set'>"
            + "<set name='n' value='n+1'/></event>";
    String states = "<States><state name='n' derivative='0'/></States>";
    String scene =
        slider("<timeSet tini='0' tend='100' tstep='10'/>" + event, "", 1)
            .replace("<Forces>", states + "<Forces>");
    assertThat(last(scene, "n")).isEqualTo(100);
  }

  /** Square wave of a force on an oscillator, its jumps known: completes at any tolerance. */
  @ParameterizedTest
  @ValueSource(strings = {"ode113", "DE", "ode15s"})
  void squareWaveCompletes(String integrator) throws Exception {
    List<Double> tolerances = List.of(1e-3, 1e-6, 1e-9, 1e-11, 1e-12);
    for (double tolerance : tolerances) {
      String scene =
          slider(
                  "<timeSet tini='0' tend='2' tstep='0.1'/>",
                  force("-100*x.q+signum(sin(10*PI*t))"),
                  0)
              .replace("\n", "");
      MechModel model =
          MechModel.of("square.xml", scene)
              .integrator(integrator)
              .tolerances(tolerance, tolerance / 100);
      double expected = squareWave(2);
      assertThat(last(model, "x.q"))
          .as(String.format(Locale.ROOT, "%s at %.0e", integrator, tolerance))
          .isCloseTo(expected, within(Math.max(1e-11, 30 * tolerance)));
    }
  }

  /**
   * q″ = −100 q ± 1, the sign alternating each tenth of a second, from rest: piecewise harmonic.
   */
  private static double squareWave(double end) {
    double q = 0;
    double v = 0;
    for (int k = 0; k < Math.round(end / 0.1); k++) {
      double rest = k % 2 == 0 ? 0.01 : -0.01;
      double away = q - rest;
      q = rest + away * Math.cos(1) + v / 10 * Math.sin(1);
      v = -10 * away * Math.sin(1) + v * Math.cos(1);
    }
    return q;
  }
}
