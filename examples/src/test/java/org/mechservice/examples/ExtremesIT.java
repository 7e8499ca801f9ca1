package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The extreme scenes, with the method named in each file, give the outcome stated in cases.csv.
 * {@code mech stability} runs all methods on all of them.
 */
class ExtremesIT {
  private static final Path FOLDER = WorkingTree.TOP.resolve("examples/extremes");

  @TempDir private Path directory;

  /** A line of cases.csv: file, what must happen, relative tolerance, bound of the error. */
  record Case(String file, String expected, String tolerance, double bound) {
    @Override
    public String toString() {
      return file;
    }
  }

  static Stream<Case> cases() throws IOException {
    return Files.readAllLines(FOLDER.resolve("cases.csv")).stream()
        .filter(line -> !line.startsWith("#"))
        .map(line -> line.replaceAll("\"[^\"]*\"", "").split(","))
        .map(field -> new Case(field[0], field[2], field[3], Double.parseDouble(field[5])));
  }

  @ParameterizedTest
  @MethodSource("cases")
  void whatIsExpectedHappens(Case one) throws IOException {
    Path model = FOLDER.resolve(one.file());
    Path rows = directory.resolve("r.csv");
    String absolute = Double.toString(Double.parseDouble(one.tolerance()) / 100);

    Mechanic.Done run =
        Mechanic.simulate(model, rows, "--rtol", one.tolerance(), "--atol", absolute);
    // check says beforehand whether the start can be used
    assertThat(Mechanic.check(model).status()).isEqualTo(run.status() == 2 ? 2 : 0);

    if (one.expected().startsWith("refused ")) {
      // 2 where the start itself cannot be used.
      assertThat(run.status()).isBetween(1, 2);
      assertThat(run.err()).containsPattern(word(one.expected().substring("refused ".length())));
      assertThat(rows).doesNotExist();
    } else if (one.expected().startsWith("ends at ")) {
      assertThat(run.status()).isEqualTo(1);
      assertThat(run.err())
          .containsPattern("N-\\d{3} t=")
          .containsPattern(word(one.expected().substring("ends at ".length())));
      assertThat(rows).exists();
    } else if (one.expected().equals("motion") || run.status() == 0) {
      assertThat(run.status()).as(run.toString()).isZero();
      Optional<ReferenceSolution> reference = ReferenceSolution.of(model);
      if (reference.isPresent()) {
        ResultRows results = ResultRows.read(rows);
        double end = results.rows().get(results.rows().size() - 1).get(0);
        assertThat(reference.get().errorOf(results, end)).isLessThan(one.bound());
      }
    } else {
      assertThat(run.err()).containsPattern("N-\\d{3} t=");
    }
  }

  private static String word(String name) {
    return "\\b" + name + "\\b";
  }

  @Test
  void everyFileIsACase() throws IOException {
    List<String> files = cases().map(Case::file).toList();
    try (Stream<Path> there = Files.list(FOLDER)) {
      assertThat(there.map(f -> f.getFileName().toString()).filter(f -> f.endsWith(".xml")))
          .containsExactlyInAnyOrderElementsOf(files);
    }
  }
}
