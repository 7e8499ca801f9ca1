package org.mechservice.mechml.resolve.value;

import java.util.OptionalDouble;
import java.util.function.DoublePredicate;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.catalogue.MessageCode;

/** Reads pure numbers that must satisfy a condition. */
public final class SettingReader {
  private final ValueReader values;
  private final Diagnostics diagnostics;

  public SettingReader(ValueReader values, Diagnostics diagnostics) {
    this.values = values;
    this.diagnostics = diagnostics;
  }

  /**
   * Returns the number of an attribute.
   *
   * @param open default if the attribute is missing
   * @param condition what the number must satisfy
   * @param rule the condition in words, such as {@code must be positive}
   */
  public OptionalDouble read(
      Element element, String attribute, double open, DoublePredicate condition, String rule) {
    if (element.attribute(attribute).isEmpty()) {
      return OptionalDouble.of(open);
    }
    OptionalDouble value = values.number(element, attribute);
    if (value.isPresent() && !condition.test(value.getAsDouble())) {
      report(element, attribute, value.getAsDouble(), rule);
      return OptionalDouble.empty();
    }
    return value;
  }

  public void report(Element element, String attribute, double value, String rule) {
    diagnostics.error(
        MessageCode.INTEGRATOR_SETTING,
        element.position(),
        Phrase.of("%s: %s is %s; it %s", element.label(), attribute, value, rule));
  }
}
