package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The examples of the language's elements give the results stated in their comments. */
class ElementExamplesIT {
  private static final Path FOLDER = WorkingTree.TOP.resolve("examples/elements");
  private static final Pattern END = Pattern.compile("Ends with (.*?)\\.\n-->", Pattern.DOTALL);
  private static final Pattern VALUE = Pattern.compile("([\\w./\\[\\]]+) = (-?\\d+\\.\\d+)");

  @TempDir private Path directory;

  static Stream<String> examples() throws IOException {
    try (Stream<Path> files = Files.list(FOLDER)) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> name.endsWith(".xml"))
          .sorted()
          .toList()
          .stream();
    }
  }

  @ParameterizedTest
  @MethodSource("examples")
  void endsAsItsCommentSays(String name) throws IOException {
    Path model = FOLDER.resolve(name);
    Path rows = directory.resolve("r.csv");

    Mechanic.simulate(model, rows, "--quiet").orFail();

    String said = END.matcher(Files.readString(model)).results().findFirst().orElseThrow().group(1);
    ResultRows table = ResultRows.read(rows);
    assertThat(VALUE.matcher(said).results()).isNotEmpty();
    for (MatchResult value : VALUE.matcher(said).results().toList()) {
      double[] column = table.column(value.group(1));
      BigDecimal expected = new BigDecimal(value.group(2));
      // Right to the last digit written.
      assertThat(column[column.length - 1])
          .as(value.group(1))
          .isCloseTo(expected.doubleValue(), within(expected.ulp().doubleValue() / 2));
    }
  }

  @ParameterizedTest
  @MethodSource("examples")
  void checkFindsNothingOddInIt(String name) {
    Mechanic.Done check = Mechanic.check(FOLDER.resolve(name)).orFail();

    assertThat(check.out()).doesNotContain("Not used");
    if (name.equals("joint-cut.xml")) {
      assertThat(check.out()).contains("redundant equations: 3");
    } else {
      assertThat(check.out()).contains("Warnings: none");
    }
  }
}
