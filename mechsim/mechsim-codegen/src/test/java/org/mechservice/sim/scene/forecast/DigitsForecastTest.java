package org.mechservice.sim.scene.forecast;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.scene.Finding;
import org.mechservice.solver.catalogue.MessageCode;

/** Light balls that carry heavy ones, 1e8 times their mass in all. */
class DigitsForecastTest {
  private static Optional<Finding> forecast(String scene, String formulation)
      throws IOException, MechmlException {
    Path file = Path.of("..", "..", "examples", "extremes", scene + ".xml");
    MechmlModel model = MechmlReader.read(scene, Files.readAllBytes(file));
    return DigitsForecast.of(model.mechanism(), formulation, model.settings().run());
  }

  @Test
  void massMatrixThatLosesMoreDigitsThanTheToleranceLeavesIsForeseen() throws Exception {
    assertThat(forecast("massratio_1e8_balls", "DSR"))
        .hasValueSatisfying(
            found -> {
              assertThat(found.code()).isEqualTo(MessageCode.NEARLY_SINGULAR_INERTIA);
              assertThat(found.text()).contains("joint \"j1\"", "use formulation DTR");
            });
  }

  @Test
  void formulationsWithoutThatMatrixAndSoundChainsAreNotWarnedOf() throws Exception {
    assertThat(forecast("massratio_1e8_balls", "DTR")).isEmpty();
    assertThat(forecast("massratio_1e8_balls", "auto")).isEmpty();
    assertThat(forecast("rtol_1e-2", "DSR")).isEmpty();
  }
}
