package org.mechservice.study.gradient;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.library.MechModel;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.study.Reduction;

/** Derivatives across contacts against central differences of whole runs. */
@Tag("slow")
final class ContactGradientTest {
  /** Of differences of sixth order. */
  private static final double[] WEIGHTS = {3.0 / 4, -3.0 / 20, 1.0 / 60};

  /** Step of the differences, as a part of the value. */
  private static final double STEP = 5e-4;

  /**
   * Of the effect of a parameter's value, m or m/s: sixth order leaves h⁶, and runs at 1e-13 err by
   * some 1e-11 m, which a step of 5e-4 makes 2e-8.
   */
  private static final double NEAR = 1e-6;

  /** Runs at 1e-11, in some hundred steps. */
  private static final double CLOSED = 1e-9;

  private static final String TOLERANCES = "relTol='1e-11' absTol='1e-12'";

  private static String model(String parameters, String joint, String contact, String start) {
    return "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='0.6' tstep='0.3'/>"
        + "<integrator name='ode113' "
        + TOLERANCES
        + "/></dynamic></MBSsimulation>"
        + "<MBSmodel name='drop' massUnits='kg' lengthUnits='m'><Parameters>"
        + parameters
        + "</Parameters><Bodies><body name='G'><point name='o' x='0' y='0' z='0'/><vector name='x'"
        + " vx='1' vy='0' vz='0'/><vector name='z' vx='0' vy='0' vz='1'/></body><body name='a'><point name='o' x='0' y='0' z='0'/><vector"
        + " name='z' vx='0' vy='0' vz='1'/><cog x='0.05' y='0.02' z='0'/><mass value='2'/>"
        + "<inertiaTensor Ixx='0.1' Iyy='0.1' Izz='0.1' Ixy='0' Ixz='0' Iyz='0'/></body></Bodies>"
        + "<Joints>"
        + joint
        + "</Joints><Forces><gravity gx='0' gy='0' gz='-9.81'/>"
        + contact
        + "</Forces><topology><root name='G'/><relCoorVals>"
        + start
        + "</relCoorVals></topology></MBSmodel></MechML>";
  }

  private static String parameter(String name, double value) {
    return "<parameter name='" + name + "' value='" + value + "'/>";
  }

  private static final String SLIDE =
      "<joint name='z' type='P'><body1 name='G' point='o' vector='z'/><body2 name='a' point='o'"
          + " vector='z'/></joint>";

  private static final String FREE =
      "<joint name='f' type='F'><body1 name='G' point='o'/><body2 name='a' point='o'/></joint>";

  /** A ball that falls on a floor and rebounds. */
  private static String ball() {
    return model(
        parameter("k", 1e4) + parameter("c", 2) + parameter("r", 0.1) + parameter("h", 1),
        SLIDE,
        "<contact name='floor' radius='r' stiffness='k' damping='c'><body1 name='G' point='o'"
            + " vector='z'/><body2 name='a' point='o'/></contact>",
        "<jointVal name='z' posVals='h'/>");
  }

  /** A ball that rolls and slides over a wavy road with another exponent. */
  private static String road() {
    return model(
        parameter("k", 1e5)
            + parameter("c", 20)
            + parameter("r", 0.1)
            + parameter("mu", 0.3)
            + parameter("u", 0.05)
            + parameter("w", 0.01)
            + parameter("n", 1.5),
        FREE,
        "<contact name='road' radius='r' stiffness='k' damping='c' exponent='n' friction='mu'"
            + " frictionSpeed='u' height='w*sin(3*s)'><body1 name='G' point='o' vector='z' vector2='x'/>"
            + "<body2 name='a' point='o'/></contact>",
        "<jointVal name='f' posVals='1;0;0;0;0;0;0.2' velVals='0;0;0;1;0.2;0'/>");
  }

  /** A crate that hits the floor with one corner after another. */
  private static String crate() {
    return model(
        parameter("k", 1e4)
            + parameter("c", 50)
            + parameter("b", 0.4)
            + parameter("mu", 0.3)
            + parameter("u", 0.02),
        FREE,
        "<boxContact name='crate' box='b;0.4;0.4' stiffness='k' damping='c' friction='mu'"
            + " frictionSpeed='u'><body1 name='G' point='o' vector='z'/><body2 name='a'"
            + " point='o'/></boxContact>",
        "<jointVal name='f' posVals='0.99373034571758955;0.05;0.1;0;0;0;0.35'"
            + " velVals='0;0;0;1;0;0'/>");
  }

  /** A mass that flies into a damped stop and back. */
  private static String stop() {
    return model(
        parameter("k", 2e3) + parameter("c", 15) + parameter("s", 0.2) + parameter("v", 3),
        SLIDE,
        "<couplingSpringDamper name='stop' expression='z.q' side='tension' k='k' c='c' rest='s'/>",
        "<jointVal name='z' posVals='0' velVals='v'/>");
  }

  /** A mass that is shaken within the play of a spring with a damper. */
  private static String backlash() {
    return model(
        parameter("k", 3e3) + parameter("c", 4) + parameter("b", 0.02) + parameter("f", 90),
        SLIDE,
        "<couplingSpringDamper name='mesh' expression='z.q' k='k' c='c' backlash='b'/>"
            + "<jointForce name='shaker' joint='z' expression='2*9.81+f*sin(17*t+0.4)'/>",
        "<jointVal name='z' posVals='0.001'/>");
  }

