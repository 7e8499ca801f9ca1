package org.mechservice.sim.scene.forecast;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.scene.Finding;
import org.mechservice.solver.catalogue.MessageCode;

/** What makes a run endless is told before it, with the part it lies in. */
@Tag("slow")
class RunForecastTest {
  private static final Path EXTREMES = Path.of("../../examples/extremes");

  private static String scene(String name) throws IOException {
    return Files.readString(EXTREMES.resolve(name + ".xml"), StandardCharsets.UTF_8);
  }

  private static List<Finding> of(String text) throws MechmlException {
    MechmlModel model = MechmlReader.read("scene.xml", text.getBytes(StandardCharsets.UTF_8));
    return RunForecast.of(model, "auto", "auto", model.settings().run());
  }

  private static List<Finding> ofPush(String formula) throws IOException, MechmlException {
    return of(scene("brief_push").replace("1000*exp(-((t-5)/0.001)^2)", formula));
  }

  @ParameterizedTest
  @CsvSource({
    "sin(1e9*t), N-019, turns 1.00e+09 rad/s",
    "sin(1e9*t), N-019, sin(1.0E9*t) in force",
    "sin(1e9*t), N-019, once in 6.28e-09 s",
    "2*cos(3-1e6*t)^2, N-019, turns 1.00e+06 rad/s",
    "floor(1e7*t), N-019, jumps 1.00e+07 times a second",
    "-signum(s.v), N-028, jumps with signum of a velocity",
    "-5*step(-s.v+0.1), N-028, jumps with step of a velocity"
  })
  void formulaThatKeepsStepsTinyIsNamedByItsForce(String formula, String code, String what)
      throws Exception {
    assertThat(ofPush(formula))
        .filteredOn(finding -> finding.text().contains("force \"pull\""))
        .singleElement()
        .satisfies(finding -> assertThat(finding.code()).hasToString(code))
        .satisfies(finding -> assertThat(finding.text()).contains(what))
        .satisfies(finding -> assertThat(finding.origin().line()).isPositive());
  }

  /** floor(20000 t²) changes two million times up to t = 10 s, though at the start not at all. */
  @Test
  void changesTooManyToBeKnownAreTold() throws Exception {
    assertThat(ofPush("floor(20000*t*t)"))
        .singleElement()
        .satisfies(finding -> assertThat(finding.code()).isEqualTo(MessageCode.VERY_MANY_STEPS))
        .satisfies(finding -> assertThat(finding.text()).contains("more than 1000000 times"));
  }

  /** Every step may end where the sine has the same value. */
  @ParameterizedTest
  @CsvSource({"0.0004, false", "0.001, true"})
  void largestStepLongerThanHalfAPeriodIsNamed(String longest, boolean named) throws Exception {
    String bounded =
        scene("brief_push")
            .replace("1000*exp(-((t-5)/0.001)^2)", "sin(2*PI*1000*t)")
            .replaceFirst("maxStep=\"[^\"]*", "maxStep=\"" + longest);
    assertThat(of(bounded).stream().anyMatch(f -> f.text().contains("maxStep allows 0.00100 s")))
        .isEqualTo(named);
  }

  @ParameterizedTest
  @ValueSource(strings = {"sin(100*t)", "cos(1e9*s.q)", "signum(t-3)", "1+tanh(s.v/0.001)"})
  void everydayFormulaIsNot(String formula) throws Exception {
    assertThat(ofPush(formula)).isEmpty();
  }

  /** The force of a muscle by its rate is of pieces that join with their slopes. */
  @Test
  void pullOfAMuscleDoesNotJump() throws Exception {
    Path muscle = Path.of("../../examples/elements/muscle.xml");
    assertThat(of(Files.readString(muscle, StandardCharsets.UTF_8)))
        .extracting(Finding::code)
        .doesNotContain(MessageCode.FORCE_JUMPS_WITH_VELOCITY);
  }

  /** Half of 1e5 rad/s over 100 s: 5e6 rad. */
  @Test
  void spinOfEulerParametersIsForeseen() throws Exception {
    String longer = scene("high_spin_1e5_sym").replaceFirst("tend=\"[^\"]*", "tend=\"100");
    assertThat(of(longer))
        .singleElement()
        .satisfies(finding -> assertThat(finding.code()).isEqualTo(MessageCode.VERY_MANY_STEPS))
        .satisfies(finding -> assertThat(finding.text()).contains("5e+06 steps"));
    assertThat(of(scene("high_spin_1e5_sym"))).isEmpty();
  }

  /** What swings undamped limits implicit methods too; steps counted over 0.01 s, times 1000. */
  @ParameterizedTest
  @CsvSource({"auto, 6e+07", "ode113, 6e+07", "ode15s, 4e+08"})
  void undampedOscillationIsForeseenForEveryIntegrator(String integrator, String counted)
      throws Exception {
    String longer =
        scene("spring_1e12_undamped")
            .replaceFirst("tend=\"[^\"]*", "tend=\"10")
            .replaceFirst("integrator name=\"\\w+\"", "integrator name=\"" + integrator + "\"");
    assertThat(of(longer))
        .singleElement()
        .satisfies(finding -> assertThat(finding.text()).contains(counted + " steps"));
  }
}
