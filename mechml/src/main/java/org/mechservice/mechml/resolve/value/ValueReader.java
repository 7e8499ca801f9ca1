package org.mechservice.mechml.resolve.value;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Predicate;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.expression.ConstantEvaluation;
import org.mechservice.mechml.expression.ExpressionException;
import org.mechservice.mechml.expression.ExpressionParser;
import org.mechservice.mechml.expression.ParsedExpression;
import org.mechservice.mechml.expression.References;
import org.mechservice.mechml.unit.Dimension;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.mechml.unit.UnitException;
import org.mechservice.mechml.unit.UnitParser;
import org.mechservice.mechml.unit.UnitSystem;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.Vector3;

/**
 * Reads numeric attributes: evaluates expressions and converts to SI. A method that finds an error
 * reports it and returns an empty result.
 */
public final class ValueReader {
  private final UnitSystem units;
  private final ParameterTable parameters;
  private final Diagnostics diagnostics;

  /**
   * Reads in given units.
   *
   * @param units units of bare numbers
   * @param parameters values of the names in expressions
   * @param diagnostics receives errors and warnings
   */
  public ValueReader(UnitSystem units, ParameterTable parameters, Diagnostics diagnostics) {
    this.units = units;
    this.parameters = parameters;
    this.diagnostics = diagnostics;
  }

  /** Returns the units of bare numbers. */
  public UnitSystem units() {
    return units;
  }

  /** Returns the parameters of the model. */
  public ParameterTable parameters() {
    return parameters;
  }

  /** Returns a required pure number. */
  public OptionalDouble number(Element element, String attribute) {
    return evaluate(AttributeText.of(element, attribute), Unit.ONE);
  }

  /** Returns a required quantity in SI, read in the unit given beside it if there is one. */
  public OptionalDouble quantity(Element element, String attribute, Quantity quantity) {
    return unit(element, attribute, quantity)
        .map(unit -> evaluate(AttributeText.of(element, attribute), unit))
        .orElse(OptionalDouble.empty());
  }

  /** Returns a quantity in SI, a default if the attribute is missing. */
  OptionalDouble quantityOr(
      double otherwise, Element element, String attribute, Quantity quantity) {
    return element.attribute(attribute).isPresent()
        ? quantity(element, attribute, quantity)
        : OptionalDouble.of(otherwise);
  }

  /** Returns a quantity in SI, zero if the attribute is missing. */
  public OptionalDouble quantityOrZero(Element element, String attribute, Quantity quantity) {
    return quantityOr(0, element, attribute, quantity);
  }

  /** Returns three required quantities in SI as a vector. */
  public Optional<Vector3> vector(
      Element element, String x, String y, String z, Quantity quantity) {
    OptionalDouble vx = quantity(element, x, quantity);
    OptionalDouble vy = quantity(element, y, quantity);
    OptionalDouble vz = quantity(element, z, quantity);
    return vx.isPresent() && vy.isPresent() && vz.isPresent()
        ? Optional.of(new Vector3(vx.getAsDouble(), vy.getAsDouble(), vz.getAsDouble()))
        : Optional.empty();
  }

  /** Returns a required list of three quantities in SI as a vector. */
  public Optional<Vector3> triple(Element element, String attribute, Quantity quantity) {
    return unit(element, attribute, quantity)
        .flatMap(unit -> list(element, attribute, List.of(unit, unit, unit)))
        .map(items -> new Vector3(items.get(0), items.get(1), items.get(2)));
  }

  /**
   * Returns the items of a required list in SI.
   *
   * @param itemUnits one unit per item
   */
  public Optional<List<Double>> list(Element element, String attribute, List<Unit> itemUnits) {
    List<AttributeText> items = AttributeText.itemsOf(element, attribute);
    if (!hasCount(items, itemUnits.size())) {
      return Optional.empty();
    }
    List<Double> values = new ArrayList<>();
    for (int i = 0; i < items.size(); i++) {
      evaluate(items.get(i), itemUnits.get(i)).ifPresent(values::add);
    }
    return values.size() == items.size() ? Optional.of(values) : Optional.empty();
  }

  /** Returns whether a list has the needed number of items; reports an error if not. */
  public boolean hasCount(List<AttributeText> items, int needed) {
    if (items.size() == needed) {
      return true;
    }
    AttributeText first = items.get(0);
    diagnostics.error(
        MessageCode.VALUE_COUNT,
        first.element().position(),
        Phrase.of(
            "%s: %s holds %s; %s",
            first.element().label(),
            first.attribute(),
            items.size() == 1 ? "1 value" : items.size() + " values",
            switch (needed) {
              case 0 -> "none is needed";
              case 1 -> "1 is needed";
              default -> needed + " are needed, separated by \";\"";
            }));
    return false;
  }

