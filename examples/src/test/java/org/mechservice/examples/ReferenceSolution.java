package org.mechservice.examples;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A reference solution that comes with the product: the states [q; v] at some times.
 *
 * @param times s
 * @param states one per time, in the order of the result columns
 */
record ReferenceSolution(List<Double> times, List<List<Double>> states) {
  private static final Pattern NAME = Pattern.compile("<MBSmodel name=\"(.*?)\"");
  private static final String FOLDER = "/org/mechservice/report/references/";

  /** Returns the reference of the model in a file; empty if it has none. */
  static Optional<ReferenceSolution> of(Path file) throws IOException {
    Matcher name = NAME.matcher(Files.readString(file));
    if (!name.find()) {
      throw new AssertionError("no model in " + file);
    }
    String resource = FOLDER + name.group(1) + ".csv";
    try (InputStream in = ReferenceSolution.class.getResourceAsStream(resource)) {
      if (in == null) {
        return Optional.empty();
      }
      List<Double> times = new ArrayList<>();
      List<List<Double>> states = new ArrayList<>();
      String text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
      for (String line : text.lines().skip(1).toList()) {
        List<Double> row = Arrays.stream(line.split(",")).map(Double::valueOf).toList();
        times.add(row.get(0));
        // The second number is the difference of two ways to compute the reference.
        states.add(row.subList(2, row.size()));
      }
      return Optional.of(new ReferenceSolution(times, states));
    }
  }

  /**
   * Returns the largest |q - ref| / (1 + |ref|) of all positions up to a time.
   *
   * @param results must have a row at every time of the reference up to then
   */
  double errorOf(ResultRows results, double tLast) {
    int positions =
        (int) results.columns().stream().filter(c -> c.matches(".*\\.q(\\[\\d+])?")).count();
    double largest = 0;
    for (int k = 0; k < times.size() && times.get(k) <= tLast; k++) {
      List<Double> row = results.rowAt(times.get(k));
      List<Double> state = states.get(k);
      for (int i = 0; i < positions; i++) {
        double difference = Math.abs(row.get(i + 1) - state.get(i));
        largest = Math.max(largest, difference / (1 + Math.abs(state.get(i))));
      }
    }
    return largest;
  }
}