  /** A mass on a spring whose curve is a table, with a brake that depends on the way. */
  private static String table(String method) {
    return model(
            parameter("a", 1.5) + parameter("c", 3) + parameter("v", 1.2),
            SLIDE,
            "<jointForce name='spring' joint='z'"
                + " expression='2*9.81-a*curve(z.q)-c*abs(z.q)*z.v-a*max(z.q-0.03*c,z.v)'/>",
            "<jointVal name='z' posVals='-0.01' velVals='v'/>")
        .replace(
            "<Bodies>",
            "<Tables><table name='curve' x='-0.1;-0.04;0;0.05;0.07;0.12'"
                + " y='-30;-6;0;9;20;60' method='"
                + method
                + "' extrapolation='hold'/></Tables><Bodies>");
  }

  /** Returns a model whose runs have a hundredth of the tolerances of the gradient's. */
  private static MechModel tight(String text) throws Exception {
    String tolerances = "relTol='1e-13' absTol='1e-14'";
    return MechModel.of("model.xml", text.replace(TOLERANCES, tolerances));
  }

  private static double value(MechModel model, String name) {
    return model.parameters().stream()
        .filter(p -> p.name().equals(name))
        .findFirst()
        .orElseThrow()
        .value();
  }

  private static double[] last(MechModel model, String[] columns) {
    Trajectory run = model.simulate();
    return Stream.of(columns).mapToDouble(name -> run.column(name)[run.rows() - 1]).toArray();
  }

  private static void assertAsDifferences(String text, List<String> by, String... columns)
      throws Exception {
    MechModel model = MechModel.of("model.xml", text);
    List<Reduction> last = Stream.of(columns).map(Reduction::parse).toList();
    Gradient found = Gradients.of(model, by, last).compute(GradientMethod.AUTO);
    MechModel tight = tight(text);
    for (int k = 0; k < by.size(); k++) {
      double value = value(model, by.get(k));
      double h = STEP * value;
      double[] expected = new double[columns.length];
      for (int side = 0; side < WEIGHTS.length; side++) {
        double[] above = last(tight.set(by.get(k), value + (side + 1) * h), columns);
        double[] below = last(tight.set(by.get(k), value - (side + 1) * h), columns);
        for (int i = 0; i < columns.length; i++) {
          expected[i] += WEIGHTS[side] * (above[i] - below[i]) / h;
        }
      }
      for (int i = 0; i < columns.length; i++) {
        double effect = Math.abs(value * expected[i]);
        assertThat(value * found.derivatives()[i][k])
            .as("%s by %s", columns[i], by.get(k))
            .isCloseTo(value * expected[i], within(NEAR * (1 + effect)));
      }
    }
  }

  @Test
  void derivativesOfABallThatReboundsAreThoseOfDifferences() throws Exception {
    assertAsDifferences(ball(), List.of("k", "c", "r", "h"), "z.q", "z.v");
  }

  @Test
  void derivativesOfABallOnAWavyRoadAreThoseOfDifferences() throws Exception {
    assertAsDifferences(
        road(), List.of("k", "c", "r", "mu", "u", "w", "n"), "f.q[4]", "f.q[6]", "f.v[1]");
  }

  @Test
  void derivativesOfACrateAreThoseOfDifferences() throws Exception {
    assertAsDifferences(crate(), List.of("k", "c", "b", "mu", "u"), "f.q[4]", "f.q[6]", "f.v[0]");
  }

  @Test
  void derivativesOfADampedStopAreThoseOfDifferences() throws Exception {
    assertAsDifferences(stop(), List.of("k", "c", "s", "v"), "z.q", "z.v");
  }

  @Test
  void derivativesOfBacklashAreThoseOfDifferences() throws Exception {
    assertAsDifferences(backlash(), List.of("k", "c", "b", "f"), "z.q", "z.v");
  }

  @ParameterizedTest
  @ValueSource(strings = {"linear", "cubic", "akima"})
  void derivativesOfATableAreThoseOfDifferences(String method) throws Exception {
    assertAsDifferences(table(method), List.of("a", "c", "v"), "z.q", "z.v");
  }

  /** z = s + v/ω sin φ with φ = ω (t − s/v), ω = √(k/m), and what follows by differentiation. */
  @ParameterizedTest
  @EnumSource(names = {"FORWARD", "ADJOINT"})
  void derivativesOfASpringThatIsTouchedAreThoseOfItsClosedForm(GradientMethod method)
      throws Exception {
    double k = 50;
    double s = 0.2;
    double v = 1;
    MechModel model =
        MechModel.of(
            "model.xml",
            model(
                parameter("k", k) + parameter("s", s) + parameter("v", v),
                SLIDE,
                "<jointForce name='spring' joint='z' expression='2*9.81-k*max(0,z.q-s)'/>",
                "<jointVal name='z' posVals='0' velVals='v'/>"));
    Gradient found =
        Gradients.of(
                model,
                List.of("k", "s", "v"),
                List.of(Reduction.parse("z.q"), Reduction.parse("z.v")))
            .compute(method);
    double omega = Math.sqrt(k / 2);
    double byK = omega / (2 * k);
    double time = 0.6 - s / v;
    double sine = Math.sin(omega * time);
    double cosine = Math.cos(omega * time);
    double[][] expected = {
      {v / omega * (cosine * time - sine / omega) * byK, 1 - cosine, sine / omega + cosine * s / v},
      {-v * sine * time * byK, omega * sine, cosine - sine * omega * s / v}
    };
    for (int i = 0; i < expected.length; i++) {
      assertThat(found.derivatives()[i]).containsExactly(expected[i], within(CLOSED));
    }
  }
}
