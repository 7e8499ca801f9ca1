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
import org.mechservice.sim.scene.forecast.StiffnessForecast;

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

  /**
   * A preloaded spring of 2e12 N/m on the tip of two hinged bars: at the start one motion swings
   * with 2.2e6 rad/s, and the preload moves another away with ±3.1e6 1/s, as a buckling column.
   * Nothing decays: there is no damper. Steps counted over 0.01 s: 381 369 by ode113, 1 315 598 by
   * ode15s, twelve and forty times one for each radian at the start.
   */
  @ParameterizedTest
  @CsvSource({"auto, 1e+09", "ode113, 1e+09", "ode15s, 4e+09"})
  void whatThePreloadOfASpringMovesAwayDoesNotDecay(String integrator, String counted)
      throws Exception {
    String text = preloaded();
    assertThat(choice("auto", text).integrator()).isEqualTo("switching");
    MechmlModel model = MechmlReader.read("scene.xml", text.getBytes(StandardCharsets.UTF_8));
    assertThat(StiffnessForecast.of(model, model.settings().run().withIntegrator(integrator)))
        .hasValueSatisfying(
            found ->
                assertThat(found.text())
                    .contains("moves away with 3.08e+06 1/s", counted + " steps", "every method"));
  }

  private static String preloaded() {
    String bar =
        """
        <body name="%s"><point name="p1" x="0" y="0" z="0"/><point name="p2" x="1" y="0" z="0"/>
          <vector name="y" vx="0" vy="1" vz="0"/><cog x="0.5" y="0" z="0"/><mass value="1"/>
          <inertiaTensor Ixx="0" Iyy="1/12" Izz="1/12"/></body>
        """;
    return """
        <!DOCTYPE MechML SYSTEM "MechML.dtd">
        <MechML><MBSsimulation><dynamic><timeSet tini="0" tend="30" tstep="0.01"/>
          <integrator name="auto" relTol="1e-6" absTol="1e-9"/></dynamic></MBSsimulation>
        <MBSmodel name="preloaded" massUnits="kg" lengthUnits="m"><Bodies>
          <body name="Ground"><point name="p1" x="0" y="0" z="0"/>
            <point name="a" x="1.3" y="0" z="1.1"/><vector name="y" vx="0" vy="1" vz="0"/></body>
        """
        + bar.formatted("b0")
        + bar.formatted("b1")
        + """
        </Bodies><Joints>
          <joint name="j0" type="R"><body1 name="Ground" point="p1" vector="y"/>
            <body2 name="b0" point="p1" vector="y"/></joint>
          <joint name="j1" type="R"><body1 name="b0" point="p2" vector="y"/>
            <body2 name="b1" point="p1" vector="y"/></joint>
        </Joints><Forces><springDamper name="s" k="2e12" length0="1">
          <body1 name="Ground" point="a"/><body2 name="b1" point="p2"/></springDamper></Forces>
        <topology><root name="Ground"/><relCoorVals><jointVal name="j0" posVals="0.3" velVals="0"/>
          <jointVal name="j1" posVals="0.5" velVals="0"/></relCoorVals></topology>
        </MBSmodel></MechML>
        """;
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
