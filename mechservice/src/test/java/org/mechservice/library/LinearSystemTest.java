package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.program.RunFailedException;
import org.mechservice.solver.api.program.SteppedModel;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.system.LinearSystem;

/** Linear systems from inputs to outputs, against closed forms and differences. */
class LinearSystemTest {
  private static final String AXES =
      "<vector name='x' vx='1' vy='0' vz='0'/><vector name='y' vx='0' vy='1' vz='0'/><vector"
          + " name='z' vx='0' vy='0' vz='1'/>";

  private static String body(String name, double mass) {
    return "<body name='"
        + name
        + "'><point name='o' x='0' y='0' z='0'/><point name='p' x='1.3' y='0' z='0'/>"
        + AXES
        + "<mass value='"
        + mass
        + "'/><inertiaTensor Ixx='0.1' Iyy='0.2' Izz='0.25'/></body>";
  }

  private static String joint(String name, String type, String on, String at, String body) {
    String axis = type.equals("P") ? " vector='x'" : type.equals("R") ? " vector='y'" : "";
    return "<joint name='%s' type='%s'><body1 name='%s' point='%s'%s/><body2 name='%s' point='o'%s/></joint>"
        .formatted(name, type, on, at, axis, body, axis);
  }

  private static MechModel model(String gives, String parts) throws MechmlException {
    return MechModel.of(
        "m.xml",
        "<MechML><MBSsimulation><linearize "
            + gives
            + "/></MBSsimulation><MBSmodel name='m' massUnits='kg' lengthUnits='m'><Bodies><body"
            + " name='Ground'><point name='o' x='0' y='0' z='0'/><point name='p' x='2' y='0'"
            + " z='0'/>"
            + AXES
            + "</body>"
            + parts
            + "</MBSmodel></MechML>");
  }

  /** Two carts of 2 kg and 1 kg on springs, a force on the first, an actuator with a lag. */
  private static MechModel carts(String gives) throws MechmlException {
    return model(
        gives,
        body("one", 2)
            + body("two", 1)
            + "</Bodies><Joints>"
            + joint("a", "P", "Ground", "o", "one")
            + joint("b", "P", "one", "o", "two")
            + "</Joints><States><input name='u' unit='N'/><input name='w' x0='2'/><state name='lag'"
            + " derivative='(u-lag)/0.1' unit='N'/></States><Forces><jointForce name='f' joint='a'"
            + " expression='lag - 50*a.q - 0.4*a.v'/><jointForce name='g' joint='b'"
            + " expression='-30*b.q - 0.3*b.v + w*w'/></Forces><Outputs><output name='place'"
            + " expression='a.q+b.q' unit='m'/><output name='force' expression='3*u + 2*b.v'"
            + " unit='N'/></Outputs><topology><root name='Ground'/></topology>");
  }

  @Test
  void matricesOfTwoCartsAreTheClosedOnes() throws Exception {
    LinearSystem system = carts("gives='system'").linearSystem();
    assertThat(system.states())
        .containsExactly(
            new Variable("a.q", "m"),
            new Variable("b.q", "m"),
            new Variable("a.v", "m/s"),
            new Variable("b.v", "m/s"),
            new Variable("lag", "N"));
    assertThat(system.inputs()).containsExactly(new Variable("u", "N"), new Variable("w", "1"));
    assertThat(system.outputs())
        .containsExactly(new Variable("place", "m"), new Variable("force", "N"));
    // M = [3 1; 1 1], so that M^-1 = [1 -1; -1 3]/2
    double[][] a = {
      {0, 0, 1, 0, 0},
      {0, 0, 0, 1, 0},
      {-25, 15, -0.2, 0.15, 0.5},
      {25, -45, 0.2, -0.45, -0.5},
      {0, 0, 0, 0, -10}
    };
    // w² has the derivative 4 at w = 2
    double[][] b = {{0, 0}, {0, 0}, {0, -2}, {0, 6}, {10, 0}};
    double[][] c = {{1, 1, 0, 0, 0}, {0, 0, 0, 2, 0}};
    double[][] d = {{0, 0}, {3, 0}};
    for (int i = 0; i < 5; i++) {
      for (int j = 0; j < 5; j++) {
        assertThat(system.a(i, j)).isCloseTo(a[i][j], within(1e-11));
      }
      for (int j = 0; j < 2; j++) {
        assertThat(system.b(i, j)).isCloseTo(b[i][j], within(1e-11));
      }
    }
    for (int i = 0; i < 2; i++) {
      for (int j = 0; j < 5; j++) {
        assertThat(system.c(i, j)).isCloseTo(c[i][j], within(1e-11));
      }
      for (int j = 0; j < 2; j++) {
        assertThat(system.d(i, j)).isCloseTo(d[i][j], within(1e-11));
      }
    }
  }

