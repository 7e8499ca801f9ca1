package org.mechservice.robot;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.Vector3;

/**
 * Reads numbers in the attributes of a robot's file; reports an invalid number and returns 0 for
 * it.
 */
final class RobotNumbers {
  private static final Pattern DECIMAL =
      Pattern.compile("[+-]?(?:\\d{1,400}\\.?\\d{0,400}|\\.\\d{1,400})(?:[eE][+-]?\\d{1,9})?");
  private static final Pattern BLANKS = Pattern.compile("\\s+");

  private final Diagnostics diagnostics;

  RobotNumbers(Diagnostics diagnostics) {
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
        MessageCode.ROBOT_MISSING,
        element.position(),
        Phrase.of("%s lacks its %s", element.label(), what));
  }

  /** Reports that a joint or pose contradicts itself. */
  void contradiction(Element element, String what) {
    diagnostics.error(MessageCode.ROBOT_JOINT, element.position(), element.label() + ": " + what);
  }

  /** Reports the second and further children of a name where the format has one. */
  void requireOnce(Element element, Collection<String> names) {
    for (String name : names) {
      element.children(name).stream()
          .skip(1)
          .findFirst()
          .ifPresent(
              second ->
                  diagnostics.error(
                      MessageCode.WRONG_CONTENT,
                      second.position(),
                      Phrase.of(
                          "%s: it is the second of its name there; leave one out",
                          second.label())));
    }
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
    Vector3 at = vector(origin.get(), "xyz", Vector3.ZERO);
    Optional<String> quaternion = origin.get().attribute("quat_xyzw");
    if (quaternion.isPresent()) {
      if (origin.get().attribute("rpy").isPresent()) {
        contradiction(origin.get(), "it has rpy and quat_xyzw; leave one out");
      }
      List<Double> e = read(origin.get(), "quat_xyzw", quaternion.get(), 4, 4);
      if (e.stream().allMatch(x -> x == 0)) {
        contradiction(origin.get(), "its quaternion is zero");
      }
      return new Frame(at, Frame.rotation(e.get(3), e.get(0), e.get(1), e.get(2)));
    }
    return Frame.ofRollPitchYaw(at, vector(origin.get(), "rpy", Vector3.ZERO));
  }

  private List<Double> list(Element element, String attribute, int count) {
    return read(element, attribute, element.required(attribute), count, count);
  }

  /** Returns the numbers between the tags of an element. */
  List<Double> text(Element element, int count) {
    return read(element, "its text", element.text(), count, count);
  }

  /** Returns the number between the tags of a child, or its default if the child is missing. */
  double text(Element element, String child, double otherwise) {
    return element.child(child).map(found -> text(found, 1).get(0)).orElse(otherwise);
  }

  /**
   * Reads numbers separated by blanks.
   *
   * @param element where they stand, for messages
   * @param what name of the value in the element
   * @param least smallest count of numbers
   * @param most largest count of numbers
   * @return the numbers; {@code least} zeros after a reported error
   */
  List<Double> read(Element element, String what, String text, int least, int most) {
    List<Double> numbers = new ArrayList<>();
    String stripped = text.strip();
    String[] words = stripped.isEmpty() ? new String[0] : BLANKS.split(stripped, -1);
    for (String word : words) {
      numbers.add(DECIMAL.matcher(word).matches() ? Double.parseDouble(word) : Double.NaN);
    }
    if (numbers.size() < least
        || numbers.size() > most
        || numbers.stream().anyMatch(x -> !Double.isFinite(x))) {
      diagnostics.error(
          MessageCode.ROBOT_NUMBER,
          element.position(),
          Phrase.of(
              "%s: %s is %s; it must be %s",
              element.label(), what, Quoted.of(text), expected(least, most)));
      return Collections.nCopies(least, 0.0);
    }
    return numbers;
  }

  /** Returns up to 20 numbers of an attribute; none if it is missing. */
  List<Double> several(Element element, String attribute) {
    return element
        .attribute(attribute)
        .map(text -> read(element, attribute, text, 0, 20))
        .orElse(List.of());
  }

  private static String expected(int least, int most) {
    if (most == 1) {
      return "a finite number";
    }
    return (least == most ? least + "" : least + " to " + most)
        + " finite numbers separated by blanks";
  }
}
