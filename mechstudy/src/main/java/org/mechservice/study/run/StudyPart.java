package org.mechservice.study.run;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A part of a study's points.
 *
 * @param number from 1
 * @param count number of parts
 */
public record StudyPart(int number, int count) {
  /** All points. */
  public static final StudyPart WHOLE = new StudyPart(1, 1);

  private static final Pattern FORM = Pattern.compile("([0-9]{1,9})/([0-9]{1,9})");

  /**
   * Reads {@code i/n}.
   *
   * @throws IllegalArgumentException if the text has another form
   */
  public static StudyPart parse(String text) {
    Matcher form = FORM.matcher(text.strip());
    if (form.matches()) {
      StudyPart part =
          new StudyPart(Integer.parseInt(form.group(1)), Integer.parseInt(form.group(2)));
      if (part.number >= 1 && part.number <= part.count) {
        return part;
      }
    }
    throw new IllegalArgumentException(
        "\""
            + text
            + "\" is no part; write the part's number and how many there are, such as 2/8,"
            + " the first is 1");
  }

  /** Returns the first point of the part. */
  int from(int points) {
    return (int) ((long) points * (number - 1) / count);
  }

  /** Returns the point after the last of the part. */
  int to(int points) {
    return (int) ((long) points * number / count);
  }

  /** Returns how many points the part has. */
  public int size(int points) {
    return to(points) - from(points);
  }

  boolean isWhole() {
    return count == 1;
  }

  @Override
  public String toString() {
    return number + "/" + count;
  }
}
