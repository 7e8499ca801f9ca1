package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.program.Trajectory;

/** Models that name files beside them. */
class FilesOfModelTest {
  private static final Path ELEMENTS = Path.of("..", "examples", "elements");

  @TempDir private Path folder = Path.of("");

  private void copy(String... names) throws IOException {
    for (String name : names) {
      Files.copy(ELEMENTS.resolve(name), folder.resolve(name));
    }
  }

  /** Each use of the file has its own stiffness and start: x0 cos(sqrt(k/m) t) at 1 s. */
  @Test
  void usesOfOneFileMoveByTheirOwnParameters() throws Exception {
    Trajectory run = MechModel.read(ELEMENTS.resolve("include.xml")).simulate();
    // The tolerances of the file are 1e-9 and 1e-11, over three radians.
    assertThat(last(run, "left_slide.q")).isCloseTo(0.1 * Math.cos(2), within(1e-8));
    assertThat(last(run, "right_slide.q")).isCloseTo(0.2 * Math.cos(3), within(1e-8));
  }

  /** The text that travels is the model: it needs no file, and the bits are the same. */
  @Test
  void textThatTravelsHasTheSameBits() throws Exception {
    Trajectory fromFolder = MechModel.read(ELEMENTS.resolve("include.xml")).simulate();
    Trajectory fromText =
        MechModel.of("included.xml", Files.readString(ELEMENTS.resolve("included.xml"))).simulate();
    assertThat(fromText.column("left_slide.q")).isEqualTo(fromFolder.column("left_slide.q"));
    assertThat(fromText.column("right_slide.v")).isEqualTo(fromFolder.column("right_slide.v"));
  }

  @Test
  void parameterOfOneUseIsSetByItsPrefixedName() throws Exception {
    Trajectory run = MechModel.read(ELEMENTS.resolve("include.xml")).set("left_k", 16).simulate();
    assertThat(last(run, "left_slide.q")).isCloseTo(0.1 * Math.cos(4), within(1e-8));
  }

  @Test
  void changeOfAnIncludedFileIsAnotherModel() throws Exception {
    copy("include.xml", "oscillator.part");
    String before = MechModel.read(folder.resolve("include.xml")).sha256();
    Files.writeString(
        folder.resolve("oscillator.part"),
        Files.readString(folder.resolve("oscillator.part")).replace("mass=\"1\"", "mass=\"4\""));
    MechModel heavier = MechModel.read(folder.resolve("include.xml"));
    assertThat(heavier.sha256()).isNotEqualTo(before);
    assertThat(last(heavier.simulate(), "left_slide.q")).isCloseTo(0.1 * Math.cos(1), within(1e-8));
  }

  @Test
  void blockFromAFileTurnsAsABlockOfNumbers() throws Exception {
    Trajectory run = MechModel.read(ELEMENTS.resolve("mesh.xml")).simulate();
    double m = 0.648 + 0.5;
    double inertia = m * (0.1 * 0.1 + 0.06 * 0.06) / 3;
    assertThat(last(run, "turn.q")).isCloseTo(0.001 / inertia / 2, within(1e-9));
  }

  @Test
  void fileThatIsMissingIsNamed() throws IOException {
    copy("include.xml");
    assertThatThrownBy(() -> MechModel.read(folder.resolve("include.xml")))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("oscillator.part");
    assertThatThrownBy(
            () -> MechModel.of("model.xml", Files.readString(ELEMENTS.resolve("include.xml"))))
        .isInstanceOf(MechmlException.class)
        .hasMessageContaining("M-075")
        .hasMessageContaining("not read from a folder");
  }

  private static double last(Trajectory rows, String column) {
    double[] values = rows.column(column);
    return values[values.length - 1];
  }
}
