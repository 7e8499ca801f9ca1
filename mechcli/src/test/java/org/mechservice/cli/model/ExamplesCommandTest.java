package org.mechservice.cli.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.cli.Mech;
import org.mechservice.cli.shell.ExitStatus;

class ExamplesCommandTest {
  private static final Path EXAMPLES = Path.of("../examples");

  private final Path folder;
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  ExamplesCommandTest(@TempDir Path folder) {
    this.folder = folder;
  }

  private int mech(String... arguments) {
    return Mech.run(new PrintWriter(out), new PrintWriter(err), arguments);
  }

  @Test
  void everyExampleIsListedByTheHeadingOfItsPage() throws IOException {
    assertThat(mech("examples")).isEqualTo(ExitStatus.DONE);
    try (Stream<Path> folders = Files.list(EXAMPLES)) {
      for (Path example :
          folders.filter(file -> Files.exists(file.resolve("README.md"))).toList()) {
        String heading = Files.readAllLines(example.resolve("README.md")).get(0).substring(2);
        assertThat(out.toString().lines())
            .anyMatch(
                line -> line.startsWith(example.getFileName() + " ") && line.endsWith(heading));
      }
    }
    assertThat(out.toString()).doesNotContain("target").doesNotContain("src ");
  }

  @Test
  void copyHasEveryFileOfTheExample() throws IOException {
    Path copy = folder.resolve("mine");
    assertThat(mech("examples", "pendulum", "-o", copy.toString())).isEqualTo(ExitStatus.DONE);
    Path original = EXAMPLES.resolve("pendulum");
    try (Stream<Path> files = Files.walk(original)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        assertThat(copy.resolve(original.relativize(file).toString())).hasSameBinaryContentAs(file);
      }
    }
    assertThat(out.toString()).contains("README.md");
  }

  @Test
  void nothingIsOverwritten() throws IOException {
    Path mine = Files.writeString(folder.resolve("mine"), "mine");
    assertThat(mech("examples", "pendulum", "-o", mine.toString())).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).contains("S-046").contains("exists").contains("-o DIR");
    assertThat(mine).hasContent("mine");
  }

  @Test
  void placeThatCannotBeWrittenIsNamed() throws IOException {
    Path file = Files.writeString(folder.resolve("file"), "");
    assertThat(mech("examples", "sweep", "-o", file.resolve("copy").toString()))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).contains("S-042").contains("copy");
  }

  @Test
  void unknownNameIsAnsweredWithAllNames() {
    assertThat(mech("examples", "pendulums")).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).contains("S-041").contains("pendulum, robot");
  }

  @Test
  void folderWithoutAnExampleIsRefused() {
    assertThat(mech("examples", "-o", "mine")).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).contains("S-041").contains("mech examples NAME -o DIR");
  }
}
