package org.mechservice.mechml.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Every code has a page for users, and every page a code. */
class CatalogueTest {
  private static final Path PAGES = Path.of("..", "docs", "errors");

  @ParameterizedTest
  @EnumSource(MessageCode.class)
  void everyCodeHasItsPage(MessageCode code) throws IOException {
    List<String> lines = Files.readAllLines(PAGES.resolve(code.code() + ".md"));
    assertThat(lines.get(0)).startsWith("# " + code.code() + ": ");
    assertThat(lines).contains("## What it means", "## What to do");
  }

  @Test
  void everyPageHasItsCode() throws IOException {
    try (Stream<Path> pages = Files.list(PAGES)) {
      assertThat(pages.map(p -> p.getFileName().toString()).filter(n -> n.startsWith("M-")))
          .containsExactlyInAnyOrderElementsOf(
              Arrays.stream(MessageCode.values()).map(c -> c.code() + ".md").toList());
    }
  }

  @Test
  void codesAreUnique() {
    assertThat(Arrays.stream(MessageCode.values()).map(MessageCode::code)).doesNotHaveDuplicates();
  }
}
