package org.mechservice.result;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.text.ResultFile;

/** A result whose numbers and names are hard to keep. */
final class ExampleRows {
  static final List<Variable> COLUMNS =
      List.of(
          new Variable("t", "s"),
          new Variable("arm.q[0]", "rad"),
          new Variable("height, \"upper\"", "m"),
          new Variable("Kraft ä", "N"));

  private static final double[] HARD = {
    0.0,
    -0.0,
    0.1,
    1.0 / 3,
    Double.MIN_VALUE,
    -Double.MIN_NORMAL,
    Double.MAX_VALUE,
    1e-300,
    2251799813685249.5,
    9007199254740992.0,
    Math.PI,
    -1e17,
    123456.0
  };

  private ExampleRows() {}

  /** Returns rows with each hard number in every column but time. */
  static List<double[]> rows() {
    return IntStream.range(0, HARD.length)
        .mapToObj(i -> new double[] {i / 7.0, hard(i), hard(i + 3), hard(i + 5)})
        .toList();
  }

  private static double hard(int i) {
    return HARD[i % HARD.length];
  }

  /** Writes rows into a file in the format of its name. */
  static void write(Path file, List<double[]> rows) throws IOException {
    try (ResultFile result = new ResultFile(file, ResultFormat.of(file).orElseThrow())) {
      result.begin(COLUMNS);
      for (double[] row : rows) {
        result.row(row);
      }
      result.keep();
    }
  }
}
