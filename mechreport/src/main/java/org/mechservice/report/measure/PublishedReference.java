package org.mechservice.report.measure;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * A reference that comes with the product: made in 80 or 128 bits by a program of its own, or in
 * closed form.
 *
 * @param how it was made
 * @param times the first is the start, s
 * @param states [q; v] there
 * @param floor per time, difference from a second run of that program
 */
@SuppressWarnings("ArrayRecordComponent") // constants, not changed
public record PublishedReference(String how, double[] times, double[][] states, double[] floor) {
  /** A start that differs by more belongs to another scene of the same name. */
  private static final double SAME_START = 1e-9;

  /** Returns the reference of a model's name, if there is one that begins where the model does. */
  public static Optional<PublishedReference> of(
      String modelName, double[] start, double end, StateDistance distance) {
    if (!modelName.matches("[\\w.-]+")) {
      return Optional.empty();
    }
    String resource = "/org/mechservice/report/references/" + modelName + ".csv";
    try (InputStream in = PublishedReference.class.getResourceAsStream(resource)) {
      if (in == null) {
        return Optional.empty();
      }
      BufferedReader reader = new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8));
      return of(reader.lines().toList(), start, end, distance);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static Optional<PublishedReference> of(
      List<String> lines, double[] start, double end, StateDistance distance) {
    double[][] rows =
        lines.stream()
            .skip(1)
            .map(line -> Arrays.stream(line.split(",", -1)).mapToDouble(Double::parseDouble))
            .map(java.util.stream.DoubleStream::toArray)
            .filter(row -> row[0] <= end * (1 + 1e-12))
            .toArray(double[][]::new);
    boolean fits = rows.length > 1 && rows[0].length == start.length + 2;
    if (!fits || distance.of(start, stateOf(rows[0])) > SAME_START) {
      return Optional.empty();
    }
    return Optional.of(
        new PublishedReference(
            lines.get(0).substring(2),
            Arrays.stream(rows).mapToDouble(row -> row[0]).toArray(),
            Arrays.stream(rows).map(PublishedReference::stateOf).toArray(double[][]::new),
            Arrays.stream(rows).mapToDouble(row -> row[1]).toArray()));
  }

  private static double[] stateOf(double[] row) {
    return Arrays.copyOfRange(row, 2, row.length);
  }
}
