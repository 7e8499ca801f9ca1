package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.simulation.RuntimeSolver;

/** A parameter set before the start does what the same value in the file does, to the last bit. */
class TunableParametersTest {
  private static final Map<String, String> OTHER =
      Map.of("k", "0.3", "radius", "80", "swing", "-25");

  private static final String MESH =
      "<CoordConstraint name=\"mesh\" expression=\"slide.q - radius*turn.q\"/>";

  private static String text(boolean loop) {
    try (InputStream in =
        Objects.requireNonNull(TunableParametersTest.class.getResourceAsStream("tuned.xml"))) {
      String text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
      return loop ? text : text.replace(MESH, "").replace("-k*slide.q", "-k*slide.q*radius/0.1");
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }

  private static CompiledModel compiled(
      String text, ReadOptions options, String formulation, boolean compact)
      throws MechmlException {
    MechmlModel model =
        MechmlReader.read("tuned.xml", text.getBytes(StandardCharsets.UTF_8), options);
    String integrator = formulation.startsWith("RR") ? "ode15sR" : "DE";
    BuildOptions build =
        new BuildOptions(
            formulation,
            "auto",
            compact,
            EnumSet.of(ColumnGroup.JOINTS),
            new RunSettings(0, 0.5, 0.1, integrator, 1e-6, 1e-8));
    return ModelFactory.compile(model, build, ModelFactory.generate(model, build));
  }

  private static List<double[]> run(Model model) throws IOException {
    KeptRows kept = new KeptRows();
    RunReport report =
        new RuntimeSolver()
            .run(
                model,
                new RunRequest(model.description().defaults(), EnumSet.of(ColumnGroup.JOINTS)),
                kept,
                new RunControl());
    assertThat(report.outcome()).isInstanceOf(Outcome.Completed.class);
    return kept.rows();
  }

  @CsvSource({
    "DTR, false",
    "DSR, false",
    "RR, false",
    "RR-JF, false",
    "DSR, true",
    "RR, true",
    "RR-JF, true"
  })
  @ParameterizedTest
  void valueSetBeforeTheStartIsTheValueOfTheFile(String formulation, boolean loop)
      throws Exception {
    ModelSource tuned = compiled(text(loop), ReadOptions.NONE, formulation, false).instances();
    ModelSource written =
        compiled(text(loop), ReadOptions.setting(OTHER), formulation, false).instances();
    List<double[]> rows = run(tuned.model(OTHER));
    assertThat(rows).usingRecursiveComparison().isEqualTo(run(written.model()));
    assertThat(rows).usingRecursiveComparison().isNotEqualTo(run(tuned.model()));
  }

  @Test
  void parametersAreToldAndTakenInTheUnitsOfTheFile() throws Exception {
    ModelSource source = compiled(text(true), ReadOptions.NONE, "DSR", false).instances();
    assertThat(source.parameters())
        .containsExactly(
            new TunableParameter("k", "N/mm", 0.2),
            new TunableParameter("radius", "mm", 100),
            new TunableParameter("swing", "deg", 10));
  }

  @Test
  void parameterThatWasSettledIsRefusedWithTheBuildThatKeepsIt() throws Exception {
    ModelSource source = compiled(text(true), ReadOptions.NONE, "DSR", false).instances();
    assertThatThrownBy(() -> source.model(Map.of("mass", "3")))
        .hasMessageStartingWith("S-125 parameter \"mass\" cannot be set")
        .hasMessageContaining("one can set k, radius, swing")
        .hasMessageContaining("mech build MODEL.xml -o FILE.jar --standalone --tunable mass");
  }

  @Test
  void modelWithoutTunableParametersRefusesThemAll() throws Exception {
    String text = text(false).replace(" tunable=\"true\"", "");
    ModelSource source = compiled(text, ReadOptions.NONE, "DTR", false).instances();
    assertThat(source.parameters()).isEmpty();
    assertThatThrownBy(() -> source.model(Map.of("k", "3")))
        .hasMessageStartingWith("S-125")
        .hasMessageContaining("none can");
  }

  @CsvSource({"abc", "1/2", "NaN", "1e999", "3f", "''"})
  @ParameterizedTest
  void whatIsNoNumberIsRefused(String value) throws Exception {
    ModelSource source = compiled(text(true), ReadOptions.NONE, "DSR", false).instances();
    assertThatThrownBy(() -> source.model(Map.of("k", value)))
        .hasMessageStartingWith("S-126 parameter \"k\" is set to \"" + value + "\"")
        .hasMessageEndingWith("N/mm");
  }
}
