package org.mechservice.report.solution;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.mechservice.report.method.ModelPhases;
import org.mechservice.report.method.ModelProblem;

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

  /**
   * Returns the reference of a model's name, if there is one that begins where the model does and
   * nothing parts the model's course: those that come with the product are of smooth motions.
   */
  public static Optional<PublishedReference> of(
      String modelName, ModelProblem problem, double end, StateDistance distance) {
    return problem.course().map(ModelPhases::isParted).orElse(false)
        ? Optional.empty()
        : of(modelName, problem.start(), end, distance);
  }

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

  /**
   * Returns the same at some of its times.
   *
   * @param some of the times
   */
  PublishedReference at(double[] some) {
    int[] rows = Arrays.stream(some).mapToInt(t -> Arrays.binarySearch(times, t)).toArray();
    return new PublishedReference(
        how,
        some,
        Arrays.stream(rows).mapToObj(row -> states[row]).toArray(double[][]::new),
        Arrays.stream(rows).mapToDouble(row -> floor[row]).toArray());
  }

  private static double[] stateOf(double[] row) {
    return Arrays.copyOfRange(row, 2, row.length);
  }
}
