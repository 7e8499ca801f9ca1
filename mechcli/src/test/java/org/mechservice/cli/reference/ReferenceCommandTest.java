package org.mechservice.cli.reference;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.cli.Mech;
import org.mechservice.cli.shell.ExitStatus;

/** The reference of the commands is that of the program, and complete. */
class ReferenceCommandTest {
  private static final Path PAGE = Path.of("..", "docs", "reference", "commands.md");
  private static final Pattern WORD = Pattern.compile("'([^']*)'|(\\S+)");

  @TempDir Path folder;

  private static String mech(String... words) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    int status = Mech.run(new PrintWriter(out), new PrintWriter(err), words);
    assertThat(status).as(err.toString()).isEqualTo(ExitStatus.DONE);
    return out.toString();
  }

  /** If this fails: {@code ./mech reference --page docs/reference/commands.md}. */
  @Test
  void pageOfTheGuideIsWhatTheProgramWrites() throws IOException {
    Path written = folder.resolve("commands.md");
    mech("reference", "--page", written.toString());
    assertThat(PAGE).hasSameTextualContentAs(written);
  }

  @Test
  void everyCommandHasAManualPage() throws IOException {
    mech("reference", "--man", folder.toString());
    assertThat(folder.resolve("mech-admin-stop.1")).content().contains(".SH \"SYNOPSIS\"");
    try (Stream<Path> pages = Files.list(folder)) {
      for (Path page : pages.toList()) {
        String text = Files.readString(page);
        // No request may begin by chance, and no text may be lost in an unknown escape.
        assertThat(text.lines().filter(line -> line.startsWith(".")))
            .as(page.toString())
            .allMatch(line -> line.matches("\\.(TH|SH|PP|TP|B|nf|fi)\\b.*"));
        assertThat(text.replaceAll("\\\\([-e&]|f[BR])", "")).doesNotContain("\\");
      }
    }
  }

  @Test
  void everyCommandHasExamplesWhoseOptionsExist() throws IOException {
    String page = Files.readString(PAGE);
    List<String> sections = Arrays.stream(page.split("\n## mech ", -1)).skip(1).toList();
    assertThat(sections).hasSizeGreaterThan(20);
    for (String section : sections) {
      String name = section.lines().findFirst().orElseThrow();
      assertThat(section).as(name).contains("\nExamples:\n");
      for (String example :
          section.split("\nExamples:\n\n```\n", 2)[1].split("\n```", 2)[0].lines().toList()) {
        List<String> words =
            WORD.matcher(example).results().map(ReferenceCommandTest::word).skip(1).toList();
        assertThat(name).startsWith(words.get(0));
        // With --help a command only reads its words.
        Stream<String> asking = Stream.concat(words.stream(), Stream.of("--help"));
        assertThat(mech(asking.toArray(String[]::new))).startsWith("Usage: mech " + name);
      }
    }
  }

  private static String word(MatchResult found) {
    return found.group(1) == null ? found.group(2) : found.group(1);
  }
}
