package org.mechservice.study.gradient;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.mechservice.library.MechModel;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.study.Reduction;

/** Derivatives across contacts against central differences of whole runs. */
final class ContactGradientTest {
  private static final double[] WEIGHTS = {2.0 / 3, -1.0 / 12};

  /** Step of the differences, as a part of the value. */
  private static final double STEP = 1e-3;

  /**
   * Of the effect of a parameter's value, m or m/s: fourth order leaves h⁴, and runs at 1e-11 err
   * by some 1e-10 m, which a step of 1e-3 makes 1e-7.
   */
  private static final double NEAR = 1e-6;

  private static String model(String parameters, String joint, String contact, String start) {
    return "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='0.6' tstep='0.3'/>"
        + "<integrator name='ode113' relTol='1e-11' absTol='1e-12'/></dynamic></MBSsimulation>"
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
    for (int k = 0; k < by.size(); k++) {
      double value = value(model, by.get(k));
      double h = STEP * value;
      double[] expected = new double[columns.length];
      for (int side = 0; side < WEIGHTS.length; side++) {
        double[] above = last(model.set(by.get(k), value + (side + 1) * h), columns);
        double[] below = last(model.set(by.get(k), value - (side + 1) * h), columns);
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
}
