package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunControl;

/** Runs of models with states of their own, against closed solutions. */
class FurtherStatesRunTest {
  private static String model(String parts) {
    return SlidingCart.model("0.25", "", parts);
  }

  private static String slide(String states, String force, String outputs) {
    return model(SlidingCart.parts(states, force, outputs));
  }

  private static MechModel of(String text) throws MechmlException {
    return MechModel.of("m.xml", text);
  }

  private static double last(Trajectory rows, String column) {
    double[] values = rows.column(column);
    return values[values.length - 1];
  }

  @ParameterizedTest
  @CsvSource({
    "DTR, ode113, 1e-8",
    "DTR, DE, 1e-8",
    "DSR, ode15s, 1e-7",
    "DTR, auto, 1e-7",
    "RR, ode15sR, 1e-7",
    "RR-JF, ode15sR, 1e-7"
  })
  void stepResponsesOfFiltersAreTheClosedOnes(
      String formulation, String integrator, double tolerance) throws Exception {
    // first order, and second order with damping 0.3 at 5 rad/s; neither acts on the cart
    String states =
        "<state name='lag' derivative='(1-lag)/0.4'/><state name='x' derivative='w'/><state"
            + " name='w' derivative='25*(1-x) - 3*w'/>";
    Trajectory rows =
        of(slide(states, "0", "")).formulation(formulation).integrator(integrator).simulate();
    double damped = 5 * Math.sqrt(1 - 0.09);
    for (int i = 0; i < rows.rows(); i++) {
      double t = rows.time()[i];
      assertThat(rows.column("lag")[i]).isCloseTo(1 - Math.exp(-t / 0.4), within(tolerance));
      double swing = Math.cos(damped * t) + 1.5 / damped * Math.sin(damped * t);
      assertThat(rows.column("x")[i]).isCloseTo(1 - Math.exp(-1.5 * t) * swing, within(tolerance));
    }
    assertThat(rows.columns().stream().map(Variable::name))
        .containsExactly("t", "j.q", "j.v", "lag", "x", "w");
  }

  @ParameterizedTest
  @CsvSource({
    "DTR, ode113, 1e-8",
    "DSR, DE, 1e-8",
    "DTR, ode15s, 1e-7",
    "RR, ode15sR, 1e-7",
    "RR-JF, ode15sR, 1e-7"
  })
  void controlLoopIsTheMatrixExponential(String formulation, String integrator, double tolerance)
      throws Exception {
    String states =
        "<state name='sum' derivative='1-j.q' unit='m*s'/><state name='lag'"
            + " derivative='(j.v-lag)/0.05' x0='0.2'/>";
    Trajectory rows =
        of(slide(states, "40*(1-j.q) + 60*sum - 8*lag", ""))
            .formulation(formulation)
            .integrator(integrator)
            .simulate();
    // [q v sum lag 1]' = A [q v sum lag 1] with a mass of 2
    double[][] a = {
      {0, 1, 0, 0, 0},
      {-20, 0, 30, -4, 20},
      {-1, 0, 0, 0, 1},
      {0, 20, 0, -20, 0},
      {0, 0, 0, 0, 0}
    };
    double[] y = exponential(a, 2, new double[] {0, 0, 0, 0.2, 1});
    assertThat(last(rows, "j.q")).isCloseTo(y[0], within(tolerance));
    assertThat(last(rows, "j.v")).isCloseTo(y[1], within(tolerance));
    assertThat(last(rows, "sum")).isCloseTo(y[2], within(tolerance));
    assertThat(last(rows, "lag")).isCloseTo(y[3], within(tolerance));
    assertThat(rows.unit("sum")).isEqualTo("m*s");
  }