  @Test
  void responseIsThatOfTheTransferFunction() throws Exception {
    Trajectory rows = carts("gives='response' from='0.1' to='100' points='31'").simulate();
    assertThat(rows.rows()).isEqualTo(31);
    assertThat(rows.unit("place/u.gain")).isEqualTo("m/N");
    for (int k = 0; k < rows.rows(); k++) {
      double omega = 2 * Math.PI * rows.column("frequency")[k];
      // absolute places: 2 x1'' = lag − 50 x1 − 0.4 x1' + 30 (x2−x1) + 0.3 (x2'−x1'), x2'' = −(…)
      double[] coupling = {30, 0.3 * omega};
      double[] one = {50 + 30 - 2 * omega * omega, 0.7 * omega};
      double[] two = {30 - omega * omega, 0.3 * omega};
      double[] determinant = minus(times(one, two), times(coupling, coupling));
      double[] lag = {1, 0.1 * omega};
      double[] place = over(coupling, times(determinant, lag));
      double gain = Math.hypot(place[0], place[1]);
      assertThat(rows.column("place/u.gain")[k]).isCloseTo(gain, within(1e-11 * gain));
      assertThat(rows.column("place/u.dB")[k]).isCloseTo(20 * Math.log10(gain), within(1e-9));
      double turns =
          (Math.toRadians(rows.column("place/u.phase")[k]) - Math.atan2(place[1], place[0]))
              / (2 * Math.PI);
      assertThat(turns).isCloseTo(Math.rint(turns), within(1e-10));
    }
    double[] phase = rows.column("place/u.phase");
    // four integrations behind a lag, and the zero of the dashpot between the carts
    assertThat(phase[30]).isLessThan(-330);
    assertThat(rows.column("decade")[30]).isCloseTo(2, within(1e-12));
  }

