package org.mechservice.sim.scene.forecast;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.scene.Finding;
import org.mechservice.solver.catalogue.MessageCode;

class StiffnessForecastTest {
  private static final Path EXTREMES = Path.of("../../examples/extremes");

  private static String scene(String name) {
    try {
      return Files.readString(EXTREMES.resolve(name + ".xml"), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }

  private static Optional<Finding> forecast(String text) {
    try {
      MechmlModel model = MechmlReader.read("scene.xml", text.getBytes(StandardCharsets.UTF_8));
      return StiffnessForecast.of(model, model.settings().run());
    } catch (MechmlException e) {
      throw new IllegalArgumentException(e);
    }
  }

  private static String with(String text, String integrator) {
    return text.replaceFirst("integrator name=\"\\w+\"", "integrator name=\"" + integrator + "\"");
  }

  /**
   * 1 kg on 1e12 N/m with 2e8 N·s/m: λ = −c/2m ∓ √((c/2m)² − k/m) = −1.99995e8 and −5e3 1/s. Steps
   * of ode113 counted over 1e-3 s: 123 454.
   */
  @Test
  void fastDecayIsForeseenWithItsJointItsSpeedAndItsSteps() {
    assertThat(forecast(with(scene("spring_1e12_far_over_critical"), "ode113")))
        .hasValueSatisfying(
            found -> {
              assertThat(found.code()).isEqualTo(MessageCode.VERY_MANY_STEPS);
              assertThat(found.text())
                  .contains(
                      "joint \"j1\"", "for ode113:", "decays with 2.00e+08 1/s", "1e+07 steps")
                  .contains("use integrator \"auto\"");
            });
  }

  /** 1 kg on 1e12 N/m: ω = 1e6 rad/s, for 10 s. Steps of DE counted over 0.01 s: 60 979. */
  @Test
  void undampedOscillationIsForeseenAndNoImplicitMethodPromised() {
    String longer = scene("spring_1e12_undamped").replaceFirst("tend=\"[^\"]*", "tend=\"10");
    assertThat(forecast(with(longer, "DE")))
        .hasValueSatisfying(
            found ->
                assertThat(found.text())
                    .contains(
                        "swings with 1.00e+06 rad/s", "6e+07 steps", "followed by every method")
                    .doesNotContain("use integrator"));
  }

  @Test
  void implicitIntegratorIsNotWarnedOf() {
    assertThat(forecast(with(scene("spring_1e12_far_over_critical"), "ode15s"))).isEmpty();
  }

  @Test
  void everydaySceneIsNotWarnedOf() {
    assertThat(forecast(with(scene("spring_1e-3_undamped"), "ode113"))).isEmpty();
    assertThat(forecast(with(scene("fourbars_in_row"), "DE"))).isEmpty();
  }
}
