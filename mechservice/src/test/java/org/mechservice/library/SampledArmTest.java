package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.program.Trajectory;

/**
 * The robot arm of the examples against its reference, which is computed by closed equations of
 * motion and the recursion of the controllers (examples/sampled-arm/reference.py).
 */
class SampledArmTest {
  private static final Path FOLDER = Path.of("../examples/sampled-arm");

  /**
   * The tolerances of the file are 1e-10. Torques follow rates with a gain of 45/(0.01 + 0.005),
   * which amplifies their errors.
   */
  @ParameterizedTest
  @CsvSource({"DTR, 1e-9, 1e-6", "DSR, 1e-9, 1e-6"})
  void armFollowsTheReference(String formulation, double ofAngles, double ofTorques)
      throws Exception {
    Trajectory rows = MechModel.read(FOLDER.resolve("arm.xml")).formulation(formulation).simulate();
    List<String> reference = Files.readAllLines(FOLDER.resolve("reference.csv"));
    String[] names = reference.get(0).split(",", -1);
    assertThat(rows.rows()).isEqualTo(reference.size() - 1);
    for (int c = 1; c < names.length; c++) {
      double[] column = rows.column(names[c]);
      double bound = names[c].endsWith(".q") ? ofAngles : ofTorques;
      for (int i = 0; i < column.length; i++) {
        double expected = Double.parseDouble(reference.get(i + 1).split(",", -1)[c]);
        assertThat(column[i]).as(names[c] + " in row " + i).isCloseTo(expected, within(bound));
      }
    }
    assertThat(rows.column("torque1")).contains(75);
    assertThat(rows.column("torque2")).contains(-25);
  }
}
