package org.mechservice.cli.sweep;

import java.util.Arrays;
import java.util.List;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.client.sweep.SweptParameter;
import org.mechservice.solver.catalogue.MessageCode;

/** Reads the values of a parameter of a sweep: {@code P=A:B:N} or {@code P=1,2,5}. */
final class SweepRange {
  private static final String FORMS =
      "write NAME=FROM:TO:COUNT, such as --set length=0.5:1.5:11, or NAME=VALUE,VALUE,...";

  private SweepRange() {}

  /**
   * Reads a parameter with its values.
   *
   * @throws UsageException if it cannot be understood
   */
  static SweptParameter parse(String text) {
    int equals = text.indexOf('=');
    if (equals < 1 || text.substring(0, equals).isBlank()) {
      throw refused(text, "it names no parameter");
    }
    String name = text.substring(0, equals).strip();
    String values = text.substring(equals + 1).strip();
    return values.contains(":") ? range(text, name, values) : list(text, name, values);
  }

  private static SweptParameter list(String text, String name, String values) {
    List<String> all = Arrays.stream(values.split(",", -1)).map(String::strip).toList();
    if (all.contains("")) {
      throw refused(
          text, values.isEmpty() ? "it has no value" : "a value between commas is missing");
    }
    return new SweptParameter(name, all);
  }

  private static SweptParameter range(String text, String name, String values) {
    String[] parts = values.split(":", -1);
    if (parts.length != 3) {
      throw refused(text, "a range has three parts, not " + parts.length);
    }
    double from = number(text, parts[0]);
    double to = number(text, parts[1]);
    int count;
    try {
      count = Integer.parseInt(parts[2].strip());
    } catch (NumberFormatException e) {
      throw refused(text, "\"" + parts[2] + "\" is no whole number of values");
    }
    if (count < 2) {
      throw refused(text, "a range has 2 values or more, not " + count);
    }
    return SweptParameter.range(name, from, to, count);
  }

  private static double number(String text, String part) {
    try {
      double value = Double.parseDouble(part.strip());
      if (Double.isFinite(value)) {
        return value;
      }
    } catch (NumberFormatException e) {
      throw refused(text, "\"" + part + "\" is no number");
    }
    throw refused(text, "\"" + part + "\" is not finite");
  }

  private static UsageException refused(String text, String why) {
    return new UsageException(
        MessageCode.OPTION_UNUSABLE + " --set " + text + ": " + why + "; " + FORMS);
  }
}
