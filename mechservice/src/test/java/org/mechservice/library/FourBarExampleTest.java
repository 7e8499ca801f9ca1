package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.program.Trajectory;

/** The four-bar in few lines moves as the one in many does. */
class FourBarExampleTest {
  private static final Path FOLDER = Path.of("..", "examples", "four-bar");

  @Test
  void shortFormHasAtMost25Lines() throws Exception {
    assertThat(Files.readAllLines(FOLDER.resolve("four-bar.xml"))).hasSizeLessThanOrEqualTo(25);
  }

  /**
   * The long form has other frames, so its angles count from elsewhere. The crank turns three times
   * in two seconds, and both runs keep to 1e-12: ten digits are equal.
   */
  @Test
  void shortFormMovesAsTheLongForm() throws Exception {
    Trajectory brief = run("four-bar.xml");
    Trajectory full = run("long-form.xml");
    for (String column : new String[] {"A.q", "B.q", "C.q", "A.v", "B.v", "C.v"}) {
      double[] a = brief.column(column);
      double[] b = full.column(column);
      assertThat(a).hasSize(201).hasSameSizeAs(b);
      for (int i = 0; i < a.length; i++) {
        assertThat(a[i] - a[0]).as(column).isCloseTo(b[i] - b[0], within(1e-9));
      }
    }
    assertThat(brief.column("A.q")[200]).isGreaterThan(6 * Math.PI);
  }

  private static Trajectory run(String file) throws Exception {
    return MechModel.read(FOLDER.resolve(file)).tolerances(1e-12, 1e-13).simulate();
  }
}
