package org.mechservice.report.solution;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.report.PlanarPendulum;

class ReferenceFileTest {
  private static final RunGrid GRID = RunGrid.uniform(0.1, 1.1, 3);
  private static final double THIRD = 1.0 / 3;

  @TempDir Path folder;

  private ReferenceFile file(String purpose) {
    Path file = folder.resolve("planar-reference.csv");
    return new ReferenceFile(file, purpose, new PlanarPendulum(0).description());
  }

  private static Reference reference(Optional<double[]> amplification, List<Double> jumps) {
    return new Reference(
        new double[] {0.1, 0.1 + THIRD},
        new double[][] {{1, 0}, {Math.PI, -THIRD}},
        new double[] {0, 1e-13 * THIRD},
        new double[] {0, Math.ulp(THIRD)},
        amplification,
        jumps,
        List.of("Made by hand.", "Checked, by nobody; twice."));
  }

  private void assertKept(Reference reference) throws IOException {
    file("this model").write(reference, GRID);
    ReferenceFile.Kept kept = file("this model").read().orElseThrow();
    assertThat(kept.grid()).isEqualTo(GRID);
    assertThat(kept.reference()).usingRecursiveComparison().isEqualTo(reference);
  }

  @Test
  void referenceIsKeptToEveryDigitWithWhatIsSaidOfIt() throws IOException {
    assertKept(reference(Optional.of(new double[] {1, 10 * THIRD}), List.of(0.2, 0.7 * THIRD)));
  }

  @Test
  void amplificationThatIsNotKnownStaysSo() throws IOException {
    assertKept(reference(Optional.empty(), List.of()));
  }

  @Test
  void referenceOfAnotherPurposeIsNone() throws IOException {
    assertThat(file("this model").read()).isEmpty();
    file("this model").write(reference(Optional.empty(), List.of()), GRID);
    assertThat(file("this model, changed").read()).isEmpty();
  }

  @Test
  void fileIsATableWithNamesAboveItsColumns() throws IOException {
    file("this model").write(reference(Optional.empty(), List.of()), GRID);
    assertThat(Files.readAllLines(folder.resolve("planar-reference.csv")))
        .contains("t,floor,rounding,amplification,pin.q,pin.v", "0.1,0.0,0.0,NaN,1.0,0.0");
    assertThat(folder).isDirectoryNotContaining("glob:**.new");
  }
}
