package org.mechservice.sim.scene.forecast;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.scene.Finding;
import org.mechservice.solver.catalogue.MessageCode;

/** What an integrator cannot know of before it has passed over it is told before the run. */
class ShortPulseCheckTest {
  private static final Path SCENE = Path.of("../../examples/extremes/brief_push.xml");
  private static final String PUSH = "1000*exp(-((t-5)/0.001)^2)";

  private static Optional<Finding> of(String formula, String maxStep)
      throws IOException, MechmlException {
    String text =
        Files.readString(SCENE, StandardCharsets.UTF_8)
            .replace(PUSH, formula)
            .replace(" maxStep=\"0.0005\"", maxStep);
    MechmlModel model = MechmlReader.read("scene.xml", text.getBytes(StandardCharsets.UTF_8));
    return ShortPulseCheck.of(model.mechanism(), model.settings().run());
  }

  @Test
  void briefPushIsToldWithItsJointItsTimeAndAStepThatSeesIt() throws Exception {
    assertThat(of(PUSH, ""))
        .hasValueSatisfying(
            found -> {
              assertThat(found.code()).isEqualTo(MessageCode.SHORT_PULSE);
              assertThat(found.text())
                  .contains("joint \"s\"", "first at t = 4.998", "a maxStep of 1.5e-03 s");
            });
  }

  @Test
  void boundedStepsSeeIt() throws Exception {
    assertThat(of(PUSH, " maxStep=\"0.0005\"")).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "1000*(step(t-5)-step(t-5.001))",
        "sin(100*t)",
        "1000*exp(-((t-5)/1)^2)",
        "1000*exp(-s.q^2)",
        "3"
      })
  void whatLastsOrReturnsOrBeginsAtAKnownTimeIsNot(String formula) throws Exception {
    assertThat(of(formula, "")).isEmpty();
  }

  private static Optional<Finding> of(String scene) throws MechmlException {
    MechmlModel model = MechmlReader.read("scene.xml", scene.getBytes(StandardCharsets.UTF_8));
    return ShortPulseCheck.of(model.mechanism(), model.settings().run());
  }

  @Test
  void driveThatMovesForAShortWhileIsToldByTheJointItPushes() throws Exception {
    String still = Files.readString(Path.of("../../examples/extremes/kinked_drive.xml"));
    assertThat(of(still)).isEmpty();
    String jerk = still.replaceAll("driven=\"[^\"]*\"", "driven=\"tanh((t-0.5)*5000)\"");
    assertThat(of(jerk))
        .hasValueSatisfying(found -> assertThat(found.text()).contains("first at t = 0.49"));
    String declared = still.replaceAll("driven=\"[^\"]*\"", "driven=\"smoothStep((t-0.5)*5000)\"");
    assertThat(of(declared)).isEmpty();
  }

  @Test
  void pushIntoLoopsIsTold() throws Exception {
    String loops = Files.readString(Path.of("../../examples/extremes/fourbars_in_row.xml"));
    assertThat(of(loops)).isEmpty();
    String push = "<jointForce name=\"push\" joint=\"ja\" expression=\"exp(-((t-0.5)/0.001)^2)\"/>";
    assertThat(of(loops.replace("</Forces>", push + "</Forces>")))
        .hasValueSatisfying(found -> assertThat(found.text()).contains("joint \"ja\""));
  }
}
