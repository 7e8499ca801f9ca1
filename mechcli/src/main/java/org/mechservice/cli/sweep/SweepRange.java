package org.mechservice.cli.sweep;

import static java.util.stream.Collectors.joining;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.mechml.diagnosis.SourcePosition;
import org.mechservice.mechml.document.Attribute;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.study.run.StudyValue;

/** Reads a parameter with its values, {@code P=A:B:N} or {@code P=1,2,5}, as a factor. */
final class SweepRange {
  private static final String FORMS =
      "write NAME=FROM:TO:COUNT, such as --set length=0.5:1.5:11, or NAME=VALUE,VALUE,...";

  private SweepRange() {}

  /**
   * Returns the element {@code factor} of a study.
   *
   * @throws UsageException S-041 if the text cannot be understood
   */
  static Element factor(String text) {
    int equals = text.indexOf('=');
    if (equals < 1 || text.substring(0, equals).isBlank()) {
      throw refused(text, "it names no parameter");
    }
    List<Attribute> attributes = new ArrayList<>();
    attributes.add(new Attribute("name", text.substring(0, equals).strip()));
    String values = text.substring(equals + 1).strip();
    attributes.addAll(values.contains(":") ? range(text, values) : list(text, values));
    return new Element("factor", attributes, List.of(), SourcePosition.FILE, "");
  }

  private static List<Attribute> list(String text, String values) {
    List<String> all = StudyValue.split(values, ",").stream().map(String::strip).toList();
    if (all.contains("")) {
      throw refused(
          text, values.isEmpty() ? "it has no value" : "a value between commas is missing");
    }
    all.forEach(value -> requireNumber(text, value));
    // blanks separate values, and mean nothing within an expression
    return List.of(
        new Attribute(
            "values", all.stream().map(v -> v.replaceAll("\\s", "")).collect(joining(" "))));
  }

  private static List<Attribute> range(String text, String values) {
    List<String> parts = Arrays.stream(values.split(":", -1)).map(String::strip).toList();
    if (parts.size() != 3) {
      throw refused(text, "a range has three parts, not " + parts.size());
    }
    requireNumber(text, parts.get(0));
    requireNumber(text, parts.get(1));
    int count;
    try {
      count = Integer.parseInt(parts.get(2));
    } catch (NumberFormatException e) {
      throw refused(text, "\"" + parts.get(2) + "\" is no whole number of values");
    }
    if (count < 2) {
      throw refused(text, "a range has 2 values or more, not " + count);
    }
    return List.of(
        new Attribute("from", parts.get(0)),
        new Attribute("to", parts.get(1)),
        new Attribute("count", parts.get(2)));
  }

  private static void requireNumber(String text, String part) {
    try {
      StudyValue.constant(part);
    } catch (IllegalArgumentException e) {
      throw refused(text, String.valueOf(e.getMessage()));
    }
  }

  private static UsageException refused(String text, String why) {
    return new UsageException(
        MessageCode.OPTION_UNUSABLE + " --set " + text + ": " + why + "; " + FORMS);
  }
}
