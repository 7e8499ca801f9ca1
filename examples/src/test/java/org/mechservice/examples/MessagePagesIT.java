package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.catalogue.MessageCode;

/** Every message has a page, and every page belongs to a message. */
class MessagePagesIT {
  private static final Path PAGES = WorkingTree.TOP.resolve("docs/errors");
  private static final Path CATALOGUE = Path.of("MessageCode.java");
  private static final Pattern CODE_AS_TEXT = Pattern.compile("\"[MNS]-\\d{3}\\b");
  private static final Pattern CONSTANT = Pattern.compile("\\b[A-Z][A-Z_0-9]+\\b");

  @Test
  void everyMessageHasAPageAndEveryPageAMessage() throws IOException {
    try (Stream<Path> pages = Files.list(PAGES)) {
      assertThat(pages.map(page -> page.getFileName().toString().replace(".md", "")))
          .filteredOn(name -> !name.equals("README"))
          .containsExactlyInAnyOrderElementsOf(
              Arrays.stream(MessageCode.values()).map(MessageCode::code).toList());
    }
  }

  @Test
  void everyPageBeginsWithItsCodeAndIsInTheIndex() throws IOException {
    List<String> index = Files.readAllLines(PAGES.resolve("README.md"));
    for (MessageCode message : MessageCode.values()) {
      String code = message.code();
      String title = Files.readAllLines(WorkingTree.TOP.resolve(message.page())).get(0);
      assertThat(title).startsWith("# " + code + ": ");
      assertThat(index).contains("| [%s](%s.md) | %s |".formatted(code, code, title.substring(9)));
    }
  }

  /** The launcher script has one message of its own, with which it says why mech cannot start. */
  @Test
  void everyMessageIsUsed() throws IOException {
    Set<String> words =
        sources().stream()
            .filter(file -> !file.endsWith(CATALOGUE))
            .map(MessagePagesIT::text)
            .filter(text -> text.contains("MessageCode"))
            .flatMap(text -> CONSTANT.matcher(text).results().map(found -> found.group()))
            .collect(Collectors.toSet());
    Set<MessageCode> unused = EnumSet.allOf(MessageCode.class);
    unused.removeIf(message -> words.contains(message.name()));
    assertThat(unused).containsExactly(MessageCode.LAUNCHER_FAILED);
    assertThat(Files.readString(WorkingTree.MECH)).contains(MessageCode.LAUNCHER_FAILED.code());
  }

  @Test
  void noSourceNamesAMessageByItsText() throws IOException {
    assertThat(sources())
        .filteredOn(file -> !file.endsWith(CATALOGUE))
        .isNotEmpty()
        .noneMatch(file -> CODE_AS_TEXT.matcher(text(file)).find());
  }

  private static List<Path> sources() throws IOException {
    try (Stream<Path> files =
        Files.find(WorkingTree.TOP, 25, (file, what) -> what.isRegularFile())) {
      return files
          .filter(file -> file.toString().endsWith(".java"))
          .filter(file -> file.toString().contains("/src/main/java/"))
          .sorted(Comparator.naturalOrder())
          .toList();
    }
  }

  private static String text(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
