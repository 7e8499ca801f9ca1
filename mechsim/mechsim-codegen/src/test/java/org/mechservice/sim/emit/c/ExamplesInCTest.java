package org.mechservice.sim.emit.c;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.text.ModelFiles;

/** Every model of the examples leaves as C, or is refused by name with what to do. */
@Tag("soak")
class ExamplesInCTest {
  private static final Path EXAMPLES = Path.of("..", "..", "examples");

  private static List<Path> files() throws IOException {
    try (Stream<Path> files = Files.walk(EXAMPLES)) {
      return files
          .filter(file -> file.toString().endsWith(".xml"))
          .filter(file -> !file.toString().contains("target"))
          .sorted()
          .toList();
    }
  }

  /** Some files are parts of models, others are made to be refused: most are models. */
  static List<Named<MechmlModel>> models() throws Exception {
    List<Named<MechmlModel>> models = new ArrayList<>();
    for (Path file : files()) {
      model(file)
          .ifPresent(model -> models.add(Named.of(EXAMPLES.relativize(file).toString(), model)));
    }
    assertThat(models).hasSizeGreaterThan(files().size() * 9 / 10);
    return models;
  }

  /** Returns the model of a file; none if the file is no model. */
  private static Optional<MechmlModel> model(Path file) throws Exception {
    byte[] content = Files.readAllBytes(file);
    if (!new String(content, StandardCharsets.UTF_8).contains("<MBSmodel")) {
      return Optional.empty();
    }
    try {
      return Optional.of(
          MechmlReader.read(
              String.valueOf(file.getFileName()),
              ModelFiles.inlined(content, file),
              ReadOptions.NONE.withInputsAsParameters()));
    } catch (MechmlException e) {
      return Optional.empty();
    }
  }

  @ParameterizedTest
  @MethodSource("models")
  void leavesAsCOrIsRefusedByName(MechmlModel model) throws Exception {
    BuildOptions options =
        new BuildOptions("auto", EnumSet.of(ColumnGroup.ENERGY), model.settings().run());
    try {
      assertThat(ModelFactory.inC(model, options).files()).isNotEmpty();
    } catch (ModelBuildException e) {
      // those that run nowhere have the codes of a run
      assertThat(e)
          .hasMessageMatching("(S-170 .*no C code is generated for|S-092 |N-031 )(.|\\n)*");
    }
  }
}
