package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.NavigableSet;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Every message a user can meet has its page, and no page speaks of a message that is gone. */
class MessagePagesIT {
  private static final Path PAGES = WorkingTree.TOP.resolve("docs/errors");
  private static final Pattern CODE_IN_SOURCE = Pattern.compile("\"([MNS]-\\d{3})\\b");

  @Test
  void codesInTheSourcesAndPagesAreTheSame() throws IOException {
    assertThat(pages()).isEqualTo(codesInSources());
  }

  @Test
  void everyPageBeginsWithItsCodeAndIsInTheIndex() throws IOException {
    List<String> index = Files.readAllLines(PAGES.resolve("README.md"));
    for (String code : pages()) {
      String title = Files.readAllLines(PAGES.resolve(code + ".md")).get(0);
      assertThat(title).startsWith("# " + code + ": ");
      assertThat(index).contains("| [%s](%s.md) | %s |".formatted(code, code, title.substring(9)));
    }
  }

  private static NavigableSet<String> pages() throws IOException {
    NavigableSet<String> codes = new TreeSet<>();
    try (Stream<Path> pages = Files.list(PAGES)) {
      pages
          .map(page -> page.getFileName().toString().replace(".md", ""))
          .filter(name -> !name.equals("README"))
          .forEach(codes::add);
    }
    return codes;
  }

  private static NavigableSet<String> codesInSources() throws IOException {
    NavigableSet<String> codes = new TreeSet<>();
    try (Stream<Path> modules = Files.list(WorkingTree.TOP)) {
      for (Path module : modules.toList()) {
        Path sources = module.resolve("src/main/java");
        if (Files.isDirectory(sources)) {
          addCodes(sources, codes);
        }
      }
    }
    addCodes(WorkingTree.MECH, codes);
    return codes;
  }

  private static void addCodes(Path sources, NavigableSet<String> codes) throws IOException {
    try (Stream<Path> files = Files.walk(sources)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        CODE_IN_SOURCE
            .matcher(Files.readString(file))
            .results()
            .map((MatchResult match) -> match.group(1))
            .forEach(codes::add);
      }
    }
  }
}
