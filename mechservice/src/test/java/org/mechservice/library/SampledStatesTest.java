package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.program.SteppedModel;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunControl;

/**
 * States that are sampled, set by events or set from outside, against the recursions that they are
 * between two samples: a cart of mass 2 under a constant force has
 *
 * <pre>q(t + T) = q + T v + T² u / 4,  v(t + T) = v + T u / 2.</pre>
 */
class SampledStatesTest {
  /** A step of an integrator has an error of a few tolerances of 1e-10; there are thousands. */
  private static final double EXPLICIT = 1e-8;

  private static final double PERIOD = 0.05;

  private static String cart(String tables, String states, String force, String events) {
    return SlidingCart.model("0.05", events, tables + SlidingCart.parts(states, force, ""));
  }

  /** A four-bar whose crank is turned by a sampled torque. */
  private static String fourBar(String states) {
    return "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='0.6' tstep='0.05'/><integrator"
        + " name='ode113' relTol='1e-9' absTol='1e-11'/></dynamic></MBSsimulation><MBSmodel"
        + " name='m' massUnits='kg' lengthUnits='m'><Bodies><body name='Ground'><point name='o'"
        + " x='0' y='0' z='0'/><point name='p' x='2' y='0' z='0'/>"
        + SlidingCart.AXES
        + "</body>"
        + SlidingCart.body("crank")
        + SlidingCart.body("coupler")
        + SlidingCart.body("rocker")
        + "</Bodies><Joints>"
        + joint("j1", "Ground", "o", "crank", "o")
        + joint("j2", "crank", "p", "coupler", "o")
        + joint("j3", "Ground", "p", "rocker", "o")
        + joint("j4", "coupler", "p", "rocker", "p")
        + "</Joints><States>"
        + states
        + "</States><Forces><jointForce name='f' joint='j1' expression='u'/></Forces><topology>"
        + "<root name='Ground'/><relCoorVals><jointVal name='j1' posVals='-1.2' velVals='0.7'"
        + " fixed='true'/><jointVal name='j2' posVals='1'/><jointVal name='j3' posVals='-1.9'/>"
        + "</relCoorVals></topology></MBSmodel></MechML>";
  }

  private static String joint(String name, String on, String at, String body, String point) {
    return "<joint name='%s' type='R'><body1 name='%s' point='%s' vector='y'/><body2 name='%s' point='%s' vector='y'/></joint>"
        .formatted(name, on, at, body, point);
  }

  private static MechModel of(String text) throws MechmlException {
    return MechModel.of("m.xml", text);
  }