  private static double[] times(double[] a, double[] b) {
    return new double[] {a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]};
  }

  private static double[] over(double[] a, double[] b) {
    double square = b[0] * b[0] + b[1] * b[1];
    double[] product = times(a, new double[] {b[0], -b[1]});
    return new double[] {product[0] / square, product[1] / square};
  }

  private static double[] minus(double[] a, double[] b) {
    return new double[] {a[0] - b[0], a[1] - b[1]};
  }

  @Test
  void zerosOfTwoCartsAreThoseOfTheTransferFunction() throws Exception {
    // force on the first cart, its place: zeros are those of the second cart held by its spring
    Trajectory collocated =
        model(
                "gives='zeros'",
                body("one", 2)
                    + body("two", 1)
                    + "</Bodies><Joints>"
                    + joint("a", "P", "Ground", "o", "one")
                    + joint("b", "P", "one", "o", "two")
                    + "</Joints><States><input name='u'/></States><Forces><jointForce name='f'"
                    + " joint='a' expression='u - 50*a.q'/><jointForce name='g' joint='b'"
                    + " expression='-30*b.q - 0.3*b.v'/></Forces><Outputs><output name='y'"
                    + " expression='a.q'/></Outputs><topology><root name='Ground'/></topology>")
            .simulate();
    assertThat(collocated.rows()).isEqualTo(2);
    for (int i = 0; i < 2; i++) {
      assertThat(collocated.column("zero.re")[i]).isCloseTo(-0.15, within(1e-9));
      assertThat(Math.abs(collocated.column("zero.im")[i]))
          .isCloseTo(Math.sqrt(30 - 0.15 * 0.15), within(1e-9));
    }
  }

  @Test
  void zeroOfATransferFunctionIsItsOwn() throws Exception {
    // (s − 3)(s + 7)/(s + 1)^3 between u and y
    Trajectory rows =
        model(
                "gives='zeros'",
                body("one", 2)
                    + "</Bodies><Joints>"
                    + joint("a", "P", "Ground", "o", "one")
                    + "</Joints><States><input name='u'/><transferFunction name='g' input='u'"
                    + " num='1;4;-21' den='1;3;3;1'/></States><Outputs><output name='y'"
                    + " expression='g'/></Outputs><topology><root name='Ground'/></topology>")
            .simulate();
    assertThat(rows.column("zero.re")[0]).isCloseTo(0, within(1e-6));
    double[] re = rows.column("zero.re");
    assertThat(re[re.length - 2]).isCloseTo(3, within(1e-8));
    assertThat(re[re.length - 1]).isCloseTo(-7, within(1e-8));
  }

  private static final String TREE =
      body("arm", 2)
          + body("bob", 1)
          + "</Bodies><Joints>"
          + joint("hinge", "R", "Ground", "o", "arm")
          + joint("ball", "S", "arm", "p", "bob")
          + "</Joints><States><input name='u' x0='0.7'/><input name='w' x0='-0.4'/><state name='s'"
          + " x0='0.3' derivative='sin(hinge.q)*u - s*w + bob.p.vx'/></States><Forces><gravity"
          + " gx='0' gy='0' gz='-9.81'/><jointForce name='m' joint='hinge' expression='u*u -"
          + " s*hinge.v'/><forceTorque name='p' body='bob' point='p' frame='body' fx='w*bob.p.z'"
          + " fz='u*w'/></Forces><Outputs><output name='e' expression='bob.p.x*u +"
          + " bob.p.vz*s'/><output name='h' expression='hinge.v*hinge.q +"
          + " w'/></Outputs><topology><root name='Ground'/><relCoorVals><jointVal name='hinge'"
          + " posVals='0.4' velVals='1'/><jointVal name='ball' posVals='0.8;0.6;0;0'"
          + " velVals='1;2;-1'/></relCoorVals></topology>";

  private static final String LOOP =
      body("crank", 2)
          + body("coupler", 1)
          + body("rocker", 2)
          + "</Bodies><Joints>"
          + joint("j1", "R", "Ground", "o", "crank")
          + joint("j2", "R", "crank", "p", "coupler")
          + joint("j3", "R", "Ground", "p", "rocker")
          + joint("j4", "R", "coupler", "p", "rocker")
              .replace("name='rocker' point='o'", "name='rocker' point='p'")
          + "</Joints><States><input name='u' x0='0.7'/><state name='s' x0='0.3'"
          + " derivative='u*sin(j3.q) - s + coupler.p.vz'/></States><Forces><jointForce name='m'"
          + " joint='j1' expression='u + s*s - 0.1*j3.v'/></Forces><Outputs><output name='e'"
          + " expression='coupler.p.x*u + j3.v*j2.q'/></Outputs><topology><root name='Ground'/>"
          + "<relCoorVals><jointVal name='j1' posVals='-1.2' velVals='0.7' fixed='true'/><jointVal"
          + " name='j2' posVals='1'/><jointVal name='j3' posVals='-1.9'/></relCoorVals></topology>";

  /** B is ∂(state')/∂u of the data-driven or generated equations themselves. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void inputMatrixIsTheDifferenceOfTheEquations(boolean loop) throws Exception {
    String parts = loop ? LOOP : TREE;
    LinearSystem system = model("gives='system'", parts).linearSystem();
    String dynamic =
        "<dynamic><timeSet tini='0' tend='1' tstep='1'/><integrator name='ode113' relTol='1e-8'"
            + " absTol='1e-8'/></dynamic>";
    ModelParts made =
        ModelParts.of(
            MechModel.of("m.xml", text(parts).replace("<linearize gives='system'/>", dynamic))
                .instances()
                .model());
    ExplicitModel equations = (ExplicitModel) made.equations();
    double[] y = new double[equations.description().stateCount()];
    equations.initialState(y);
    int nq = equations.description().positionCount();
    int nv = equations.description().velocityCount();
    int further = equations.description().furtherStates().size();
    assertThat(system.inputs()).hasSize(loop ? 1 : 2);
    for (int j = 0; j < system.inputs().size(); j++) {
      double[] slope = new double[y.length];
      for (int pass = 0; pass < 2; pass++) {
        double h = pass == 0 ? 1e-3 : 5e-4;
        double[] plus = derivative(equations, y, nq + nv + j, h);
        double[] minus = derivative(equations, y, nq + nv + j, -h);
        for (int i = 0; i < y.length; i++) {
          double fine = (plus[i] - minus[i]) / (2 * h);
          slope[i] = pass == 0 ? fine : fine + (fine - slope[i]) / 3;
        }
      }
      for (int i = 0; i < system.states().size(); i++) {
        String name = system.states().get(i).name();
        if (name.endsWith(".v")) {
          int velocity = velocity(equations, name.substring(0, name.length() - 2));
          assertThat(system.b(i, j)).isCloseTo(slope[nq + velocity], within(1e-8));
        } else if (name.equals("s")) {
          assertThat(system.b(i, j)).isCloseTo(slope[nq + nv + further - 1], within(1e-8));
        } else {
          assertThat(system.b(i, j)).isZero();
        }
      }
    }
  }

  private static String text(String parts) {
    return "<MechML><MBSsimulation><linearize gives='system'/></MBSsimulation><MBSmodel name='m'"
        + " massUnits='kg' lengthUnits='m'><Bodies><body name='Ground'><point name='o' x='0' y='0'"
        + " z='0'/><point name='p' x='2' y='0' z='0'/>"
        + AXES
        + "</body>"
        + parts
        + "</MBSmodel></MechML>";
  }

  private static double[] derivative(ExplicitModel model, double[] y, int at, double h) {
    double[] other = y.clone();
    other[at] += h;
    double[] yDot = new double[y.length];
    assertThat(model.derivative(0, other, yDot)).isEqualTo(ExplicitModel.REGULAR);
    return yDot;
  }

  private static int velocity(ExplicitModel model, String name) {
    int at = 0;
    for (var joint : model.description().joints()) {
      int count = joint.type().velocityCount();
      for (int i = 0; i < count; i++) {
        String own = count == 1 ? joint.name() : joint.name() + "[" + i + "]";
        if (own.equals(name)) {
          return at + i;
        }
      }
      at += count;
    }
    throw new AssertionError(name);
  }

  /** D is the difference of outputs that are linear in the inputs. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void feedthroughIsTheDifferenceOfTheOutputs(boolean loop) throws Exception {
    String parts = loop ? LOOP : TREE;
    LinearSystem system = model("gives='system'", parts).linearSystem();
    int m = system.inputs().size();
    assertThat(m).isEqualTo(loop ? 1 : 2);
    assertThat(system.outputs()).hasSize(m);
    MechModel run =
        MechModel.of(
            "m.xml",
            text(parts)
                .replace(
                    "<linearize gives='system'/>",
                    "<dynamic><timeSet tini='0' tend='1' tstep='1'/><integrator name='ode113'"
                        + " relTol='1e-8' absTol='1e-8'/><output columns='outputs'/></dynamic>"));
    for (int j = 0; j < m; j++) {
      for (int i = 0; i < system.outputs().size(); i++) {
        double[] plus = outputAtStart(run, system, j, 1e-3);
        double[] minus = outputAtStart(run, system, j, -1e-3);
        // both outputs are linear in the inputs
        assertThat(system.d(i, j)).isCloseTo((plus[i] - minus[i]) / 2e-3, within(1e-8));
      }
    }
  }

  private static double[] outputAtStart(MechModel run, LinearSystem system, int input, double h)
      throws MechmlException {
    SteppedModel stepped = run.until(2e-9).stepped(1e-9);
    double[] state = stepped.state();
    int further = state.length - (system.inputs().size() + 1);
    state[further + input] += h;
    stepped.state(state);
    stepped.step();
    double[] outputs = new double[system.outputs().size()];
    for (int i = 0; i < outputs.length; i++) {
      outputs[i] = stepped.value(system.outputs().get(i).name());
    }
    return outputs;
  }

  @Test
  void modesLeaveInputsOut() throws Exception {
    Trajectory modes = carts("").simulate();
    assertThat(modes.rows()).isEqualTo(3);
    assertThat(modes.columns().stream().map(Variable::name))
        .contains("lag.re")
        .doesNotContain("u.re", "w.re");
  }

  @Test
  void equilibriumHoldsTheInputs() throws Exception {
    Trajectory system =
        model(
                "at='equilibrium' gives='system'",
                body("one", 2)
                    + "</Bodies><Joints>"
                    + joint("a", "P", "Ground", "o", "one")
                    + "</Joints><States><input name='u' x0='3'/></States><Forces><gravity gx='1'"
                    + " gy='0' gz='0'/><jointForce name='f' joint='a' expression='u -"
                    + " 50*a.q*a.q*a.q'/></Forces><topology><root"
                    + " name='Ground'/><relCoorVals><jointVal name='a' posVals='1'/>"
                    + "</relCoorVals></topology>")
            .simulate();
    // 50 q³ = 3 + 2; the stiffness is 150 q²
    double rest = Math.cbrt(0.1);
    assertThat(system.column("x.a.q")[1]).isCloseTo(-75 * rest * rest, within(1e-7));
    assertThat(system.column("u.u")[1]).isCloseTo(0.5, within(1e-12));
    // without outputs of the author the coordinate is one
    assertThat(system.column("x.a.q")[2]).isEqualTo(1);
  }

  @Test
  void responseWithoutInputsIsRefusedByName() {
    assertThatThrownBy(
            () ->
                model(
                        "gives='zeros'",
                        body("one", 2)
                            + "</Bodies><Joints>"
                            + joint("a", "P", "Ground", "o", "one")
                            + "</Joints><topology><root name='Ground'/></topology>")
                    .simulate())
        .isInstanceOf(RunFailedException.class)
        .hasMessageContaining("The model has no inputs");
  }
}
