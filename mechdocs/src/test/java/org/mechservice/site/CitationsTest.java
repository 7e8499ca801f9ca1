package org.mechservice.site;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/**
 * What comments cite can be read: a page of docs with its heading, or published literature with its
 * year.
 */
class CitationsTest {
  private static final Path TOP = Path.of("..");
  private static final Set<String> LANGUAGES =
      Set.of("java", "c", "h", "cpp", "js", "css", "idl", "py");

  /** Texts of a program, which are passed over, and its comments. */
  private static final Pattern PIECE =
      Pattern.compile(
          "\"\"\"[\\s\\S]*?\"\"\"|\"[^\"\\\\\\n]*+(?:\\\\.[^\"\\\\\\n]*+)*+\""
              + "|'[^'\\\\\\n]*+(?:\\\\.[^'\\\\\\n]*+)*+'|/\\*[\\s\\S]*?\\*/|(?://[^\\n]*\\n?\\s*)+");

  /** The same in Python, where long texts in quotes are comments on what follows or precedes. */
  private static final Pattern PYTHON_PIECE =
      Pattern.compile(
          "\"\"\"[\\s\\S]*?\"\"\"|\"[^\"\\\\\\n]*+(?:\\\\.[^\"\\\\\\n]*+)*+\""
              + "|'[^'\\\\\\n]*+(?:\\\\.[^'\\\\\\n]*+)*+'|(?:#[^\\n]*\\n?\\s*)+");

  private static final Pattern MARGIN = Pattern.compile("\\s*\\n\\s*(?:\\*(?!/)|//|#)?\\s*");

  /** A file or folder of docs, with the anchor of a heading or without. */
  private static final Pattern PAGE =
      Pattern.compile("\\bdocs/([\\w./-]*\\w)(?:#([\\w-]+))?", Pattern.UNICODE_CHARACTER_CLASS);

  /** A numbered part of a text. */
  private static final Pattern PART =
      Pattern.compile("§|\\b(?:[Ss]ect(?:ions?|\\.)|[Cc]hapters?|[Aa]ppendix|ch\\.) [IVX\\d]");

  /** A year, or a standard that has its number or name. */
  private static final Pattern SOURCE =
      Pattern.compile("\\b(?:1[89]|20)\\d\\d\\b|\\bJVMS\\b|\\b(?:CORBA|glTF) \\d");

  /** Numbered parts of notes, which have their names in capitals, and numbers of a tracker. */
  private static final Pattern ABSENT =
      Pattern.compile("\\b(?!JVMS)[A-Z]{4,} §|\\b[Ii]ssue(?: #?\\d|'s\\b)|\\bthe issue\\b");

  /** A comment without its margin, on one line. */
  private record Comment(String file, String text) {
    List<MatchResult> all(Pattern pattern) {
      return pattern.matcher(text).results().toList();
    }

    boolean has(Pattern pattern) {
      return pattern.matcher(text).find();
    }
  }

  private static final List<Comment> COMMENTS = new ArrayList<>();

  @BeforeAll
  static void read() throws IOException {
    COMMENTS.clear();
    Files.walkFileTree(
        TOP,
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes what) {
            String name = folder.getFileName().toString();
            boolean built = name.equals("target") || (name.startsWith(".") && !folder.equals(TOP));
            return built ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes what) throws IOException {
            String name = file.getFileName().toString();
            String language = name.substring(name.lastIndexOf('.') + 1);
            if (LANGUAGES.contains(language) && !name.equals("CitationsTest.java")) {
              COMMENTS.addAll(comments(file, Files.readString(file), language.equals("py")));
            }
            return FileVisitResult.CONTINUE;
          }
        });
    assertThat(COMMENTS).hasSizeGreaterThan(1000);
  }

  private static List<Comment> comments(Path file, String text, boolean python) {
    String name = TOP.relativize(file).toString().replace('\\', '/');
    Predicate<String> isComment =
        python
            ? piece -> piece.startsWith("#") || piece.startsWith("\"\"\"")
            : piece -> piece.startsWith("/");
    return (python ? PYTHON_PIECE : PIECE)
        .matcher(text.replace("\r\n", "\n"))
        .results()
        .map(MatchResult::group)
        .filter(isComment)
        .map(comment -> new Comment(name, MARGIN.matcher(comment).replaceAll(" ").strip()))
        .toList();
  }

  @Test
  void everyPageOfDocsThatACommentCitesIsThere() {
    Map<Path, Set<String>> anchors = new HashMap<>();
    List<String> missing = new ArrayList<>();
    for (Comment comment : COMMENTS) {
      for (MatchResult cited : comment.all(PAGE)) {
        Path page = Path.of("docs", cited.group(1));
        boolean there =
            Files.exists(TOP.resolve(page))
                && (cited.group(2) == null
                    || anchors
                        .computeIfAbsent(page, CitationsTest::anchors)
                        .contains(cited.group(2)));
        if (!there) {
          missing.add(comment.file() + ": " + cited.group());
        }
      }
    }
    assertThat(missing).as("pages or headings that are not in docs").isEmpty();
  }

  private static Set<String> anchors(Path page) {
    try {
      String text = Files.readString(TOP.resolve(page));
      return GuidePage.of(page, text, path -> false).sections().stream()
          .map(GuidePage.Section::anchor)
          .collect(Collectors.toSet());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Test
  void everyNumberedPartOfATextHasItsSource() {
    assertThat(COMMENTS)
        .filteredOn(comment -> comment.has(PART) && !comment.has(SOURCE))
        .as("Name the source in the same comment with its year, or a page of docs with its heading")
        .isEmpty();
  }

  @Test
  void noCommentCitesTextsOutsideTheRepository() {
    assertThat(COMMENTS)
        .filteredOn(comment -> comment.has(ABSENT))
        .as("Cite a page of docs or published literature")
        .isEmpty();
  }

  /** Comments of several lines are one; what looks like one in a text is none. */
  @Test
  void commentsAreReadAsOneLine() {
    String java =
        "/** One\n   * of docs/a.md#b-c. */\nString s = \"// not \\\" this\"; // and\n  // two\n";
    assertThat(comments(TOP.resolve("A.java"), java, false))
        .extracting(Comment::text)
        .containsExactly("/** One of docs/a.md#b-c. */", "// and two");
    String python = "\"\"\"A text.\"\"\"\nx = '# not this'  # a\n# comment\n";
    assertThat(comments(TOP.resolve("a.py"), python, true))
        .extracting(Comment::text)
        .containsExactly("\"\"\"A text.\"\"\"", "# a comment");
  }
}
