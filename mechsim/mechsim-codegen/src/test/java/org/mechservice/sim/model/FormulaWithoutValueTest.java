package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.simulation.RuntimeSolver;

/**
 * A run that ends at a force given by a formula names the force, the formula and what in it has no
 * value, in code and in data alike.
 */
class FormulaWithoutValueTest {
  private static final String BODY =
      "<body name=\"%1$s\"><point name=\"p1\" x=\"0\" y=\"0\" z=\"0\"/><point name=\"p2\" x=\"1\""
          + " y=\"0\" z=\"0\"/><vector name=\"x\" vx=\"1\" vy=\"0\" vz=\"0\"/><vector name=\"y\""
          + " vx=\"0\" vy=\"1\" vz=\"0\"/><mass value=\"1\"/><inertiaTensor Ixx=\"1\" Iyy=\"1\""
          + " Izz=\"1\"/></body>";
  private static final String GROUND =
      "<body name=\"Ground\"><point name=\"p1\" x=\"0\" y=\"0\" z=\"0\"/><point name=\"p2\" x=\"3\""
          + " y=\"0\" z=\"0\"/><vector name=\"x\" vx=\"1\" vy=\"0\" vz=\"0\"/><vector name=\"y\""
          + " vx=\"0\" vy=\"1\" vz=\"0\"/></body>";

  private static String joint(String name, String type, String point, String body, String axis) {
    return String.format(
        "<joint name=\"%s\" type=\"%s\"><body1 name=\"Ground\" point=\"%s\" vector=\"%5$s\"/><body2"
            + " name=\"%4$s\" point=\"p1\" vector=\"%5$s\"/></joint>",
        name, type, point, body, axis);
  }

  private static String start(String joint, double q, double v) {
    return "<jointVal name=\"" + joint + "\" posVals=\"" + q + "\" velVals=\"" + v + "\"/>";
  }

  private static String scene(
      String bodies, String joints, String constraints, String formula, String of, String starts) {
    return "<MechML><MBSsimulation><dynamic><timeSet tini=\"0\" tend=\"20\""
        + " tstep=\"1\"/><integrator name=\"ode113\" relTol=\"1e-8\""
        + " absTol=\"1e-10\"/></dynamic></MBSsimulation><MBSmodel name=\"formulas\""
        + " massUnits=\"kg\" lengthUnits=\"m\"><Bodies>"
        + GROUND
        + bodies
        + "</Bodies><Joints>"
        + joints
        + "</Joints>"
        + constraints
        + "<Forces><jointForce name=\"push\" joint=\"other\" expression=\"-other.v\"/><jointForce"
        + " name=\"pull\" joint=\""
        + of
        + "\" expression=\""
        + formula
        + "\"/></Forces><topology><root name=\"Ground\"/><relCoorVals>"
        + starts
        + "</relCoorVals></topology></MBSmodel></MechML>";
  }

  /** Two sliders; the formula acts on the first. */
  private static String sliders(String formula, double q, double v) {
    return scene(
        String.format(BODY, "a") + String.format(BODY, "b"),
        joint("s", "P", "p1", "a", "x") + joint("other", "P", "p2", "b", "x"),
        "",
        formula,
        "s",
        start("s", q, v) + start("other", 0, 1));
  }

  /** A parallelogram; the formula acts on its left bar. */
  private static String parallelogram(String formula) {
    return scene(
        String.format(BODY, "a") + String.format(BODY, "b"),
        joint("s", "R", "p1", "a", "y") + joint("other", "R", "p2", "b", "y"),
        "<Constraints><DISTConstraint name=\"rod\" dist=\"3\"><body1 name=\"a\""
            + " point=\"p2\"/><body2 name=\"b\" point=\"p2\"/></DISTConstraint></Constraints>",
        formula,
        "s",
        start("s", 1, 1) + start("other", 1, 1));
  }

  private static Failure failure(
      String scene, boolean compact, String formulation, String integrator) throws Exception {
    MechmlModel model = read(scene);
    RunSettings settings = new RunSettings(0, 20, 1, integrator, 1e-8, 1e-10);
    BuildOptions options = new BuildOptions(formulation, "auto", compact, Set.of(), settings);
    GeneratedModel generated = ModelFactory.generate(model, options);
    assertThat(generated.operations() == 0).isEqualTo(compact);
    Outcome outcome =
        new RuntimeSolver()
            .run(
                ModelFactory.compile(model, options, generated).newInstance(),
                new RunRequest(settings, Set.of()),
                new FiniteRows(),
                new RunControl())
            .outcome();
    assertThat(outcome).isInstanceOf(Outcome.Failed.class);
    return ((Outcome.Failed) outcome).failure();
  }

  private static MechmlModel read(String scene) throws MechmlException {
    return MechmlReader.read("formulas.xml", scene.getBytes(StandardCharsets.UTF_8));
  }

  /** Lets nothing pass that is not finite. */
  private static final class FiniteRows implements ResultSink {
    private final List<Variable> columns = new ArrayList<>();

    @Override
    public void begin(List<Variable> columns) {
      this.columns.addAll(columns);
    }

    @Override
    public void row(double[] values) {
      assertThat(values).hasSameSizeAs(columns);
      for (double value : values) {
        assertThat(value).isFinite();
      }
    }
  }

  private static final String METHODS =
      """
      false, DTR,   ode113
      false, DTR,   DE
      false, DTR,   ode15s
      false, DTR,   switching
      false, DSR,   ode15s
      false, RR,    ode15sR
      false, RR-JF, ode15sR
      true,  DTR,   ode113
      true,  DTR,   ode15s
      true,  DSR,   DE
      true,  RR,    ode15sR
      true,  RR-JF, ode15sR
      """;

