package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.LinearisedModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.dynamics.LinearisedResidualModel;
import org.mechservice.solver.force.user.UserForceSource;

/**
 * What a formula, a stop or a contact does not do at a state leaves nothing there, neither in its
 * value nor in its derivatives, however steep it would be: in data, in the class file and in the
 * compiled source. The scene is a block of 1 kg that slides along x.
 */
class BranchesNotTakenTest {
  static final BuildOptions OPTIONS =
      new BuildOptions("RR-JF", Set.of(), new RunSettings(0, 1, 0.1, "ode15sR", 1e-6, 1e-8));

  static MechmlModel scene(String forces) throws Exception {
    String axes =
        "<vector name=\"x\" vx=\"1\" vy=\"0\" vz=\"0\"/><vector name=\"z\" vx=\"0\" vy=\"0\""
            + " vz=\"1\"/>";
    String text =
        "<MechML><MBSsimulation><dynamic><timeSet tini=\"0\" tend=\"1\" tstep=\"1\"/><integrator"
            + " name=\"ode113\" relTol=\"1e-8\""
            + " absTol=\"1e-8\"/></dynamic></MBSsimulation><MBSmodel name=\"block\""
            + " massUnits=\"kg\" lengthUnits=\"m\"><Bodies><body name=\"Ground\"><point name=\"o\""
            + " x=\"0\" y=\"0\" z=\"0\"/>"
            + axes
            + "</body><body name=\"block\"><point name=\"c\" x=\"0\" y=\"0\" z=\"0\"/>"
            + axes
            + "<mass value=\"1\"/><inertiaTensor Ixx=\"1\" Iyy=\"1\" Izz=\"1\"/></body></Bodies>"
            + "<Joints><joint name=\"s\" type=\"P\"><body1 name=\"Ground\" point=\"o\""
            + " vector=\"x\"/><body2 name=\"block\" point=\"c\" vector=\"x\"/></joint></Joints>"
            + "<Forces>"
            + forces
            + "</Forces><topology><root name=\"Ground\"/><relCoorVals><jointVal name=\"s\""
            + " posVals=\"0\" velVals=\"0\"/></relCoorVals></topology></MBSmodel></MechML>";
    return MechmlReader.read("block.xml", text.getBytes(StandardCharsets.UTF_8));
  }

  /** What one Newton step makes of two residuals, after the accelerations. */
  static double[] step(Model model, double q, double v) {
    double[] y = {q, v};
    double[] all = new double[4];
    double[] rates = new double[2];
    assertThat(((ExplicitModel) ModelParts.of(model).equations()).derivative(0, y, rates))
        .isEqualTo(ExplicitModel.REGULAR);
    LinearisedModel linearised = (LinearisedModel) ModelParts.of(model).equations();
    assertThat(linearised.linearise(0, y, rates)).isTrue();
    assertThat(linearised.factor(0.5)).isTrue();
    double[] solution = {1, -0.7};
    linearised.solve(solution);
    System.arraycopy(rates, 0, all, 0, 2);
    System.arraycopy(solution, 0, all, 2, 2);
    return all;
  }

