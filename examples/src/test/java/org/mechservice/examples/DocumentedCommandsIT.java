package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The commands in the pages work. */
class DocumentedCommandsIT {
  private static final String TEST_COMMAND = "mvn verify";

  @TempDir Path directory;

  @AfterEach
  void tidyUp() throws IOException {
    WorkingTree.unmirror(directory);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "README.md",
        "docs/first-steps.md",
        "docs/curves.md",
        "docs/fmu.md",
        "docs/clearance.md",
        "docs/gradients.md",
        "docs/study.md",
        "docs/optimise.md",
        "docs/view.md",
        "docs/how-to/pendulum.md",
        "docs/how-to/four-bar.md",
        "docs/how-to/quarter-car.md",
        "docs/how-to/robot.md",
        "docs/how-to/from-urdf.md",
        "docs/how-to/transmissions.md",
        "docs/how-to/contact.md",
        "docs/how-to/stiff-bushings.md",
        "docs/how-to/optimum.md",
        "docs/how-to/server.md",
        "examples/embedding/README.md",
        "examples/pendulum/README.md",
        "examples/robot/README.md",
        "examples/sampled-arm/README.md",
        "examples/elements/README.md",
        "examples/four-bar/README.md",
        "examples/gearbox/README.md",
        "examples/counterbalance/README.md",
        "examples/crane/README.md",
        "examples/half-car/README.md",
        "examples/walker/README.md",
        "examples/sweep/README.md"
      })
  void everyCommandOfThePageWorks(String page) throws IOException {
    WorkingTree.mirrorIn(directory);
    Terminal terminal = new Terminal(directory);
    List<String> commands = Documentation.commandsOf(WorkingTree.TOP.resolve(page));

    assertThat(commands).isNotEmpty();
    for (String command : commands) {
      // This test is part of the test command.
      if (!command.equals(TEST_COMMAND)) {
        terminal.shell(command).orFail();
      }
    }
  }

  private static boolean hasProgram(String name) {
    return Stream.of(System.getenv().getOrDefault("PATH", "").split(File.pathSeparator, -1))
        .anyMatch(folder -> new File(folder, name).canExecute());
  }

  @Test
  void everyCommandOfThePageOnCWorks() throws IOException {
    assumeTrue(hasProgram("cc"), "this machine has no C compiler (cc)");
    everyCommandOfThePageWorks("docs/c.md");
  }

  @Test
  void everyCommandOfThePageOnWebAssemblyWorks() throws IOException {
    assumeTrue(
        hasProgram("zig") || (hasProgram("clang") && hasProgram("wasm-ld")),
        "this machine has no compiler for WebAssembly (clang with lld, or zig)");
    everyCommandOfThePageWorks("docs/wasm.md");
  }

  @Test
  void readmeAndContinuousIntegrationTestTheSameWay() throws IOException {
    assertThat(Documentation.commandsOf(WorkingTree.TOP.resolve("README.md")))
        .contains(TEST_COMMAND);
    assertThat(Files.readAllLines(WorkingTree.TOP.resolve(".ci/run")))
        .anyMatch(line -> line.strip().startsWith(TEST_COMMAND));
  }
}