  /** Returns exp(A t) x by the Taylor series of many short intervals. */
  private static double[] exponential(double[][] a, double t, double[] x) {
    double[] y = x.clone();
    int parts = 200;
    for (int part = 0; part < parts; part++) {
      double[] term = y.clone();
      for (int k = 1; k <= 12; k++) {
        double[] next = new double[y.length];
        for (int i = 0; i < y.length; i++) {
          for (int j = 0; j < y.length; j++) {
            next[i] += a[i][j] * term[j] * t / parts / k;
          }
        }
        term = next;
        for (int i = 0; i < y.length; i++) {
          y[i] += term[i];
        }
      }
    }
    return y;
  }

  private static String fourBar(String formulation, String closure, String states, String force) {
    return model(
            "<Bodies><body name='Ground'><point name='o' x='0' y='0' z='0'/><point name='p' x='2'"
                + " y='0' z='0'/>"
                + SlidingCart.AXES
                + "</body>"
                + SlidingCart.body("crank")
                + SlidingCart.body("coupler")
                + SlidingCart.body("rocker")
                + "</Bodies><Joints>"
                + hinge("j1", "Ground", "o", "crank", "o")
                + hinge("j2", "crank", "p", "coupler", "o")
                + hinge("j3", "Ground", "p", "rocker", "o")
                + hinge("j4", "coupler", "p", "rocker", "p")
                + "</Joints>"
                + states
                + "<Forces><jointForce name='f' joint='j1' expression='"
                + force
                + "'/></Forces><topology><root name='Ground'/><relCoorVals><jointVal name='j1'"
                + " posVals='-1.2' fixed='true'/><jointVal name='j2' posVals='1'/><jointVal"
                + " name='j3' posVals='-1.9'/></relCoorVals></topology>")
        .replace(
            "</dynamic>",
            "<formulation name='" + formulation + "' closure='" + closure + "'/></dynamic>");
  }

  private static String hinge(String name, String on, String at, String body, String point) {
    return "<joint name='%s' type='R'><body1 name='%s' point='%s' vector='y'/><body2 name='%s'"
            .formatted(name, on, at, body)
        + " point='%s' vector='y'/></joint>".formatted(point);
  }

  @ParameterizedTest
  @CsvSource({
    "DSR, projection, ode113",
    "DSR, penalty, ode113",
    "RR, projection, ode15sR",
    "RR, penalty, ode15sR",
    "RR-JF, projection, ode15sR",
    "RR-JF, penalty, ode15sR"
  })
  void loopsMoveAsWithTheSolutionOfTheState(String formulation, String closure, String integrator)
      throws Exception {
    // the state is sin(3t), and the force of it the same as a force of time
    String states =
        "<States><state name='s' derivative='3*c'/><state name='c' x0='1'"
            + " derivative='-3*s'/></States>";
    Trajectory with =
        of(fourBar(formulation, closure, states, "4*s - 0.5*j1.v*c"))
            .integrator(integrator)
            .simulate();
    Trajectory without =
        of(fourBar("DSR", "projection", "", "4*sin(3*t) - 0.5*j1.v*cos(3*t)"))
            .integrator("ode113")
            .simulate();
    double tolerance = integrator.equals("ode113") ? 1e-7 : 2e-6;
    for (String column : List.of("j1.q", "j2.q", "j3.q", "j1.v")) {
      assertThat(with.column(column)).containsExactly(without.column(column), within(tolerance));
    }
    assertThat(last(with, "s")).isCloseTo(Math.sin(6), within(tolerance));
  }

  @Test
  void runsResumeToTheBit() throws Exception {
    String states =
        "<States><state name='a' derivative='j4.q - a'/><state name='b' derivative='a - 2*b +"
            + " j1.v'/></States>";
    for (String[] way :
        new String[][] {
          {"DSR", "projection", "ode113"},
          {"RR-JF", "projection", "ode15sR"},
          {"RR-JF", "penalty", "ode15sR"}
        }) {
      MechModel model = of(fourBar(way[0], way[1], states, "3*a - 2*b*j1.v")).integrator(way[2]);
      KeptRun whole = new KeptRun(Optional.empty());
      model.simulate(whole, new RunControl(), whole);
      int half = whole.checkpoints.size() / 2;
      KeptRun rest = new KeptRun(Optional.of(whole.checkpoints.get(half)));
      model.simulate(rest, new RunControl(), rest);
      assertThat(rest.rows).isNotEmpty();
      assertThat(rest.rows)
          .isEqualTo(whole.rows.subList(whole.rowsAt.get(half), whole.rows.size()));
    }
  }

