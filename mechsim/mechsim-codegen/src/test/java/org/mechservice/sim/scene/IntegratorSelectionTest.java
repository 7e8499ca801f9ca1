package org.mechservice.sim.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;

/** The automatic integrator goes by what of the spectrum at the start will last. */
class IntegratorSelectionTest {
  private static final Path EXAMPLES = Path.of("../../examples");

  private static String scene(String path) throws IOException {
    return Files.readString(EXAMPLES.resolve(path + ".xml"), StandardCharsets.UTF_8);
  }

  private static IntegratorSelection choice(String formulation, String text)
      throws MechmlException {
    MechmlModel model = MechmlReader.read("scene.xml", text.getBytes(StandardCharsets.UTF_8));
    return IntegratorSelection.of(formulation, model.mechanism(), model.settings().run());
  }

  @ParameterizedTest
  @CsvSource({
    "extremes/spring_1e12_far_over_critical, 2.00e+08",
    "extremes/spring_1e6_far_over_critical, 1.00e+09",
    "extremes/stiff_1e9_c1e5, 8.87e+04"
  })
  void motionThatDiesAwayFastTakesAnImplicitMethodFromTheStart(String path, String rate)
      throws Exception {
    IntegratorSelection choice = choice("auto", scene(path));
    assertThat(choice.integrator()).isEqualTo("ode15s");
    assertThat(choice.reason()).hasValueSatisfying(why -> assertThat(why).contains(rate + " 1/s"));
  }

  /** 41 velocities, the fastest damped with 2.2e4 1/s over a quarter of a second. */
  @Test
  void largeStiffTreeTakesTheResidualFormUnlessAnotherIsAskedFor() throws Exception {
    String driver = scene("driver/variants/driver-ck100-elements");
    assertThat(choice("auto", driver).integrator()).isEqualTo("ode15sR");
    assertThat(choice("DTR", driver).integrator()).isEqualTo("ode15s");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "driver/variants/driver-c0-elements",
        "extremes/spring_1e12_undamped",
        "extremes/friction_at_rest",
        "extremes/impact_1e9_damped",
        "extremes/rtol_1e-2",
        "extremes/fourbar_redundant",
        "pendulum/pendulum"
      })
  void whatSwingsOrMayCeaseOrIsSlowIsFoundOutAlongTheRun(String path) throws Exception {
    IntegratorSelection choice = choice("auto", scene(path));
    assertThat(choice.integrator()).isEqualTo("switching");
    assertThat(choice.reason()).isEmpty();
  }

  /** A drive as stiff holds all along if it is linear in its coordinate, whatever it follows. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "1e6*(0.3*sin(2*t) - j1.q) - 1e5*j1.v | ode15s",
        "-(1e5/2)*j1.v*2 + 3 | ode15s",
        "-1e5*j1.v*smoothStep(t) | switching",
        "-1e5*j1.v*abs(j1.v) - 1e5*j1.v | switching",
        "-1e5*bar1.p2.vz | switching",
        "5*sin(t) | switching"
      })
  void driveTakesAnImplicitMethodFromTheStartIfItIsLinear(String force, String integrator)
      throws Exception {
    String driven =
        scene("pendulum/pendulum")
            .replace(
                "</Forces>",
                "<jointForce name=\"m\" joint=\"j1\" expression=\"" + force + "\"/></Forces>");
    assertThat(choice("auto", driven).integrator()).isEqualTo(integrator);
  }

  @Test
  void residualFormulationsHaveOneIntegrator() throws Exception {
    assertThat(choice("RR", scene("pendulum/pendulum")).integrator()).isEqualTo("ode15sR");
  }
}
