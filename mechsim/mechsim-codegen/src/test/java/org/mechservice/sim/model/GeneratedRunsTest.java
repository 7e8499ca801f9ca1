package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.simulation.RuntimeSolver;

/** Runs of generated code with events, jumps and kinked drives are those of the data. */
class GeneratedRunsTest {
  private static final String EVENTS =
      """
          <event name="top" expression="slide.v" action="record"/>
          <event name="kick" expression="slide.q - 0.02" direction="falling" action="set">
            <set name="slide" velVals="0.5 - 0.1*slide.v"/>
          </event>
      """;

  private static String text() {
    return Scenes.text("tuned.xml")
        .replaceAll("<CoordConstraint.*/>", "")
        .replace("<Constraints>", "")
        .replace("</Constraints>", "")
        .replace("</dynamic>", EVENTS + "</dynamic>")
        .replace("-k*slide.q", "-k*slide.q + 3*signum(sin(40*t)) + step(t - 0.31)")
        .replace("swing*(1 + sin(2*t))", "swing*abs(sin(9*t))");
  }

  private record Ran(RunReport report, List<double[]> rows, String reason) {}

  private static Ran run(String formulation, String integrator, boolean compact) throws Exception {
    MechmlModel model = MechmlReader.read("tuned.xml", text().getBytes(StandardCharsets.UTF_8));
    RunSettings settings = new RunSettings(0, 0.5, 0.05, integrator, 1e-9, 1e-10);
    BuildOptions options = new BuildOptions(formulation, "auto", compact, Set.of(), settings);
    GeneratedModel generated = ModelFactory.generate(model, options);
    KeptRows kept = new KeptRows();
    RunReport report =
        new RuntimeSolver()
            .run(
                ModelFactory.compile(model, options, generated).newInstance(),
                new RunRequest(settings, Set.of()),
                kept,
                new RunControl());
    return new Ran(report, kept.rows(), generated.formulationReason());
  }

  @CsvSource({"DTR, ode113", "DSR, DE", "DTR, ode15s", "RR, ode15sR", "RR-JF, ode15sR"})
  @ParameterizedTest
  void eventsAndJumpsHappenAsTheyDoWithoutGeneratedCode(String formulation, String integrator)
      throws Exception {
    Ran code = run(formulation, integrator, false);
    Ran data = run(formulation, integrator, true);
    assertThat(code.reason()).doesNotContain("compact form");
    assertThat(data.reason()).contains("compact form");
    assertThat(code.report().outcome()).isInstanceOf(Outcome.Completed.class);
    // 11 output times; the kick at 0.157 s and 0.484 s, and the top between them at 0.308 s
    assertThat(code.rows()).hasSameSizeAs(data.rows()).hasSize(14);
    for (int i = 0; i < code.rows().size(); i++) {
      // Steps may differ by rounding: both keep the tolerance, some hundred of it over the run.
      assertThat(code.rows().get(i)).containsExactly(data.rows().get(i), within(1e-6));
    }
  }

  @CsvSource({"DTR, DE", "RR-JF, ode15sR"})
  @ParameterizedTest
  void parametersEnterTheSourceAsTheyEnterTheClassFile(String formulation, String integrator)
      throws Exception {
    MechmlModel model = MechmlReader.read("tuned.xml", text().getBytes(StandardCharsets.UTF_8));
    RunSettings settings = new RunSettings(0, 0.5, 0.05, integrator, 1e-9, 1e-10);
    BuildOptions options = new BuildOptions(formulation, Set.of(), settings);
    GeneratedModel generated = ModelFactory.generate(model, options);
    double[] parameters = {250, 0.08, -0.3};
    assertThat(derivative(ModelFactory.compile(model, options, generated), parameters))
        .containsExactly(
            derivative(ModelFactory.compileSource(model, options, generated), parameters))
        .isNotEqualTo(
            derivative(ModelFactory.compile(model, options, generated), new double[] {1, 1, 1}));
  }

  private static double[] derivative(CompiledModel model, double[] parameters) {
    ExplicitModel made =
        (ExplicitModel) ModelParts.of(model.instances().model(parameters)).equations();
    double[] y = {0.1, 0.2, 0.3, 0.4};
    double[] yDot = new double[y.length];
    assertThat(made.derivative(0.7, y, yDot)).isEqualTo(ExplicitModel.REGULAR);
    return yDot;
  }
}
