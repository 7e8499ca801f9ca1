package org.mechservice.report.stability;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/**
 * A scene that is hard for simulators, with the expected outcome.
 *
 * @param file its name
 * @param hard the difficulty, in words
 * @param expectation the expected outcome
 * @param part for {@link Expectation#REFUSAL}, what the message must name; empty for others
 * @param tolerance relative tolerance of the runs
 * @param judge the reference of a motion
 * @param bound of that
 */
public record ExtremeCase(
    String file,
    String hard,
    Expectation expectation,
    String part,
    double tolerance,
    JudgedBy judge,
    double bound) {
  private static final String FOLDER = "/org/mechservice/report/extremes/";
  private static final int FIELDS = 6;

  /** The expected outcome. */
  public enum Expectation {
    /** At least one method moves it within the bound; none is silently wrong. */
    MOTION,
    /** Every method moves it within the bound or says why not. */
    MOTION_OR_REFUSAL,
    /** No method moves it; the message names the part. */
    REFUSAL
  }

  /** The reference of a motion. */
  public enum JudgedBy {
    /** Largest error against a reference. */
    REFERENCE,
    /** Largest change of energy, as a part of the energy's scale. */
    ENERGY,
    /** Nothing moves. */
    MESSAGE
  }

  /** Returns the suite that comes with the product. */
  public static List<ExtremeCase> suite() {
    return text("cases.csv").lines().filter(l -> !l.startsWith("#")).map(ExtremeCase::of).toList();
  }

  private static ExtremeCase of(String line) {
    String[] fields = line.split(",(?=(?:[^\"]*\"[^\"]*\")*[^\"]*$)", -1);
    if (fields.length != FIELDS) {
      throw new IllegalStateException("cases.csv: " + line);
    }
    String expected = fields[2];
    Expectation expectation =
        switch (expected) {
          case "motion" -> Expectation.MOTION;
          case "motion or refusal" -> Expectation.MOTION_OR_REFUSAL;
          default -> Expectation.REFUSAL;
        };
    String part =
        expectation == Expectation.REFUSAL ? expected.replaceFirst("^(refused|ends at) ", "") : "";
    return new ExtremeCase(
        fields[0],
        fields[1].replace("\"", ""),
        expectation,
        part,
        Double.parseDouble(fields[3]),
        JudgedBy.valueOf(fields[4].toUpperCase(java.util.Locale.ROOT)),
        Double.parseDouble(fields[5]));
  }

  /** Returns the scene's MechML. */
  public byte[] content() {
    return text(file).getBytes(StandardCharsets.UTF_8);
  }

  private static String text(String name) {
    try (InputStream in = ExtremeCase.class.getResourceAsStream(FOLDER + name)) {
      if (in == null) {
        throw new IllegalStateException("resource " + name + " is missing");
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns the scene's name. */
  public String name() {
    return file.replaceFirst("\\.xml$", "");
  }
}