  private static void assertFiniteAndAlike(MechmlModel file, double q, double v) {
    double[] data =
        step(
            new LinearisedResidualModel(
                file.mechanism(),
                OPTIONS.settings(),
                UserForceSource.NONE,
                LinearisedResidualModel.Mode.FULL),
            q,
            v);
    GeneratedModel generated = ModelFactory.generate(file, OPTIONS);
    assertThat(generated.operations()).isPositive();
    double[] code = step(ModelFactory.compile(file, OPTIONS, generated).newInstance(), q, v);
    for (int i = 0; i < 4; i++) {
      assertThat(data[i]).isFinite();
      // a few operations in another order
      assertThat(code[i]).isCloseTo(data[i], within(1e-13 * (1 + Math.abs(data[i]))));
    }
    Model compiled = ModelFactory.compileSource(file, OPTIONS, generated).newInstance();
    assertThat(step(compiled, q, v)).containsExactly(code);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          max(sqrt(s.q), 1)                      |  0  | 0
          max(1, sqrt(s.q))                      |  0  | 0
          min(sqrt(s.q), -1)                     |  0  | 0
          min(1, 2 + log(1 + s.q^0.3))           |  0  | 0
          max(2, s.v*sqrt(s.q))                  |  0  | 1
          max(asin(s.q), 2)                      |  1  | 0
          max(acos(s.q), 4)                      |  1  | 0
          -10*sqrt(max(s.q, 0))                  | -1  | 2
          -10*sqrt(max(0, s.q))                  | -1  | 2
          -10*max(0, s.q)^0.5                    | -1  | 2
          -10*max(0, s.q)^1.5                    | -1  | 2
          -10*pow(max(0, s.q), 1.3)              | -1  | 2
          -10*pow(max(0, s.q), 0.3)              | -1  | 2
          asin(min(1, s.q))                      |  2  | 0
          acos(max(-1, s.q))                     | -2  | 0
          exp(-1/max(0, s.q)^2)                  | -2  | 0
          exp(-1/s.q^2)                          |  0  | 1
          log(max(1e-300, s.q))                  | -1  | 1
          smoothStep(s.q)*sqrt(smoothStep(s.q))  | -1  | 1
          sqrt(smoothStep(s.q))                  |  3  | 1
          sqrt(smoothStep(s.q))                  | -3  | 1
          sqrt(step(s.q))                        | -3  | 1
          step(s.q)*s.v/(1 + floor(s.q))         | 0.5 | 1
          abs(sqrt(s.q))                         |  0  | 1
          signum(s.v)*sqrt(abs(s.v))             |  1  | 0
          sqrt(abs(s.v))*s.v                     |  1  | 0
          sqrt(s.q^2 + s.v^2)                    |  0  | 0
          hypot(s.q, s.v)                        |  0  | 0
          atan2(s.q, s.v)                        |  0  | 0
          3*cos(atan2(s.v, s.q))                 |  0  | 0
          1/(1 + exp(1000*s.q))                  |  1  | 0
          1/(1 + exp(1000*s.q))                  | -1  | 0
          s.v/(1 + exp(1000*s.q))                |  1  | 2
          tanh(sinh(1000*s.q))                   |  1  | 0
          atan(exp(1000*s.q))                    |  1  | 0
          tanh(1/s.q)                            |  0  | 0
          1/cosh(1000*s.q)                       |  1  | 0
          pow(s.q, floor(s.v))                   |  0  | 0.5
          (s.q + 1)^(2 + step(s.v))              | -1  | 1
          """)
  void slopesOfFormulasLeaveNothing(String formula, double q, double v) throws Exception {
    String force = "<jointForce name=\"f\" joint=\"s\" expression=\"" + formula + " - s.v\"/>";
    assertFiniteAndAlike(scene(force), q, v);
  }

  @ParameterizedTest
  @CsvSource({
    "1, 0, 1e-3",
    "1.2, 0, 1e-3",
    "1.5, 0, 1e-3",
    "2, 0, 1e-3",
    "1.5, 0, -0.3",
    "1.3, 0, -0.3",
    "1.5, 1e-12, -0.3",
    "1.3, 1e-12, -0.3",
    "1.5, 1e-12, 0.3",
    "1, 1e-9, 50"
  })
  void aContactThatDoesNotTouchHasDerivatives(double exponent, double smoothing, double q)
      throws Exception {
    String contact =
        "<contact name=\"c\" stiffness=\"1e4\" damping=\"30\" friction=\"0.5\""
            + " frictionSpeed=\"0.1\" exponent=\""
            + exponent
            + "\" smoothing=\""
            + smoothing
            + "\"><body1 name=\"Ground\" point=\"o\" vector=\"x\"/>"
            + "<body2 name=\"block\" point=\"c\"/></contact>";
    assertFiniteAndAlike(scene(contact), q, -0.2);
  }

  @ParameterizedTest
  @CsvSource({"0, 1.3", "0, 0.7", "1e-12, 1.3", "1e-12, 0.7", "1e-9, 4"})
  void aRopeHasDerivativesFarFromItsLength(double smoothing, double q) throws Exception {
    String stop =
        "<springDamper name=\"d\" k=\"100\" c=\"3\" length0=\"1\" side=\"tension\" smoothing=\""
            + smoothing
            + "\"><body1 name=\"Ground\" point=\"o\"/><body2 name=\"block\""
            + " point=\"c\"/></springDamper>";
    assertFiniteAndAlike(scene(stop), q, 0.4);
  }
}
