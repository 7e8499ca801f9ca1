package org.mechservice.mechml;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.text.ModelFiles;

/**
 * No model of the examples has a warning of its reader that it does not silence; {@code
 * ElementExamplesIT} checks those of the elements.
 */
class ExampleWarningsTest {
  private static final Path EXAMPLES = Path.of("../examples");

  /** Fewer files would mean that this test looks in the wrong place. */
  private static final int AT_LEAST = 80;

  private static List<Path> files() throws IOException {
    try (Stream<Path> files = Files.walk(EXAMPLES)) {
      return files
          .filter(file -> file.toString().endsWith(".xml"))
          .filter(file -> !file.toString().matches(".*(target|elements)/.*"))
          .sorted()
          .toList();
    }
  }

  @Test
  void examplesHaveNoWarnings() throws IOException, MechmlException {
    List<String> warnings = new ArrayList<>();
    int read = 0;
    for (Path file : files()) {
      byte[] content = Files.readAllBytes(file);
      if (Files.readString(file).contains("<MBSmodel")) {
        byte[] whole = ModelFiles.inlined(content, file);
        MechmlReader.read(file.toString(), whole)
            .warnings()
            .forEach(w -> warnings.add(w.toString()));
        read++;
      }
    }

    assertThat(warnings).isEmpty();
    assertThat(read).isGreaterThan(AT_LEAST);
  }
}