  @Test
  void forceThatJumpsWithTimeInAStateStopsTheStepThere() throws Exception {
    Trajectory rows = of(slide("<state name='s' derivative='step(t-0.7)'/>", "s", "")).simulate();
    assertThat(last(rows, "s")).isCloseTo(1.3, within(1e-12));
    assertThat(last(rows, "j.v")).isCloseTo(1.3 * 1.3 / 4, within(1e-9));
  }

  @Test
  void outputsAndEventsReadStates() throws Exception {
    String text =
        slide(
                "<state name='s' derivative='2'/>",
                "0",
                "<Outputs><output name='twice' expression='2*s+j.q'/></Outputs>")
            .replace(
                "</dynamic>",
                "<output columns='outputs'/><event name='full' expression='s-1' action='stop'/>"
                    + "</dynamic>");
    Trajectory rows = of(text).simulate();
    assertThat(rows.time()[rows.rows() - 1]).isCloseTo(0.5, within(1e-9));
    assertThat(last(rows, "twice")).isCloseTo(2, within(1e-9));
  }

  @Test
  void modesAreTheEigenvaluesOfTheWholeLoop() throws Exception {
    String states =
        "<state name='sum' derivative='1-j.q'/><state name='lag' derivative='(j.v-lag)/0.05'/>"
            + "<state name='apart' derivative='-7*apart'/>";
    Trajectory modes = of(slide(states, "40*(1-j.q) + 60*sum - 8*lag", "")).modes();
    // by hand: (s + 7) ((s + 20) (s^3 + 20 s + 30) + 80 s^2) = 0
    double found = 0;
    for (int i = 0; i < modes.rows(); i++) {
      double re = modes.column("eigenvalue.re")[i];
      double im = modes.column("eigenvalue.im")[i];
      if (im == 0 && Math.abs(re + 7) < 1e-9) {
        found++;
        assertThat(modes.column("apart.re")[i]).isEqualTo(1);
        continue;
      }
      double[] s2 = product(re, im, re, im);
      double[] s3 = product(s2[0], s2[1], re, im);
      double[] whole = product(re + 20, im, s3[0] + 20 * re + 30, s3[1] + 20 * im);
      assertThat(whole[0] + 80 * s2[0]).isCloseTo(0, within(1e-8 * 1e4));
      assertThat(whole[1] + 80 * s2[1]).isCloseTo(0, within(1e-8 * 1e4));
      // sum' = -q
      double[] rate = product(re, im, modes.column("sum.re")[i], modes.column("sum.im")[i]);
      assertThat(rate[0]).isCloseTo(-modes.column("j.re")[i], within(1e-9));
      found += im == 0 ? 1 : 2;
    }
    assertThat(found).isEqualTo(5);
  }

  private static double[] product(double a, double b, double c, double d) {
    return new double[] {a * c - b * d, a * d + b * c};
  }

  @Test
  void matricesOfSmallMotionsHoldTheStates() throws Exception {
    Trajectory rows =
        of(slide("<state name='s' derivative='3*j.q - 5*j.v - 7*s'/>", "11*s - 13*j.q", ""))
            .linearise();
    assertThat(rows.column("M.j")).containsExactly(2, 0);
    assertThat(rows.column("C.j")[1]).isCloseTo(5, within(1e-9));
    assertThat(rows.column("K.j")[0]).isCloseTo(13, within(1e-9));
    assertThat(rows.column("K.j")[1]).isCloseTo(-3, within(1e-9));
    assertThat(rows.column("S.s")).containsExactly(new double[] {-11, 7}, within(1e-12));
  }

