package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Forces that users have written as classes, the paper's way. */
class UserForcesIT {
  private static final Path EXAMPLES = WorkingTree.TOP.resolve("examples");
  private static final String SUSPENSION =
      EXAMPLES.resolve("five-point-suspension/five-point-suspension.xml").toString();

  /** By how much of its relative tolerance an integrator may miss a reference solution. */
  private static final double TOLERANCES = 1000;

  @TempDir private Path directory;

  private void simulate(Path model, String file, String... options) {
    List<String> command = new ArrayList<>(List.of("simulate", model.toString()));
    command.addAll(List.of("--user-code", model.resolveSibling(".").toString(), "--unconfined"));
    command.addAll(List.of("--quiet", "--out", file));
    command.addAll(List.of(options));
    new Terminal(directory).mech(command.toArray(String[]::new)).orFail();
  }

  @CsvSource({
    "five-point-suspension/five-point-suspension.xml, five-point-suspension/reference.csv, DSR, DE",
    "driver/driver-c0.xml, driver/reference-c0.csv, DTR, DE",
    "driver/driver-ck100.xml, driver/reference-ck100.csv, RR-JF, ode15sR"
  })
  @ParameterizedTest
  void scenesOfThePaperMoveAsTheirReferences(
      String model, String reference, String formulation, String integrator) {
    simulate(
        EXAMPLES.resolve(model),
        "r.csv",
        "--formulation",
        formulation,
        "--integrator",
        integrator,
        "--rtol",
        "1e-8",
        "--atol",
        "1e-10");

    assertThat(
            ResultRows.read(directory.resolve("r.csv"))
                .distanceTo(ResultRows.read(EXAMPLES.resolve(reference)), Double.MAX_VALUE))
        .isLessThan(TOLERANCES * 1e-8);
  }

  @Test
  void classesTravelWithTheModel(@TempDir Path empty) {
    simulate(Path.of(SUSPENSION), "remote.csv");
    simulate(Path.of(SUSPENSION), "local.csv", "--mode", "local");
    String trusted = Path.of(SUSPENSION).resolveSibling(".").toString();
    new Terminal(directory)
        .mech("build", SUSPENSION, "--user-code", trusted, "-o", "s.jar", "--standalone")
        .orFail();
    new Terminal(empty)
        .run("java", "-jar", directory.resolve("s.jar").toString(), "--out", "alone.csv")
        .orFail();

    assertThat(directory.resolve("local.csv"))
        .hasSameBinaryContentAs(directory.resolve("remote.csv"));
    assertThat(empty.resolve("alone.csv")).hasSameBinaryContentAs(directory.resolve("remote.csv"));
  }
}
