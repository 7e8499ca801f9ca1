package org.mechservice.mechml.urdf;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.urdf.UrdfRobot.Frame;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.Vector3;

/**
 * Reads numbers in the attributes of a robot's file; reports an invalid number and returns 0 for
 * it.
 */
final class UrdfNumbers {
  private static final Pattern DECIMAL =
      Pattern.compile("[+-]?(?:\\d{1,400}\\.?\\d{0,400}|\\.\\d{1,400})(?:[eE][+-]?\\d{1,9})?");
  private static final Pattern BLANKS = Pattern.compile("\\s+");

  private final Diagnostics diagnostics;

  UrdfNumbers(Diagnostics diagnostics) {
    this.diagnostics = diagnostics;
  }

  /** Returns a required number. */
  double required(Element element, String attribute) {
    if (element.attribute(attribute).isEmpty()) {
      missing(element, "attribute " + attribute);
    }
    return optional(element, attribute, 0);
  }

  /** Reports that something is missing in an element. */
  void missing(Element element, String what) {
    diagnostics.error(
        MessageCode.URDF_MISSING,
        element.position(),
        Phrase.of("%s lacks its %s", element.label(), what));
  }

  /** Returns a number, or its default if it is missing. */
  double optional(Element element, String attribute, double otherwise) {
    return element.attribute(attribute).isEmpty() ? otherwise : list(element, attribute, 1).get(0);
  }

  /** Returns three numbers, or their default if they are missing. */
  Vector3 vector(Element element, String attribute, Vector3 otherwise) {
    if (element.attribute(attribute).isEmpty()) {
      return otherwise;
    }
    List<Double> xyz = list(element, attribute, 3);
    return new Vector3(xyz.get(0), xyz.get(1), xyz.get(2));
  }

  /** Returns the frame that the child {@code origin} of an element gives. */
  Frame origin(Element element) {
    Optional<Element> origin = element.child("origin");
    if (origin.isEmpty()) {
      return Frame.SAME;
    }
    return new Frame(
        vector(origin.get(), "xyz", Vector3.ZERO), vector(origin.get(), "rpy", Vector3.ZERO));
  }

  private List<Double> list(Element element, String attribute, int count) {
    String text = element.required(attribute);
    List<Double> numbers = new ArrayList<>();
    String stripped = text.strip();
    String[] words = stripped.isEmpty() ? new String[0] : BLANKS.split(stripped, -1);
    for (String word : words) {
      numbers.add(DECIMAL.matcher(word).matches() ? Double.parseDouble(word) : Double.NaN);
    }
    if (numbers.size() != count || numbers.stream().anyMatch(x -> !Double.isFinite(x))) {
      diagnostics.error(
          MessageCode.URDF_NUMBER,
          element.position(),
          Phrase.of(
              "%s: %s is %s; it must be %s",
              element.label(),
              attribute,
              Quoted.of(text),
              count == 1 ? "a finite number" : count + " finite numbers separated by blanks"));
      return List.of(0.0, 0.0, 0.0).subList(0, count);
    }
    return numbers;
  }
}