  @Test
  void modesOfLoopsSatisfyTheEquationOfTheState() throws Exception {
    String states = "<States><state name='u' derivative='-3*j1.q - 2*u'/></States>";
    Trajectory modes = of(fourBar("DSR", "projection", states, "5*u - 2*j1.v")).modes();
    assertThat(modes.rows()).isBetween(2, 3);
    for (int i = 0; i < modes.rows(); i++) {
      // (s + 2) u = -3 j1
      double re = modes.column("eigenvalue.re")[i];
      double im = modes.column("eigenvalue.im")[i];
      double[] left = product(re + 2, im, modes.column("u.re")[i], modes.column("u.im")[i]);
      assertThat(left[0]).isCloseTo(-3 * modes.column("j1.re")[i], within(1e-8));
      assertThat(left[1]).isCloseTo(-3 * modes.column("j1.im")[i], within(1e-8));
    }
  }

  @Test
  void analysesThatDoNotIntegrateSaySo() throws Exception {
    MechModel model = of(slide("<state name='s' derivative='1'/>", "0", ""));
    assertThatThrownBy(model::equilibrium).hasMessageContaining("N-063");
    assertThatThrownBy(model::kinematics).hasMessageContaining("does not integrate");
  }

  @Test
  void transferFunctionIsItsClosedStepResponse() throws Exception {
    // (2s + 3)/(s^2 + 3s + 2) = 1/(s + 1) + 1/(s + 2), and one with feedthrough: 2 - 3/(s + 1)
    String states =
        "<transferFunction name='g' input='1' num='2; 3' den='1; 3; 2'/><transferFunction name='h'"
            + " input='1' num='2; -1' den='1; 1'/>";
    String outputs =
        "<Outputs><output name='y' expression='g'/><output name='z' expression='h'/></Outputs>";
    Trajectory rows = of(slide(states, "g", outputs)).columns(ColumnGroup.OUTPUTS).simulate();
    for (int i = 0; i < rows.rows(); i++) {
      double t = rows.time()[i];
      double first = 1 - Math.exp(-t);
      assertThat(rows.column("y")[i]).isCloseTo(first + (1 - Math.exp(-2 * t)) / 2, within(1e-8));
      assertThat(rows.column("z")[i]).isCloseTo(2 - 3 * first, within(1e-8));
    }
    assertThat(rows.columns().stream().map(Variable::name))
        .containsExactly("t", "j.q", "j.v", "g.x1", "g.x2", "h.x1", "y", "z");
  }

  @Test
  void controllerIsTheMatrixExponential() throws Exception {
    String states =
        "<pid name='u' setpoint='1' measured='j.q' kp='40' ki='60' kd='8' filter='0.05'"
            + " derivativeOf='measured'/>";
    Trajectory rows = of(slide(states, "u", "")).simulate();
    // q' = v; 2 v' = 40 (1-q) + I + 8 (-q-x)/0.05; I' = 60 (1-q); x' = (-q-x)/0.05
    double[][] a = {
      {0, 1, 0, 0, 0},
      {-20 - 80, 0, 0.5, -80, 20},
      {-60, 0, 0, 0, 60},
      {-20, 0, 0, -20, 0},
      {0, 0, 0, 0, 0}
    };
    double[] y = exponential(a, 2, new double[] {0, 0, 0, 0, 1});
    assertThat(last(rows, "j.q")).isCloseTo(y[0], within(1e-8));
    assertThat(last(rows, "u.integral")).isCloseTo(y[2], within(1e-7));
    assertThat(last(rows, "u.filter")).isCloseTo(y[3], within(1e-8));
  }

