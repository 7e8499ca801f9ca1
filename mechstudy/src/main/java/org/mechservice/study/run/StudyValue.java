package org.mechservice.study.run;

import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.mechml.unit.UnitException;
import org.mechservice.mechml.unit.UnitParser;

/** Reads numbers and units of a study. */
final class StudyValue {
  private StudyValue() {}

  /** Returns the finite number of an attribute. */
  static double number(Element element, String attribute) throws StudyRefusal {
    String text =
        element
            .attribute(attribute)
            .map(String::strip)
            .orElseThrow(() -> new StudyRefusal("it lacks " + attribute));
    return number(text, attribute);
  }

  /**
   * Returns a finite number.
   *
   * @param what it is, for the message
   */
  static double number(String text, String what) throws StudyRefusal {
    try {
      double value = Double.parseDouble(text.strip());
      if (Double.isFinite(value)) {
        return value;
      }
    } catch (NumberFormatException e) {
      throw new StudyRefusal(what + " \"" + text.strip() + "\" is no number");
    }
    throw new StudyRefusal(what + " \"" + text.strip() + "\" is not finite");
  }

  /** Returns the whole number of an attribute. */
  static int whole(Element element, String attribute, int least) throws StudyRefusal {
    String text = element.attribute(attribute).map(String::strip).orElse("");
    try {
      int value = Integer.parseInt(text);
      if (value >= least) {
        return value;
      }
    } catch (NumberFormatException e) {
      throw new StudyRefusal(
          text.isEmpty()
              ? "it lacks " + attribute
              : attribute + " \"" + text + "\" is no whole number that fits");
    }
    throw new StudyRefusal(attribute + " is " + text + "; it is " + least + " or more");
  }

  static Unit unit(String text) throws StudyRefusal {
    try {
      return UnitParser.parse(text);
    } catch (UnitException e) {
      throw new StudyRefusal("unit " + e.reason());
    }
  }

  /**
   * Returns a number above 0.
   *
   * @param what it is, for the message
   */
  static double positive(String text, String what) throws StudyRefusal {
    double value = number(text, what);
    if (value <= 0) {
      throw new StudyRefusal(what + " is " + text.strip() + "; it must be above 0");
    }
    return value;
  }
}
