package org.mechservice.sim.scene.forecast;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.scene.Finding;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.IntegrationMethod;
import org.mechservice.solver.catalogue.MethodNames;

/** No finding before a run advises the integrator, the formulation or the closure that will run. */
class AdviceTest {
  /** Where the advice of a finding begins. */
  private static final Pattern ADVICE = Pattern.compile("[;:] (use|formulation|hardly|end) ");

  private static List<String> integrators() {
    List<String> names = new ArrayList<>(List.of(MethodNames.AUTO));
    for (IntegrationMethod method : IntegrationMethod.values()) {
      names.add(method.label());
    }
    return names;
  }

  private static List<String> formulations() {
    List<String> names = new ArrayList<>(List.of(MethodNames.AUTO));
    for (Formulation formulation : Formulation.values()) {
      names.add(formulation.label());
    }
    return names;
  }

  private static void look(Finding finding, String integrator, String formulation, String closure) {
    var found = ADVICE.matcher(finding.text());
    String advice = found.find() ? finding.text().substring(found.start()) : "";
    String place = finding + " with " + integrator + ", " + formulation + ", " + closure;
    assertThat(advice.split("[^A-Za-z0-9-]+")).as(place).doesNotContain(integrator);
    if (!formulation.equals(MethodNames.AUTO)) {
      assertThat(advice.split("[^A-Za-z0-9-]+")).as(place).doesNotContain(formulation);
    }
    if (!closure.equals(MethodNames.AUTO)) {
      assertThat(advice).as(place).doesNotContain("closure \"" + closure + "\"");
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "extremes/spring_1e12_far_over_critical",
        "extremes/spring_1e12_undamped",
        "extremes/fourbar_redundant",
        "four-bar/four-bar"
      })
  void adviceIsAnotherMethod(String scene) throws IOException, MechmlException {
    Path file = Path.of("../../examples", scene + ".xml");
    MechmlModel model = MechmlReader.read(scene, Files.readAllBytes(file));
    int seen = 0;
    for (String integrator : integrators()) {
      for (String formulation : formulations()) {
        for (String closure : List.of(MethodNames.AUTO, "projection", "penalty")) {
          RunSettings run =
              model
                  .settings()
                  .run()
                  .withOutput(10, 0.1)
                  .withIntegrator(integrator)
                  .withRelativeTolerance(1e-13)
                  .withTolerances(List.of(1e-13));
          for (Finding finding : RunForecast.of(model, formulation, closure, run)) {
            look(finding, integrator, formulation, closure);
            seen++;
          }
        }
      }
    }
    assertThat(seen).isPositive();
  }
}
