package org.mechservice.sim.equations.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.result.ColumnGroup;

/** A spring whose points coincide wherever the joints are, in generated code. */
class CoincidentSpringTest {
  private static final Path SCENE = Path.of("../../examples/extremes/coincident_spring.xml");

  private static MechmlModel model(String length) throws IOException, MechmlException {
    String text = Files.readString(SCENE, StandardCharsets.UTF_8);
    return MechmlReader.read(
        "scene.xml",
        text.replace("length0=\"0.5\"", "length0=\"" + length + "\"")
            .getBytes(StandardCharsets.UTF_8));
  }

  private static BuildOptions options(MechmlModel model) {
    return new BuildOptions("auto", EnumSet.of(ColumnGroup.JOINTS), model.settings().run());
  }

  @Test
  void tensionWithoutDirectionIsRefusedByName() throws Exception {
    MechmlModel model = model("0.5");
    assertThatThrownBy(() -> ModelFactory.generate(model, options(model)))
        .isInstanceOf(ModelBuildException.class)
        .hasMessageContaining("N-031 force \"knot\"");
  }

  @Test
  void springWithoutTensionThereDoesNothing() throws Exception {
    MechmlModel model = model("0");
    ExplicitModel built =
        (ExplicitModel)
            ModelParts.of(
                    ModelFactory.compile(
                            model, options(model), ModelFactory.generate(model, options(model)))
                        .newInstance())
                .equations();
    double[] rate = new double[2];
    assertThat(built.derivative(0, new double[] {0.3, 2}, rate)).isEqualTo(ExplicitModel.REGULAR);
    assertThat(rate).containsExactly(2, 0);
  }
}
