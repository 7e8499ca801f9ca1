package org.mechservice.solver.catalogue;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Every message code has a page for users, and every page a code. */
class MessageCodeTest {
  private static final Path TOP = Path.of("..", "..");

  @ParameterizedTest
  @EnumSource(MessageCode.class)
  void everyCodeHasItsPage(MessageCode message) throws IOException {
    List<String> lines = Files.readAllLines(TOP.resolve(message.page()));
    assertThat(lines.get(0)).startsWith("# " + message.code() + ": ");
    assertThat(lines).anyMatch(line -> line.contains("What to do"));
    if (message.code().startsWith("M-")) {
      assertThat(lines).contains("## What it means", "## What to do");
    }
  }

  @Test
  void everyPageHasItsCode() throws IOException {
    try (Stream<Path> pages = Files.list(TOP.resolve("docs/errors"))) {
      assertThat(pages.map(page -> "docs/errors/" + page.getFileName()))
          .filteredOn(page -> !page.endsWith("README.md"))
          .containsExactlyInAnyOrderElementsOf(
              Arrays.stream(MessageCode.values()).map(MessageCode::page).toList());
    }
  }

  @ParameterizedTest
  @EnumSource(MessageCode.class)
  void codeLeadsBackToItsEntry(MessageCode message) {
    assertThat(message.code()).matches("[MNS]-\\d{3}");
    assertThat(MessageCode.of(message.code())).isSameAs(message);
    assertThat(message).hasToString(message.code());
  }

  @Test
  void entriesStandInTheOrderOfTheirCodes() {
    assertThat(Arrays.stream(MessageCode.values()).map(MessageCode::code)).isSorted();
  }

  @Test
  void unknownCodeIsRefused() {
    assertThat(MessageCode.find("M-999")).isEmpty();
    assertThatThrownBy(() -> MessageCode.of("M-999"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("M-999");
  }
}