  @ParameterizedTest
  @CsvSource({
    "DTR, ode113, 1e-8",
    "DTR, DE, 1e-8",
    "DSR, ode15s, 1e-7",
    "DTR, switching, 1e-8",
    "RR, ode15sR, 1e-7",
    "RR-JF, ode15sR, 1e-7"
  })
  void sampledFeedbackIsTheRecursionOfItsSamples(
      String formulation, String integrator, double tolerance) throws Exception {
    String states =
        "<sampled name='u' period='0.05' value='30*(1-j.q) - 8*j.v + 5*n' unit='N'/><sampled"
            + " name='n' period='0.05' value='n + 0.05*(1-j.q)' x0='0.1'/>";
    Trajectory rows =
        of(cart("", states, "u", "")).formulation(formulation).integrator(integrator).simulate();
    double q = 0;
    double v = 0;
    double n = 0.1;
    for (int i = 0; i < rows.rows(); i++) {
      assertThat(rows.column("j.q")[i]).isCloseTo(q, within(tolerance));
      assertThat(rows.column("j.v")[i]).isCloseTo(v, within(tolerance));
      double u = 30 * (1 - q) - 8 * v + 5 * n;
      n += PERIOD * (1 - q);
      q += PERIOD * v + PERIOD * PERIOD * u / 4;
      v += PERIOD * u / 2;
    }
    assertThat(rows.rows()).isEqualTo(41);
    assertThat(rows.unit("u")).isEqualTo("N");
    assertThat(rows.report().notes()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({"error, 0.02", "measured, 0.02", "error, 0"})
  void sampledControllerIsThePublishedRecursion(String derivativeOf, double filter)
      throws Exception {
    double kp = 30;
    double ki = 20;
    double kd = 8;
    double tracking = Math.sqrt(kd / ki);
    String states =
        "<pid name='u' setpoint='1' measured='j.q' kp='30' ki='20' kd='8' filter='"
            + filter
            + "' derivativeOf='"
            + derivativeOf
            + "' lower='-6' upper='6' period='0.1' offset='0.05' unit='N'/>";
    Trajectory rows = of(cart("", states, "u", "")).simulate();
    double q = 0;
    double v = 0;
    double u = 0;
    double integral = 0;
    double derivative = 0;
    double previous = 0;
    int limited = 0;
    for (int i = 0; i < rows.rows(); i++) {
      assertThat(rows.column("j.q")[i]).isCloseTo(q, within(EXPLICIT));
      assertThat(rows.column("u.integral")[i]).isCloseTo(integral, within(EXPLICIT));
      assertThat(rows.column("u")[i]).isCloseTo(u, within(1e-6));
      if (i % 2 == 1) {
        double error = 1 - q;
        double watched = derivativeOf.equals("error") ? error : -q;
        derivative = (filter * derivative + kd * (watched - previous)) / (filter + 0.1);
        previous = watched;
        double free = kp * error + integral + derivative;
        u = Math.max(-6, Math.min(6, free));
        limited += u == free ? 0 : 1;
        integral += 0.1 * (ki * error + (u - free) / tracking);
      }
      q += PERIOD * v + PERIOD * PERIOD * u / 4;
      v += PERIOD * u / 2;
    }
    assertThat(limited).isBetween(2, 19);
  }

  @ParameterizedTest
  @CsvSource({
    "DSR, ode113",
    "RR, ode15sR",
    "RR-JF, ode15sR",
  })
  void sampledTorqueTurnsAFourBarAsAnExpressionOfTimeDoes(String formulation, String integrator)
      throws Exception {
    // floor(10 t) has its jumps at the samples
    Trajectory sampled =
        of(fourBar("<sampled name='u' period='0.1' value='3*sin(2*t)'/>"))
            .formulation(formulation)
            .integrator(integrator)
            .simulate();
    Trajectory jumping =
        of(fourBar("<state name='u' derivative='0'/>")
                .replace("expression='u'", "expression='3*sin(0.2*floor(10*t))'"))
            .formulation(formulation)
            .integrator(integrator)
            .simulate();
    assertThat(sampled.rows()).isGreaterThan(1);
    for (String column : List.of("j1.q", "j1.v", "j3.v")) {
      for (int i = 0; i < sampled.rows(); i++) {
        assertThat(sampled.column(column)[i]).isCloseTo(jumping.column(column)[i], within(2e-7));
      }
    }
  }

  @Test
  void eventsSetStates() throws Exception {
    // a relay: full force until half way, then the brake
    String events =
        "<event name='half' expression='j.q-0.25' direction='rising' action='set'><set name='u'"
            + " value='-u'/></event><event name='rest' expression='j.v' direction='falling'"
            + " action='stop'/>";
    Trajectory rows =
        of(cart("", "<state name='u' derivative='0' x0='2'/>", "u", events)).simulate();
    int last = rows.rows() - 1;
    // a = 1: half way at sqrt(0.5) s, at rest at twice this time
    assertThat(rows.time()[last]).isCloseTo(Math.sqrt(2), within(EXPLICIT));
    assertThat(rows.column("j.q")[last]).isCloseTo(0.5, within(EXPLICIT));
    assertThat(rows.column("u")[last]).isEqualTo(-2);
  }

  @ParameterizedTest
  @CsvSource({"DTR, ode113", "DSR, DE", "DTR, ode15s", "RR, ode15sR", "RR-JF, ode15sR"})
  void resumedRunsHaveTheSameBits(String formulation, String integrator) throws Exception {
    String states =
        "<pid name='u' setpoint='1' measured='j.q' kp='30' ki='20' kd='8' lower='-6' upper='6'"
            + " period='0.07'/><state name='lag' derivative='(u-lag)/0.1'/>";
    MechModel model =
        of(cart("", states, "lag", "")).formulation(formulation).integrator(integrator);
    KeptRun whole = new KeptRun(Optional.empty());
    model.simulate(whole, new RunControl(), whole);
    byte[] saved = whole.checkpoints.get(whole.checkpoints.size() / 2);
    int rowsBefore = whole.rowsAt.get(whole.checkpoints.size() / 2);
    KeptRun rest = new KeptRun(Optional.of(saved));
    model.simulate(rest, new RunControl(), rest);
    assertThat(rest.rows).isEqualTo(whole.rows.subList(rowsBefore, whole.rows.size()));
  }

  @Test
  void inputsAreHeldAtTheirStartOrFollowTheirTable() throws Exception {
    Trajectory held = of(cart("", "<input name='u' x0='3' unit='N'/>", "u", "")).simulate();
    assertThat(held.column("j.q")[40]).isCloseTo(3, within(EXPLICIT));
    assertThat(held.unit("u")).isEqualTo("N");
    String table = "<Tables><table name='ramp' x='0;1;2' y='0;2;0'/></Tables>";
    MechModel ramp = of(cart(table, "<input name='u' table='ramp'/>", "u", ""));
    Trajectory followed = ramp.simulate();
    // a = t, then 2 - t: v(2) = 1, q(2) = 1/6 + 1/2 + 1/3
    assertThat(followed.column("j.v")[40]).isCloseTo(1, within(EXPLICIT));
    assertThat(followed.column("j.q")[40]).isCloseTo(1, within(EXPLICIT));
    assertThat(ramp.stepped(0.1).inputs()).extracting(Variable::name).containsExactly("u");
  }

  @Test
  void analysesWithoutIntegrationHoldInputsAtTheirStart() throws Exception {
    MechModel cart =
        of(
            cart("", "<input name='u' x0='3'/>", "u", "")
                .replace(
                    "<root name='Ground'/>",
                    "<root name='Ground'/><relCoorVals><jointVal name='j'"
                        + " driven='t*t'/></relCoorVals>"));
    Trajectory forces = cart.inverseDynamics();
    // the drive gives what the input lacks: 2 kg times 2 m/s², less 3 N
    assertThat(forces.column("u")).containsOnly(3.0);
    assertThat(forces.column("j.drive")[1]).isCloseTo(1, within(EXPLICIT));
    assertThat(cart.kinematics().column("u")).containsOnly(3.0);
  }

  @ParameterizedTest
  @CsvSource({
    "DTR, ode113, 1e-8",
    "DTR, DE, 1e-8",
    "DSR, ode15s, 1e-7",
    "DTR, switching, 1e-8",
    "RR, ode15sR, 1e-7",
    "RR-JF, ode15sR, 1e-7"
  })
  void controllerOutsideIsTheSampledOne(String formulation, String integrator, double tolerance)
      throws Exception {
    SteppedModel run =
        of(cart("", "<input name='u' unit='N'/>", "u", ""))
            .formulation(formulation)
            .integrator(integrator)
            .stepped(PERIOD);
    double q = 0;
    double v = 0;
    int steps = 0;
    while (run.isRunning()) {
      double u = 30 * (1 - run.value("j.q")) - 8 * run.value("j.v");
      run.input("u", u);
      run.step();
      u = 30 * (1 - q) - 8 * v;
      q += PERIOD * v + PERIOD * PERIOD * u / 4;
      v += PERIOD * u / 2;
      assertThat(run.value("j.q")).isCloseTo(q, within(tolerance));
      assertThat(run.value("j.v")).isCloseTo(v, within(tolerance));
      steps++;
      assertThat(run.time()).isEqualTo(run.value("t"));
    }
    assertThat(steps).isEqualTo(40);
    assertThat(run.report().rows()).isEqualTo(41);
  }

  @ParameterizedTest
  @CsvSource({"DTR, ode113", "DSR, DE", "DTR, ode15s", "RR, ode15sR", "RR-JF, ode15sR"})
  void savedSteppedRunsGoOnWithTheSameBits(String formulation, String integrator) throws Exception {
    String states =
        "<input name='u'/><sampled name='s' period='0.1' value='u + 0.5*s'/><state name='lag'"
            + " derivative='(s-lag)/0.1'/>";
    MechModel model =
        of(cart("", states, "lag", "")).formulation(formulation).integrator(integrator);
    SteppedModel run = model.stepped(PERIOD);
    byte[] saved = {};
    for (int i = 0; i < 30; i++) {
      run.input("u", Math.sin(i));
      if (i == 15) {
        saved = run.save();
      }
      run.step();
    }
    SteppedModel again = model.stepped(PERIOD, saved);
    for (int i = 15; i < 30; i++) {
      again.input("u", Math.sin(i));
      again.step();
    }
    assertThat(again.row()).isEqualTo(run.row());
    assertThat(again.state()).isEqualTo(run.state());
    assertThatThrownBy(() -> of(cart("", states, "s", "")).stepped(PERIOD, run.save()))
        .hasMessageContaining("S-071");
  }

  @ParameterizedTest
  @CsvSource({"DSR, ode113, 1e-8", "RR, ode15sR, 1e-7", "RR-JF, ode15sR, 1e-7"})
  void steppedLoopsAreThoseOfTheSampledTorque(
      String formulation, String integrator, double tolerance) throws Exception {
    Trajectory sampled =
        of(fourBar("<sampled name='u' period='0.05' value='3*sin(2*t)'/>"))
            .formulation(formulation)
            .integrator(integrator)
            .simulate();
    SteppedModel run =
        of(fourBar("<input name='u'/>"))
            .formulation(formulation)
            .integrator(integrator)
            .stepped(PERIOD);
    for (int i = 0; run.isRunning(); i++) {
      run.input("u", 3 * Math.sin(2 * run.time()));
      run.step();
      assertThat(run.value("j3.v")).isCloseTo(sampled.column("j3.v")[i + 1], within(tolerance));
    }
    assertThat(run.time()).isCloseTo(sampled.time()[sampled.rows() - 1], within(1e-12));
  }

  @Test
  void stateGivenFromOutsideIsTheOneTheRunGoesOnFrom() throws Exception {
    SteppedModel run = of(cart("", "<input name='u' x0='2'/>", "u", "")).stepped(1);
    run.state(new double[] {5, -1, 2});
    run.step();
    assertThat(run.value("j.q")).isCloseTo(4.5, within(EXPLICIT));
    assertThat(run.value("j.v")).isCloseTo(0, within(EXPLICIT));
    run.state(new double[] {0, 0, -2});
    run.step();
    assertThat(run.value("j.q")).isCloseTo(-0.5, within(EXPLICIT));
    assertThatThrownBy(run::step).isInstanceOf(IllegalStateException.class);
  }

  @Test
  void wrongUseIsRefusedByName() throws Exception {
    SteppedModel run = of(cart("", "<input name='u'/>", "u", "")).stepped(0.1);
    assertThatThrownBy(() -> run.input("w", 1))
        .hasMessage("S-195 there is no input \"w\"; there are u");
    assertThatThrownBy(() -> run.input("u", Double.NaN))
        .hasMessage("S-195 input \"u\" is set to NaN; it must be finite");
    assertThatThrownBy(() -> run.value("j.x"))
        .hasMessage("S-195 there is no column \"j.x\"; there are t, j.q, j.v, u");
    assertThatThrownBy(() -> run.state(new double[2]))
        .hasMessage("S-195 a state has 3 numbers, not 2");
    assertThatThrownBy(
            () -> of(cart("", "<sampled name='u' period='1e-9' value='t'/>", "u", "")).simulate())
        .hasMessageStartingWith("S-196 the run would take more than 10000000 samples");
  }
}
