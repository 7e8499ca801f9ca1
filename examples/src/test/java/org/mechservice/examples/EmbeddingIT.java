package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.solver.api.Model;

/** A model's class in a program that knows nothing of the service. */
class EmbeddingIT {
  @TempDir Path directory;

  /** The reference has the angles at 0.5 s in its second row. */
  @Test
  void aProgramOfTheUsersOwnIntegratesThePendulum() throws Exception {
    Terminal terminal = new Terminal(directory);
    terminal.mech("build", WorkingTree.PENDULUM.toString(), "-o", "p.jar").orFail();
    Path solver = Path.of(Model.class.getProtectionDomain().getCodeSource().getLocation().toURI());

    List<String> printed =
        terminal
            .run(
                "java",
                "-cp",
                solver + File.pathSeparator + directory.resolve("p.jar"),
                WorkingTree.TOP.resolve("examples/embedding/Embedding.java").toString(),
                "org.mechservice.model.FiveBarPendulum",
                "0.5",
                "500")
            .orFail()
            .stdout()
            .lines()
            .toList();

    Path reference = WorkingTree.TOP.resolve("examples/pendulum/reference.csv");
    String[] expected = Files.readAllLines(reference).get(2).split(",", -1);
    assertThat(Double.parseDouble(expected[0])).isEqualTo(0.5);
    for (int i = 0; i < 5; i++) {
      String[] line = printed.get(i).split(" ", -1);
      assertThat(line[0]).isEqualTo("j" + (i + 1) + ".q");
      // Fourth order: rates of some 1/s and steps of 1 ms leave less than 1e-10.
      assertThat(Double.parseDouble(line[1]))
          .isCloseTo(Double.parseDouble(expected[i + 1]), within(1e-10));
    }
  }
}
