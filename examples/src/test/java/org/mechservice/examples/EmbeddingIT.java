package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A model's class in a program without the service. */
class EmbeddingIT {
  @TempDir Path directory;

  /** The reference has the angles at 0.5 s in its second row. */
  @Test
  void aProgramOfTheUsersOwnIntegratesThePendulum() throws Exception {
    List<String> printed = run(WorkingTree.PENDULUM, "FiveBarPendulum", "0.5", "500");

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

  /**
   * A force of t newtons on 1 kg: t³/6 m, which a method of fourth order reproduces to rounding.
   */
  @Test
  void timeAndClassesOfUsersAreForTheProgramAsForTheService() throws Exception {
    List<String> printed = run(element("force"), "forceWithData", "0.5", "50");
    assertThat(printed.get(0)).startsWith("slide.q ");
    assertThat(number(printed.get(0))).isCloseTo(0.125 / 6, within(1e-15));
  }

  /** Events and tunable parameters are data beside the code. */
  @Test
  void aModelWithDataBesideItsCodeIsAModelToo() throws Exception {
    List<String> printed = run(element("event"), "eventWithData", "0.5", "50");
    // From 4.905 m: g t²/2 down.
    assertThat(number(printed.get(0))).isCloseTo(4.905 - 9.81 / 8, within(1e-12));
  }

  private static double number(String line) {
    return Double.parseDouble(line.substring(line.indexOf(' ') + 1));
  }

  /** Returns the class path of the solver, as the page gives it. */
  private static String solver() {
    return Stream.of(
            "solver-api", "solver-ode", "solver-symbol", "solver-mechanics", "solver-runtime")
        .map(module -> WorkingTree.TOP.resolve("solver-core").resolve(module) + "/target/*")
        .collect(Collectors.joining(File.pathSeparator));
  }

  private static Path element(String name) {
    return WorkingTree.TOP.resolve("examples/elements").resolve(name + ".xml");
  }

  private List<String> run(Path scene, String model, String end, String steps) throws Exception {
    Terminal terminal = new Terminal(directory);
    String trusted = scene.resolveSibling(".").toString();
    terminal.mech("build", scene.toString(), "--user-code", trusted, "-o", "p.jar").orFail();
    return terminal
        .run(
            "java",
            "-cp",
            solver() + File.pathSeparator + directory.resolve("p.jar"),
            WorkingTree.TOP.resolve("examples/embedding/Embedding.java").toString(),
            "org.mechservice.model." + model,
            end,
            steps)
        .orFail()
        .stdout()
        .lines()
        .toList();
  }
}
