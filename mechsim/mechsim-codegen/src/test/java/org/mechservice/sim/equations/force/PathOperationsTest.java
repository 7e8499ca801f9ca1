package org.mechservice.sim.equations.force;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.equations.ArticulatedBodyEquations;
import org.mechservice.solver.links.Links;

/** How many operations forces along paths over shapes take. */
class PathOperationsTest {
  /**
   * Slopes by one coordinate of a point after the other took 906 and 1354 operations, and 340 800
   * for a hand with 39 muscles, of which one sweep back leaves 202 064.
   */
  @ParameterizedTest
  @CsvSource({"muscle, 788", "pathForce, 1129"})
  void slopesOfALongPathComeFromOneSweep(String name, int most) throws Exception {
    Path file = Path.of("../../examples/elements", name + ".xml");
    byte[] text = Files.readString(file, StandardCharsets.UTF_8).getBytes(StandardCharsets.UTF_8);
    Links links = Links.of(MechmlReader.read(name, text).mechanism());
    assertThat(ArticulatedBodyEquations.derive(links).operationCount()).isLessThanOrEqualTo(most);
  }
}