  /** Returns the unit of an attribute's values: the unit given beside it, else the file's unit. */
  public Optional<Unit> unit(Element element, String attribute, Quantity quantity) {
    Optional<String> text = unitText(element, attribute);
    if (text.isEmpty()) {
      return Optional.of(units.of(quantity));
    }
    Optional<Unit> own = parse(element, text.get());
    if (own.isPresent() && !quantity.isMeasuredBy(own.get())) {
      diagnostics.error(
          MessageCode.WRONG_DIMENSION,
          element.position(),
          Phrase.of(
              "%s: the unit %s measures %s, but %s is needed",
              element.label(), Quoted.of(text.get()), own.get().dimension(), quantity.dimension()));
      return Optional.empty();
    }
    return own;
  }

  /**
   * Returns the unit of an item of a list. A unit beside a list of several quantities applies to
   * the items of its dimension.
   */
  public Optional<Unit> unitOfItem(Element element, String attribute, Quantity quantity) {
    Optional<String> own = element.attribute(attribute + "Unit");
    if (own.isEmpty()) {
      return Optional.of(units.of(quantity));
    }
    boolean single = AttributeText.itemsOf(element, attribute).size() == 1;
    return single
        ? unit(element, attribute, quantity)
        : parse(element, own.get()).map(u -> quantity.isMeasuredBy(u) ? u : units.of(quantity));
  }

  /** Returns the text of the unit beside an attribute. */
  private static Optional<String> unitText(Element element, String attribute) {
    return element.attribute(attribute + "Unit").or(() -> element.attribute("unit"));
  }

  /** Parses a unit; reports an unknown one. */
  public Optional<Unit> parse(Element element, String text) {
    try {
      return Optional.of(UnitParser.parse(text.strip()));
    } catch (UnitException e) {
      diagnostics.error(
          MessageCode.UNKNOWN_UNIT, element.position(), element.label() + ": " + e.reason());
      return Optional.empty();
    }
  }

  /** Returns the value of a constant expression in SI. */
  public OptionalDouble evaluate(AttributeText text, Unit unit) {
    try {
      ParsedExpression expression = ExpressionParser.parse(text.text());
      if (usesWhatIsUnreadable(expression)) {
        return OptionalDouble.empty();
      }
      double value = unit.toSi(ConstantEvaluation.of(expression, parameters));
      if (!Double.isFinite(value)) {
        throw new ExpressionException(MessageCode.EXPRESSION_VALUE, 0, "too large in SI units");
      }
      warnOfDegrees(text, expression, unit, name -> false);
      DimensionCheck.check(
          text, expression, unit, parameters, name -> Optional.empty(), diagnostics);
      return OptionalDouble.of(value + 0.0);
    } catch (ExpressionException e) {
      report(text, e);
      return OptionalDouble.empty();
    }
  }

  /** Returns whether an expression uses a parameter with a reported error. */
  public boolean usesWhatIsUnreadable(ParsedExpression expression) {
    return References.in(expression).stream()
        .anyMatch(reference -> parameters.isUnreadable(reference.text()));
  }

  /** Reports an expression that cannot be read or has no value. */
  public void report(AttributeText text, ExpressionException e) {
    diagnostics.error(
        e.code(),
        text.element().position(),
        Phrase.of(
            "%s: in %s=%s at character %d: %s",
            text.element().label(),
            text.attribute(),
            Quoted.of(text.element().required(text.attribute())),
            text.offset() + e.offset() + 1,
            e.reason()));
  }

  /**
   * Warns of a value in rad, as expressions have angles, in an attribute that is read in degrees.
   *
   * @param inRadians whether a name that is no parameter stands for an angle or an angular speed
   */
  public void warnOfDegrees(
      AttributeText text,
      ParsedExpression expression,
      Unit unit,
      Predicate<ParsedExpression.Reference> inRadians) {
    if (unit.dimension().angle() != 1 || unit.numerator() == unit.denominator()) {
      return;
    }
    String read = unit.dimension().equals(Dimension.ANGLE) ? "deg" : "deg/s";
    RadianCheck check =
        new RadianCheck(
            name ->
                parameters
                    .find(name)
                    .map(ResolvedParameter::isOfAngles)
                    .orElseGet(() -> inRadians.test(name)));
    check
        .source(expression)
        .ifPresent(
            source ->
                diagnostics.warning(
                    MessageCode.ANGLE_IN_DEGREES,
                    text.element().position(),
                    Phrase.of(
                        "%s: %s is in rad in expressions, but %s is read in %s; add unit=\"rad\"",
                        text.element().label(), Quoted.of(source), text.attribute(), read)));
  }
}