  @Test
  void limitedControllerDoesNotWindUp() throws Exception {
    String states =
        "<pid name='u' setpoint='1' measured='j.q' kp='20' ki='30' kd='9' filter='0.02'"
            + " derivativeOf='measured' lower='-2' upper='2' %s/>";
    Trajectory held = of(slide(states.formatted(""), "u", "")).until(8).simulate();
    Trajectory written =
        of(slide(
                "<state name='i' derivative='30*(1-j.q) + (min(2, max(-2, f)) -"
                        .replace("f)", "20*(1-j.q)+i+9*(-j.q-x)/0.02)")
                    + " (20*(1-j.q)+i+9*(-j.q-x)/0.02))/sqrt(9/30)'/><state name='x'"
                    + " derivative='(-j.q-x)/0.02'/>",
                "min(2, max(-2, 20*(1-j.q)+i+9*(-j.q-x)/0.02))",
                ""))
            .until(8)
            .simulate();
    assertThat(held.column("j.q")).containsExactly(written.column("j.q"), within(1e-7));
    Trajectory wound =
        of(slide(states.formatted("trackingTime='1e9'"), "u", "")).until(8).simulate();
    assertThat(highest(held)).isLessThan(highest(wound));
  }

  private static double highest(Trajectory rows) {
    return Arrays.stream(rows.column("j.q")).max().orElseThrow();
  }

  @Test
  void blocksFollowEachOther() throws Exception {
    // a cascade: the outer controller is the setpoint of the inner one, in any order
    String states =
        "<pid name='inner' setpoint='outer' measured='j.v' kp='20'/><pid name='outer'"
            + " setpoint='1' measured='j.q' kp='3'/>";
    Trajectory rows = of(slide(states, "inner", "")).simulate();
    double[][] a = {{0, 1, 0}, {-30, -10, 30}, {0, 0, 0}};
    assertThat(last(rows, "j.q"))
        .isCloseTo(exponential(a, 2, new double[] {0, 0, 1})[0], within(1e-8));
  }

  @Test
  void blocksThatCannotBeAreNamed() {
    assertSaid(
        slide("<pid name='a' measured='b' kp='1'/><pid name='b' measured='a' kp='1'/>", "a", ""),
        "algebraic loop");
    assertSaid(slide("<pid name='a' measured='j.q' kd='1'/>", "a", ""), "filter is missing");
    assertSaid(slide("<pid name='a' measured='j.q' ki='1' upper='1'/>", "a", ""), "trackingTime");
    assertSaid(
        slide("<transferFunction name='a' input='1' num='1;0;0' den='1;1'/>", "a", ""),
        "must not be above");
    assertSaid(
        slide("<transferFunction name='a' input='1' num='1' den='0;1'/>", "a", ""),
        "first coefficient of den is 0");
    assertSaid(slide("<transferFunction name='a' input='1' num='1' den='2'/>", "a", ""), "a gain");
    assertSaid(
        slide("<transferFunction name='a' input='1' num='1' den='1;2' x0='1;2'/>", "a", ""),
        "2 values for 1 states");
  }

  @Test
  void mistakesAreNamed() {
    assertSaid(slide("<state name='t' derivative='1'/>", "0", ""), "\"t\" has another meaning");
    assertSaid(
        slide("<state name='a' derivative='1'/><state name='a' derivative='2'/>", "0", ""),
        "a state with this name");
    assertSaid(slide("<state name='a' derivative='b'/>", "0", ""), "b");
    assertSaid(slide("<state name='a' derivative='1' atol='-1'/>", "0", ""), "must be positive");
    assertSaid(slide("<state name='a'/>", "0", ""), "derivative");
    assertSaid(
        slide(
            "<state name='a' derivative='1'/>",
            "0",
            "<Outputs><output name='a' expression='1'/></Outputs>"),
        "an output has this name");
    assertSaid(
        slide("<state name='a' derivative='1'/>", "0", "")
            .replace(
                "<root name='Ground'/>",
                "<root name='Ground'/><relCoorVals><jointVal"
                    + " name='j' driven='a'/></relCoorVals>"),
        "a prescribed motion depends on t and parameters only");
  }

  private static void assertSaid(String text, String words) {
    assertThatThrownBy(() -> of(text))
        .isInstanceOf(MechmlException.class)
        .hasMessageContaining(words);
  }
}
