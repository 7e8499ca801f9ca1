package org.mechservice.mechml.resolve;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.DoublePredicate;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MessageCode;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.integration.IntegratorSettings;

/** Reads {@code integrator}. */
final class IntegratorReader {
  private static final List<String> KNOWN = List.of("DE", "ode113");

  /** Order of the Adams formulas with local extrapolation at its highest. */
  private static final int HIGHEST_ORDER = 13;

  private final ValueReader values;
  private final Diagnostics diagnostics;

  IntegratorReader(ValueReader values, Diagnostics diagnostics) {
    this.values = values;
    this.diagnostics = diagnostics;
  }

  /** Returns the integrator; empty if something was wrong and has been reported. */
  Optional<IntegratorChoice> read(Element element) {
    String name = element.required("name");
    boolean known = KNOWN.contains(name);
    if (!known) {
      diagnostics.error(
          MessageCode.UNKNOWN_INTEGRATOR,
          element.place(),
          Phrase.of("there is no integrator %s; this version has DE and ode113", Quoted.of(name)));
    }
    OptionalDouble relative =
        checked(
            element,
            "relTol",
            0,
            x -> x >= IntegratorSettings.SMALLEST_RELATIVE_TOLERANCE && x < 1,
            "must lie between " + IntegratorSettings.SMALLEST_RELATIVE_TOLERANCE + " and 1");
    OptionalDouble absolute =
        checked(element, "absTol", 0, x -> x >= Double.MIN_NORMAL, "must be positive");
    OptionalDouble maxStep =
        checked(element, "maxStep", Double.POSITIVE_INFINITY, x -> x > 0, "must be positive");
    OptionalDouble initialStep = checked(element, "initialStep", 0, x -> x > 0, "must be positive");
    OptionalDouble maxOrder =
        checked(
            element,
            "maxOrder",
            0,
            x -> x >= 1 && x <= HIGHEST_ORDER && x == Math.rint(x),
            "must be a whole number from 1 to " + HIGHEST_ORDER);
    boolean tolerances = relative.isPresent() && absolute.isPresent();
    boolean bounds = maxStep.isPresent() && initialStep.isPresent() && maxOrder.isPresent();
    return known && tolerances && bounds
        ? Optional.of(
            new IntegratorChoice(
                name,
                relative.getAsDouble(),
                absolute.getAsDouble(),
                maxStep.getAsDouble(),
                initialStep.getAsDouble(),
                (int) maxOrder.getAsDouble()))
        : Optional.empty();
  }

  /** Returns a number that satisfies a condition; the open value if the attribute is missing. */
  private OptionalDouble checked(
      Element element, String attribute, double open, DoublePredicate condition, String rule) {
    if (element.attribute(attribute).isEmpty()) {
      return OptionalDouble.of(open);
    }
    OptionalDouble value = values.number(element, attribute);
    if (value.isPresent() && !condition.test(value.getAsDouble())) {
      diagnostics.error(
          MessageCode.INTEGRATOR_SETTING,
          element.place(),
          Phrase.of("%s: %s is %s; it %s", element.label(), attribute, value.getAsDouble(), rule));
      return OptionalDouble.empty();
    }
    return value;
  }
}
