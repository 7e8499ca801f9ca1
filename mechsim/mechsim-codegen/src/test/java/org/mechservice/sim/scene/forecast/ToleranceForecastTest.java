package org.mechservice.sim.scene.forecast;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.scene.Finding;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;

/** Implicit steps by penalty are warned of where their rounding is as large as the tolerance. */
class ToleranceForecastTest {
  @ParameterizedTest
  @CsvSource({
    "RR-JF, penalty, 1e-12, 1e-12, true",
    "RR, penalty:alpha=1e4, 1e-12, 1e-12, true",
    "RR-JF, penalty, 1e-10, 1e-13, true",
    "RR-JF, penalty, 2e-12, 2e-12, false",
    "RR-JF, penalty, 1e-13, 1e-11, false",
    "RR-JF, projection, 1e-12, 1e-12, false",
    "DSR, penalty, 1e-12, 1e-12, false",
  })
  void finestTolerancesOfImplicitPenaltyAreWarnedOf(
      String formulation, String closure, double relative, double absolute, boolean warned)
      throws Exception {
    byte[] text = Files.readAllBytes(Path.of("../../examples/four-bar/four-bar.xml"));
    MechmlModel model = MechmlReader.read("four-bar.xml", text);
    RunSettings settings =
        model
            .settings()
            .run()
            .withIntegrator(formulation.startsWith("RR") ? "ode15sR" : "ode113")
            .withRelativeTolerance(relative)
            .withTolerances(List.of(absolute));
    List<Finding> found = RunForecast.of(model, formulation, closure, settings);
    assertThat(found)
        .extracting(Finding::code)
        .filteredOn(code -> code == MessageCode.TOLERANCE_NEAR_ROUNDING)
        .hasSize(warned ? 1 : 0);
  }
}
