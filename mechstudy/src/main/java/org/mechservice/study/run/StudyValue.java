package org.mechservice.study.run;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.expression.ConstantEvaluation;
import org.mechservice.mechml.expression.ExpressionException;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.mechml.unit.UnitException;
import org.mechservice.mechml.unit.UnitParser;

/** Reads numbers and units of a study. */
public final class StudyValue {
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
   * Returns the value of a number or of a constant expression of the model's language, such as
   * {@code PI/4}.
   *
   * @throws IllegalArgumentException if it has no finite value; says why
   */
  public static double constant(String text) {
    String word = text.strip();
    double value;
    try {
      value = Double.parseDouble(word);
    } catch (NumberFormatException notPlain) {
      try {
        return ConstantEvaluation.of(word);
      } catch (ExpressionException e) {
        throw new IllegalArgumentException(
            '"' + word + "\" is no number and no constant expression: " + e.reason(), e);
      }
    }
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException('"' + word + "\" is not finite");
    }
    return value;
  }

  /**
   * Returns the texts between separators that are not within brackets.
   *
   * @param separators characters
   */
  public static List<String> split(String text, String separators) {
    List<String> words = new ArrayList<>();
    StringBuilder word = new StringBuilder();
    int depth = 0;
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      depth += c == '(' ? 1 : c == ')' ? -1 : 0;
      if (depth <= 0 && separators.indexOf(c) >= 0) {
        words.add(word.toString());
        word.setLength(0);
      } else {
        word.append(c);
      }
    }
    words.add(word.toString());
    return words;
  }

  /**
   * Returns the finite value of a number or a constant expression.
   *
   * @param what it is, for the message
   */
  static double number(String text, String what) throws StudyRefusal {
    try {
      return constant(text);
    } catch (IllegalArgumentException e) {
      throw new StudyRefusal(what + " " + e.getMessage());
    }
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
