package org.mechservice.site;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/**
 * Each sentence of the guide with "only", "never", "exactly", "without" or "always" is a promise,
 * and {@code promises.tsv} names the tests that prove it.
 *
 * <p>The guide is README.md, CONTRIBUTING.md and the pages of docs except the reports, which are
 * records. Code and the titles of sources are left out. If a test here fails: say the fact without
 * the word; or prove it and add a line to the ledger.
 */
class PromisesTest {
  private static final Path TOP = Path.of("..");
  private static final Path LEDGER =
      Path.of("src/test/resources/org/mechservice/site/promises.tsv");
  private static final Pattern WORD =
      Pattern.compile(
          "\\b(only|never|exactly|without|always)\\b",
          Pattern.CASE_INSENSITIVE | Pattern.UNICODE_CHARACTER_CLASS);
  private static final Pattern CODE = Pattern.compile("`[^`]*`");
  private static final Pattern CELL = Pattern.compile("(?<!\\\\)\\|");
  private static final Pattern HEADING = Pattern.compile("#+ ");
  private static final Pattern ITEM = Pattern.compile("([-*] |\\d+\\. )");
  private static final Pattern SENTENCE_END = Pattern.compile("(?<=[.!?])\\s+(?=[^a-z])");

  /** A source in a list of sources, {@code - [B73] ...}; its title is quoted. */
  private static final Pattern SOURCE = Pattern.compile("- \\[[^\\]]+\\] .*");

  private static final String ADVICE =
      "Say the fact without the word, or prove it and name the test in "
          + LEDGER
          + " by a line: page, tab, some words of the sentence with the word among them, tab,"
          + " Class#method or FILE.py#function";

  /** A line of the ledger. */
  private record Promise(String page, String words, List<String> tests) {
    static Promise of(String line) {
      String[] cells = line.split("\t", -1);
      assertThat(cells).as("page, words and tests, by tabs: " + line).hasSize(3);
      return new Promise(cells[0], cells[1], List.of(cells[2].split(" ", -1)));
    }

    boolean isIn(Sentence sentence) {
      return page.equals(sentence.page()) && sentence.text().contains(words);
    }
  }

  /** A sentence of the guide, its blanks and line ends one blank each. */
  private record Sentence(String page, String text) {
    boolean promises() {
      return WORD.matcher(CODE.matcher(text).replaceAll("")).find();
    }
  }

  private static List<Promise> ledger = List.of();
  private static List<Sentence> promising = List.of();

  @BeforeAll
  static void read() throws IOException {
    ledger =
        Files.readAllLines(LEDGER).stream()
            .filter(line -> !line.startsWith("#"))
            .map(Promise::of)
            .toList();
    List<Sentence> found = new ArrayList<>();
    for (Path page : pages()) {
      String name = TOP.relativize(page).toString().replace('\\', '/');
      for (String block : blocks(Files.readAllLines(page))) {
        SENTENCE_END
            .splitAsStream(block)
            .map(text -> new Sentence(name, text))
            .filter(Sentence::promises)
            .forEach(found::add);
      }
    }
    promising = List.copyOf(found);
  }

  private static List<Path> pages() throws IOException {
    Path docs = TOP.resolve("docs");
    try (Stream<Path> all = Files.walk(docs)) {
      return Stream.concat(
              Stream.of(TOP.resolve("README.md"), TOP.resolve("CONTRIBUTING.md")),
              all.filter(page -> page.toString().endsWith(".md"))
                  .filter(page -> !page.startsWith(docs.resolve("reports"))))
          .sorted()
          .toList();
    }
  }

  /** Returns paragraphs, headings, items of lists and cells of tables, each as one line. */
  private static List<String> blocks(List<String> page) {
    List<String> blocks = new ArrayList<>();
    List<String> block = new ArrayList<>();
    boolean code = false;
    for (String line : page) {
      String text = line.strip();
      boolean fence = text.startsWith("```");
      boolean row = text.startsWith("|");
      boolean heading = HEADING.matcher(text).lookingAt();
      if (fence || row || heading || text.isEmpty() || ITEM.matcher(text).lookingAt()) {
        blocks.add(String.join(" ", block));
        block.clear();
      }
      code ^= fence;
      if (!code && row) {
        CELL.splitAsStream(text).map(String::strip).forEach(blocks::add);
      } else if (!code && heading) {
        blocks.add(text);
      } else if (!code && !fence && !text.isEmpty()) {
        block.add(text);
      }
    }
    blocks.add(String.join(" ", block));
    blocks.removeIf(text -> text.isEmpty() || SOURCE.matcher(text).matches());
    return blocks;
  }

