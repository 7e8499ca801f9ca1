package org.mechservice.study;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.solver.text.ShortestDecimal;

/**
 * A number or series that is kept of a column of a run: {@code last(x)}, {@code at(x,2.5)}, {@code
 * min(x)}, {@code max(x)}, {@code mean(x)}, {@code rms(x)}, {@code integral(x)}, {@code
 * crossing(x,0)}, {@code series(x)}, {@code series(x,0.1)}.
 *
 * <p>Between two rows a column is taken as a straight line; extremes are those of the rows.
 *
 * @param column name of the column; {@code *} for each one but the time
 * @param kind what is kept
 * @param argument time of {@code at}, s; level of {@code crossing}, in the column's unit; distance
 *     of {@code series}, s; NaN for the others, and for a series with every row
 */
public record Reduction(String column, Kind kind, double argument) {
  private static final Pattern FORM = Pattern.compile("\\s*([A-Za-z]+)\\s*\\((.*)\\)\\s*");

  /** Kinds of reductions. */
  public enum Kind {
    /** The value at the end. */
    LAST,
    /** The value at a time. */
    AT,
    /** The smallest value of the rows. */
    MIN,
    /** The largest value of the rows. */
    MAX,
    /** The integral over time divided by the time. */
    MEAN,
    /** The root of the mean of the square. */
    RMS,
    /** The integral over time. */
    INTEGRAL,
    /** The first time at which the column passes a level or is on it. */
    CROSSING,
    /** The values at equal distances of time. */
    SERIES;

    /** Returns the word of the textual form. */
    public String word() {
      return name().toLowerCase(Locale.ROOT);
    }

    static List<String> words() {
      return Arrays.stream(values()).map(Kind::word).toList();
    }
  }

  /**
   * Reads the textual form; a name alone means its last value.
   *
   * @throws IllegalArgumentException if the text has another form; the message says what to write
   */
  public static Reduction parse(String text) {
    Matcher form = FORM.matcher(text);
    if (!form.matches()) {
      if (text.isBlank()) {
        throw new IllegalArgumentException("it is empty; write such as max(height.q)");
      }
      return new Reduction(text.strip(), Kind.LAST, Double.NaN);
    }
    String word = form.group(1).toLowerCase(Locale.ROOT);
    if (!Kind.words().contains(word)) {
      throw new IllegalArgumentException(
          "there is no reduction \""
              + form.group(1)
              + '"'
              + NearestName.suggestion(word, Kind.words())
              + "; there are "
              + String.join(", ", Kind.words()));
    }
    return of(Kind.valueOf(word.toUpperCase(Locale.ROOT)), form.group(2));
  }

  private static Reduction of(Kind kind, String inside) {
    int comma = inside.lastIndexOf(',');
    return switch (kind) {
      case AT -> {
        if (comma < 0) {
          throw new IllegalArgumentException(
              "at(" + inside + ") lacks the time; write at(" + inside.strip() + ", 2.5)");
        }
        yield new Reduction(name(inside.substring(0, comma)), kind, number(inside, comma));
      }
      case CROSSING ->
          comma < 0
              ? new Reduction(name(inside), kind, 0)
              : new Reduction(name(inside.substring(0, comma)), kind, number(inside, comma));
      case SERIES -> {
        if (comma < 0) {
          yield new Reduction(name(inside), kind, Double.NaN);
        }
        double distance = number(inside, comma);
        if (distance <= 0) {
          throw new IllegalArgumentException("the distance of a series is above 0 s");
        }
        yield new Reduction(name(inside.substring(0, comma)), kind, distance);
      }
      case LAST, MIN, MAX, MEAN, RMS, INTEGRAL -> new Reduction(name(inside), kind, Double.NaN);
    };
  }

  private static String name(String text) {
    if (text.isBlank()) {
      throw new IllegalArgumentException("it names no column; write such as max(height.q)");
    }
    return text.strip();
  }

  private static double number(String inside, int comma) {
    String text = inside.substring(comma + 1).strip();
    try {
      double value = Double.parseDouble(text);
      if (Double.isFinite(value)) {
        return value;
      }
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("\"" + text + "\" is no number", e);
    }
    throw new IllegalArgumentException("\"" + text + "\" is not finite");
  }

  /** Returns whether it means each column of a run but the time. */
  public boolean isOfAll() {
    return column.equals("*");
  }

  /** Returns whether it has a time of its own that lies in the interval of a run. */
  public boolean fits(double start, double end) {
    return kind != Kind.AT || (argument >= start && argument <= end);
  }

  @Override
  public String toString() {
    String words =
        Double.isNaN(argument)
            ? column
            : List.of(column, ShortestDecimal.format(argument)).stream()
                .collect(Collectors.joining(","));
    return kind.word() + "(" + words + ")";
  }
}