  @ParameterizedTest
  @CsvSource(textBlock = METHODS)
  void rootOfANegativeNumberIsNamedWithItsArgument(
      boolean compact, String formulation, String integrator) throws Exception {
    Failure failure = failure(sliders("-sqrt(0.5 - s.q)", 0, 1), compact, formulation, integrator);
    assertThat(failure.code()).isEqualTo(MessageCode.FORCE_NOT_FINITE);
    assertThat(failure.part()).isEqualTo("force pull");
    assertThat(failure.time()).isBetween(0.5, 0.6);
    assertThat(failure.cause())
        .contains("joint force -sqrt(0.5 - s.q)")
        .contains("sqrt(0.5 - s.q) is NaN for 0.5 - s.q = -");
  }

  @ParameterizedTest
  @CsvSource(textBlock = METHODS)
  void formulaWithoutValueAtTheStartIsNamed(boolean compact, String formulation, String integrator)
      throws Exception {
    Failure failure = failure(sliders("log(s.q)/2", -1, 0), compact, formulation, integrator);
    assertThat(failure.code()).isEqualTo(MessageCode.FORCE_NOT_FINITE);
    assertThat(failure.part()).isEqualTo("force pull");
    assertThat(failure.time()).isZero();
    assertThat(failure.cause()).contains("log(s.q) is NaN for s.q = -1.0");
  }

  /** The graph of expressions finds the zero itself, and leaves what to say of it to the run. */
  @ParameterizedTest
  @CsvSource(textBlock = METHODS)
  void divisionByADifferenceThatIsAlwaysZeroIsNamed(
      boolean compact, String formulation, String integrator) throws Exception {
    Failure failure = failure(sliders("2/(s.q - s.q)", 1, 0), compact, formulation, integrator);
    assertThat(failure.code()).isEqualTo(MessageCode.FORCE_NOT_FINITE);
    assertThat(failure.part()).isEqualTo("force pull");
    assertThat(failure.cause()).contains("is Infinity for s.q - s.q = 0.0");
  }

  @ParameterizedTest
  @CsvSource(textBlock = METHODS)
  void constantsWhoseProductOverflowsEndTheRunAtTheirJoint(
      boolean compact, String formulation, String integrator) throws Exception {
    Failure failure = failure(sliders("1e200*s.q*1e200", 1, 0), compact, formulation, integrator);
    assertThat(failure.code())
        .isIn(
            MessageCode.NOT_FINITE,
            MessageCode.NO_CONSISTENT_INITIAL_VALUES,
            MessageCode.FORCE_NOT_FINITE);
    assertThat(failure.part()).containsAnyOf("s.v", "force pull");
  }

  @ParameterizedTest
  @CsvSource(textBlock = METHODS)
  void forceThatOverflowsIsNamed(boolean compact, String formulation, String integrator)
      throws Exception {
    Failure failure = failure(sliders("exp(s.q^3)", 0, 10), compact, formulation, integrator);
    assertThat(failure.code()).isIn(MessageCode.STEP_TOO_SMALL, MessageCode.FORCE_NOT_FINITE);
    assertThat(failure.part()).isEqualTo("force pull");
    assertThat(failure.cause()).contains("joint force exp(s.q^3)");
  }

  @ParameterizedTest
  @CsvSource(textBlock = METHODS)
  void forceThatJumpsToAndFroIsNamed(boolean compact, String formulation, String integrator)
      throws Exception {
    Failure failure =
        failure(sliders("-signum(s.v) - s.q", 3.3, 0), compact, formulation, integrator);
    assertThat(failure.code()).isIn(MessageCode.STEP_TOO_SMALL, MessageCode.NEWTON_DIVERGES);
    assertThat(failure.part()).isEqualTo("force pull");
    assertThat(failure.cause()).contains("joint force -signum(s.v) - s.q changes");
  }

  @ParameterizedTest
  @CsvSource({
    "false, DSR,   ode113",
    "false, DSR,   ode15s",
    "false, RR,    ode15sR",
    "false, RR-JF, ode15sR",
    "true,  DSR,   ode113",
    "true,  RR-JF, ode15sR"
  })
  void loopsDoNotHideIt(boolean compact, String formulation, String integrator) throws Exception {
    Failure failure =
        failure(parallelogram("1 - sqrt(1.2 - s.q)"), compact, formulation, integrator);
    assertThat(failure.code()).isEqualTo(MessageCode.FORCE_NOT_FINITE);
    assertThat(failure.part()).isEqualTo("force pull");
    assertThat(failure.cause()).contains("sqrt(1.2 - s.q) is NaN for 1.2 - s.q = -");
  }

  @Test
  void sourceSaysWhatTheClassFileDoes() throws Exception {
    MechmlModel model = read(sliders("log(s.q)/2", 1, 0));
    BuildOptions options = new BuildOptions("DTR", Set.of(), Scenes.SETTINGS);
    GeneratedModel generated = ModelFactory.generate(model, options);
    assertThat(generated.source()).contains("public String formulas()").contains("formulaValues");
    assertThat(ModelFactory.compileSource(model, options, generated).newInstance()).isNotNull();
  }

  @Test
  void sceneWhoseForcesAlwaysHaveValuesCarriesNothingForIt() throws Exception {
    MechmlModel model = read(sliders("-3*s.q + 2*sin(t)", 1, 0));
    BuildOptions options = new BuildOptions("DTR", Set.of(), Scenes.SETTINGS);
    assertThat(ModelFactory.generate(model, options).source()).doesNotContain("formulaValues");
  }
}