  @Test
  void everyPromiseOfTheGuideHasATest() {
    assertThat(promising)
        .filteredOn(sentence -> ledger.stream().noneMatch(promise -> promise.isIn(sentence)))
        .as(ADVICE)
        .isEmpty();
  }

  @Test
  void everyLineOfTheLedgerHasItsSentence() {
    assertThat(ledger)
        .filteredOn(promise -> promising.stream().filter(promise::isIn).count() != 1)
        .as("Lines whose words are in no promise of the page, or in several: remove or correct")
        .isEmpty();
    assertThat(ledger)
        .filteredOn(promise -> !new Sentence(promise.page(), promise.words()).promises())
        .as("Lines whose words do not have the word among them: name more of the sentence")
        .isEmpty();
  }

  @Test
  void everyTestOfTheLedgerIsThere() throws IOException {
    Map<String, List<Path>> sources = testSources();
    Predicate<String> isThere = test -> isThere(test, sources);
    assertThat(ledger)
        .filteredOn(promise -> !promise.tests().stream().allMatch(isThere))
        .as("Lines with a test that is not in the sources, or disabled: " + ADVICE)
        .isEmpty();
  }

  /** Returns the test sources of all modules by the names of their classes. */
  private static Map<String, List<Path>> testSources() throws IOException {
    try (Stream<Path> all =
        Files.find(TOP, 25, (file, what) -> file.toString().endsWith(".java"))) {
      return all.filter(file -> file.toString().replace('\\', '/').contains("/src/test/java/"))
          .collect(
              Collectors.groupingBy(
                  file -> file.getFileName().toString().replace(".java", ""),
                  TreeMap::new,
                  Collectors.toList()));
    }
  }

  private static boolean isThere(String test, Map<String, List<Path>> sources) {
    String[] parts = test.split("#", -1);
    if (parts.length != 2) {
      return false;
    }
    if (parts[0].endsWith(".py")) {
      Pattern function = Pattern.compile("(?m)^def " + Pattern.quote(parts[1]) + "\\(");
      return Files.isRegularFile(TOP.resolve(parts[0]))
          && function.matcher(text(TOP.resolve(parts[0]))).find();
    }
    Pattern method = Pattern.compile("\\bvoid " + Pattern.quote(parts[1]) + "\\(");
    return sources.getOrDefault(parts[0], List.of()).stream()
        .map(PromisesTest::text)
        .anyMatch(text -> method.matcher(text).results().anyMatch(found -> isTest(text, found)));
  }

  /** Returns whether a method has the annotation of a test; a blank line stands before both. */
  private static boolean isTest(String text, MatchResult method) {
    String head = text.substring(0, method.start());
    String annotations = head.substring(head.lastIndexOf("\n\n") + 1);
    return annotations.contains("Test") && !annotations.contains("@Disabled");
  }

  private static String text(Path file) {
    try {
      return Files.readString(file).replace("\r\n", "\n");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The five words are found in all their places, and not in code or in the titles of sources. */
  @Test
  void promisesAreFoundWhereTheyStand() {
    List<String> page =
        Arrays.asList(
            "# Never a title",
            "It is so. It is Only",
            "so! Always it is `never`.",
            "- [B73] Without, 1973.",
            "| one cell | exactly |",
            "```sh",
            "always",
            "```",
            "- an item, `only` code");
    assertThat(
            blocks(page).stream()
                .flatMap(SENTENCE_END::splitAsStream)
                .map(text -> new Sentence("page", text))
                .filter(Sentence::promises)
                .map(Sentence::text))
        .containsExactly("# Never a title", "It is Only so!", "Always it is `never`.", "exactly");
  }
}
