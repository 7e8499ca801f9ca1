package org.mechservice.sim.equations.loop;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.scene.ModelBuildException;

/** Loops that no start closes: the refusal names the constraint and what holds it open. */
class OpenLoopsTest {
  private static MechmlModel model(String... replacements) throws Exception {
    String text =
        Files.readString(
            Path.of("../../examples/extremes/parallelogram_through_line.xml"),
            StandardCharsets.UTF_8);
    for (int i = 0; i < replacements.length; i += 2) {
      text = text.replace(replacements[i], replacements[i + 1]);
    }
    return MechmlReader.read("scene.xml", text.getBytes(StandardCharsets.UTF_8));
  }

  private static void assertRefused(MechmlModel model, String part, String way) {
    BuildOptions options = new BuildOptions("auto", Set.of(), model.settings().run());
    assertThatThrownBy(() -> ModelFactory.generate(model, options))
        .isInstanceOf(ModelBuildException.class)
        .hasMessageContaining("S-092")
        .hasMessageContaining(part)
        .hasMessageContaining(way);
  }

  @Test
  void contradictoryMotionsAreNamedAsWhatHoldsTheLoopOpen() throws Exception {
    MechmlModel model =
        model(
            "name=\"j_left\" posVals=\"-0.5\" velVals=\"6\"",
            "name=\"j_left\" driven=\"t - 0.5\"",
            "name=\"j_right\" posVals=\"-0.5\" velVals=\"6\"",
            "name=\"j_right\" driven=\"t + 0.5\"");
    assertRefused(
        model, "\"coupler\"", "let joints move that are driven or fixed: \"j_left\", \"j_right\".");
  }

  @Test
  void lengthsThatNeverFitAreToBeChecked() throws Exception {
    assertRefused(
        model("dist=\"3\"", "dist=\"30\""),
        "\"coupler\"",
        "Check the lengths in this loop, and start");
  }
}
