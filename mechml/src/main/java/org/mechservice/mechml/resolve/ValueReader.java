package org.mechservice.mechml.resolve;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MessageCode;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.expression.Evaluation;
import org.mechservice.mechml.expression.ExpressionException;
import org.mechservice.mechml.expression.ExpressionParser;
import org.mechservice.mechml.expression.Scope;
import org.mechservice.mechml.unit.Dimension;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.mechml.unit.UnitException;
import org.mechservice.mechml.unit.UnitParser;
import org.mechservice.mechml.unit.UnitSystem;
import org.mechservice.solver.spatial.Vector3;

/**
 * Reads numeric attributes: expressions to numbers, numbers to SI. What cannot be read is reported
 * and comes back empty.
 */
final class ValueReader {
  private final UnitSystem units;
  private final Scope scope;
  private final Diagnostics diagnostics;

  /**
   * Reads in given units.
   *
   * @param units units of bare numbers
   * @param scope what names in expressions stand for
   * @param diagnostics takes what is wrong
   */
  ValueReader(UnitSystem units, Scope scope, Diagnostics diagnostics) {
    this.units = units;
    this.scope = scope;
    this.diagnostics = diagnostics;
  }

  /** Returns a required pure number. */
  OptionalDouble number(Element element, String attribute) {
    return evaluate(element, attribute, element.required(attribute), 0, Unit.ONE);
  }

  /** Returns a required quantity in SI; the element's {@code unit} counts. */
  OptionalDouble quantity(Element element, String attribute, Dimension dimension) {
    return unit(element, dimension)
        .map(unit -> evaluate(element, attribute, element.required(attribute), 0, unit))
        .orElse(OptionalDouble.empty());
  }

  /** Returns a quantity in SI, zero if the attribute is missing. */
  OptionalDouble quantityOrZero(Element element, String attribute, Dimension dimension) {
    return element.attribute(attribute).isPresent()
        ? quantity(element, attribute, dimension)
        : OptionalDouble.of(0);
  }

  /** Returns three required quantities in SI as a vector. */
  Optional<Vector3> vector(Element element, String x, String y, String z, Dimension dimension) {
    OptionalDouble vx = quantity(element, x, dimension);
    OptionalDouble vy = quantity(element, y, dimension);
    OptionalDouble vz = quantity(element, z, dimension);
    return vx.isPresent() && vy.isPresent() && vz.isPresent()
        ? Optional.of(new Vector3(vx.getAsDouble(), vy.getAsDouble(), vz.getAsDouble()))
        : Optional.empty();
  }

  /**
   * Returns the items of a required list in SI.
   *
   * @param itemUnits one unit per item
   */
  Optional<List<Double>> list(Element element, String attribute, List<Unit> itemUnits) {
    String[] items = element.required(attribute).split(";", -1);
    if (items.length != itemUnits.size()) {
      diagnostics.error(
          MessageCode.VALUE_COUNT,
          element.place(),
          Phrase.of(
              "%s: %s holds %s; %s",
              element.label(),
              attribute,
              items.length == 1 ? "1 value" : items.length + " values",
              itemUnits.size() == 1
                  ? "1 is needed"
                  : itemUnits.size() + " are needed, separated by \";\""));
      return Optional.empty();
    }
    List<Double> values = new ArrayList<>();
    int offset = 0;
    for (int i = 0; i < items.length; i++) {
      evaluate(element, attribute, items[i], offset, itemUnits.get(i)).ifPresent(values::add);
      offset += items[i].length() + 1;
    }
    return values.size() == items.length ? Optional.of(values) : Optional.empty();
  }

  /** Returns the unit of an element's values: its own if it has one, else the file's. */
  Optional<Unit> unit(Element element, Dimension dimension) {
    Optional<String> own = element.attribute("unit");
    if (own.isEmpty()) {
      return Optional.of(units.of(dimension));
    }
    try {
      Unit unit = UnitParser.parse(own.get().strip());
      if (unit.dimension().equals(dimension)) {
        return Optional.of(unit);
      }
      diagnostics.error(
          MessageCode.WRONG_DIMENSION,
          element.place(),
          Phrase.of(
              "%s: the unit %s measures %s, but here stands %s",
              element.label(), Quoted.of(own.get()), unit.dimension(), dimension));
    } catch (UnitException e) {
      diagnostics.error(
          MessageCode.UNKNOWN_UNIT, element.place(), element.label() + ": " + e.reason());
    }
    return Optional.empty();
  }

  private OptionalDouble evaluate(
      Element element, String attribute, String text, int offset, Unit unit) {
    try {
      double value = unit.toSi(Evaluation.of(ExpressionParser.parse(text), scope));
      if (Double.isFinite(value)) {
        return OptionalDouble.of(value + 0.0);
      }
      throw new ExpressionException(MessageCode.EXPRESSION_VALUE, 0, "too large in SI units");
    } catch (ExpressionException e) {
      diagnostics.error(
          e.code(),
          element.place(),
          Phrase.of(
              "%s: in %s=%s at character %d: %s",
              element.label(),
              attribute,
              Quoted.of(element.required(attribute)),
              offset + e.offset() + 1,
              e.reason()));
      return OptionalDouble.empty();
    }
  }
}
