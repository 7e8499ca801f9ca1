package org.mechservice.mechml.resolve.simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.mechservice.mechml.AbsoluteTolerances;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.value.AttributeText;
import org.mechservice.mechml.resolve.value.SettingReader;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.solver.catalogue.Accuracy;
import org.mechservice.solver.catalogue.IntegrationMethod;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.ode.IntegratorSettings;

/** Reads {@code integrator}. */
final class IntegratorReader {
  private static final List<String> KNOWN =
      Stream.concat(Stream.of(MethodNames.AUTO), IntegrationMethod.labels().stream().sorted())
          .toList();

  /** Highest order of the Adams formulas with local extrapolation. */
  private static final int HIGHEST_ADAMS_ORDER = 13;

  /** Highest order of the backward differentiation formulas; the next one is unstable. */
  private static final int HIGHEST_BACKWARD_ORDER = 5;

  private final ValueReader values;
  private final SettingReader settings;
  private final Diagnostics diagnostics;

  IntegratorReader(ValueReader values, Diagnostics diagnostics) {
    this.values = values;
    this.settings = new SettingReader(values, diagnostics);
    this.diagnostics = diagnostics;
  }

  /** Returns the integrator; empty after a reported error. */
  Optional<Choice> read(Element element) {
    String name = element.required("name");
    boolean known = isKnown(element, name);
    OptionalDouble relative =
        settings.read(
            element,
            "relTol",
            0,
            x -> x >= IntegratorSettings.SMALLEST_RELATIVE_TOLERANCE && x < 1,
            "must lie between " + IntegratorSettings.SMALLEST_RELATIVE_TOLERANCE + " and 1");
    Optional<AbsoluteTolerances> absolute = absoluteTolerances(element);
    OptionalDouble maxStep = positive(element, "maxStep", Double.POSITIVE_INFINITY);
    OptionalDouble initialStep = positive(element, "initialStep", 0);
    OptionalDouble maxOrder = maxOrder(element, name);
    boolean tolerances = relative.isPresent() && absolute.isPresent();
    boolean bounds = maxStep.isPresent() && initialStep.isPresent() && maxOrder.isPresent();
    return known && tolerances && bounds
        ? Optional.of(
            new Choice(
                name,
                relative.getAsDouble(),
                absolute.get(),
                maxStep.getAsDouble(),
                initialStep.getAsDouble(),
                (int) maxOrder.getAsDouble(),
                element.attribute(Accuracy.OPTION).map(Accuracy::of).orElse(Accuracy.STANDARD)))
        : Optional.empty();
  }

  private boolean isKnown(Element element, String name) {
    if (KNOWN.contains(name)) {
      return true;
    }
    diagnostics.error(
        MessageCode.UNKNOWN_INTEGRATOR,
        element.position(),
        Phrase.of(
            "there is no integrator %s%s",
            Quoted.of(name),
            NearestName.of(name, KNOWN)
                .map(n -> "; did you mean " + Quoted.of(n) + "?")
                .orElse("; there are " + String.join(", ", KNOWN))));
    return false;
  }

  private OptionalDouble positive(Element element, String attribute, double open) {
    return settings.read(element, attribute, open, x -> x > 0, "must be positive");
  }

  private static boolean isBackward(String name) {
    return IntegrationMethod.find(name)
        .filter(method -> method.family() == IntegrationMethod.Family.BACKWARD)
        .isPresent();
  }

  private OptionalDouble maxOrder(Element element, String name) {
    int highest = isBackward(name) ? HIGHEST_BACKWARD_ORDER : HIGHEST_ADAMS_ORDER;
    return settings.read(
        element,
        "maxOrder",
        0,
        x -> x >= 1 && x <= highest && x == Math.rint(x),
        "must be a whole number from 1 to " + highest);
  }

  private Optional<AbsoluteTolerances> absoluteTolerances(Element element) {
    List<AttributeText> items = AttributeText.itemsOf(element, "absTol");
    if (items.size() != 1 && items.size() != 4) {
      diagnostics.error(
          MessageCode.VALUE_COUNT,
          element.position(),
          Phrase.of(
              "%s: absTol holds %d values; 1 is needed, or 4 separated by \";\": for positions,"
                  + " angles, velocities and angular velocities",
              element.label(), items.size()));
      return Optional.empty();
    }
    List<Double> tolerances = new ArrayList<>();
    for (AttributeText item : items) {
      OptionalDouble tolerance = values.evaluate(item, Unit.ONE);
      if (tolerance.isPresent() && tolerance.getAsDouble() < Double.MIN_NORMAL) {
        settings.report(element, "absTol", tolerance.getAsDouble(), "must be positive");
      } else {
        tolerance.ifPresent(tolerances::add);
      }
    }
    if (tolerances.size() < items.size()) {
      return Optional.empty();
    }
    return Optional.of(
        tolerances.size() == 1
            ? AbsoluteTolerances.uniform(tolerances.get(0))
            : new AbsoluteTolerances(
                tolerances.get(0), tolerances.get(1), tolerances.get(2), tolerances.get(3)));
  }

  /**
   * An integrator and its settings, as {@link org.mechservice.solver.api.run.RunSettings} defines
   * them.
   *
   * @param name as the file gives it
   * @param relativeTolerance between 0 and 1
   * @param absoluteTolerances positive, SI
   * @param maxStep s; infinite if not given
   * @param initialStep s; 0 if not given
   * @param maxOrder 0 if not given
   * @param accuracy standard if not given
   */
  record Choice(
      String name,
      double relativeTolerance,
      AbsoluteTolerances absoluteTolerances,
      double maxStep,
      double initialStep,
      int maxOrder,
      Accuracy accuracy) {}
}
