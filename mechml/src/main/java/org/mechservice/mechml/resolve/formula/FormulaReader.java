package org.mechservice.mechml.resolve.formula;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.DoublePredicate;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.expression.ExpressionException;
import org.mechservice.mechml.expression.ExpressionParser;
import org.mechservice.mechml.expression.ParsedExpression;
import org.mechservice.mechml.resolve.value.AttributeText;
import org.mechservice.mechml.resolve.value.DimensionCheck;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;

/**
 * Reads attributes whose value may change during a run into expressions in SI units. A method that
 * finds an error reports it and returns an empty result.
 */
public final class FormulaReader {
  private final ValueReader values;
  private final FormulaNames names;
  private final Diagnostics diagnostics;

  public FormulaReader(ValueReader values, MechanismNames names, Diagnostics diagnostics) {
    this.values = values;
    this.names = new FormulaNames(names, values.parameters(), values.units());
    this.diagnostics = diagnostics;
  }

  /** Returns the formula of a text whose value is in a given unit. */
  public Optional<Expression> read(AttributeText text, Unit unit, FormulaRole role) {
    try {
      ParsedExpression parsed = ExpressionParser.parse(text.text(), names.argumentCounts());
      if (values.usesWhatIsUnreadable(parsed)) {
        return Optional.empty();
      }
      Expression formula = FormulaTranslation.of(parsed, names, role);
      if (formula instanceof Expression.Constant constant
          && !Double.isFinite(unit.toSi(constant.value()))) {
        throw new ExpressionException(MessageCode.EXPRESSION_VALUE, 0, "too large in SI units");
      }
      values.warnOfDegrees(text, parsed, unit, names::isInRadians);
      DimensionCheck.check(text, parsed, unit, values.parameters(), names::dimension, diagnostics);
      return Optional.of(FormulaNames.toSi(formula, unit));
    } catch (ExpressionException e) {
      values.report(text, e);
      return Optional.empty();
    }
  }

  /** Returns the unit given beside an attribute, else the file's unit. */
  public Optional<Unit> unit(Element element, String attribute, Quantity quantity) {
    return values.unit(element, attribute, quantity);
  }

  /** Returns a joint's position in the units of formulas. */
  public Expression inFileUnits(ResolvedCoordinate place) {
    return names.position(place.joint(), place.component());
  }

  /** Returns an attribute's formula, in the unit given beside it if there is one. */
  public Optional<Expression> read(
      Element element, String attribute, Quantity quantity, FormulaRole role) {
    return values
        .unit(element, attribute, quantity)
        .flatMap(unit -> read(AttributeText.of(element, attribute), unit, role));
  }

  /** Returns the formulas of a list, one per unit. */
  public Optional<List<Expression>> list(
      Element element, String attribute, List<Unit> units, FormulaRole role) {
    List<AttributeText> items = AttributeText.itemsOf(element, attribute);
    if (!values.hasCount(items, units.size())) {
      return Optional.empty();
    }
    List<Expression> formulas = new ArrayList<>();
    for (int i = 0; i < items.size(); i++) {
      read(items.get(i), units.get(i), role).ifPresent(formulas::add);
    }
    return formulas.size() == items.size() ? Optional.of(formulas) : Optional.empty();
  }

  /**
   * Returns a coefficient: a constant or a formula of tunable parameters.
   *
   * @param otherwise default if the attribute is missing
   */
  public Optional<Expression> coefficient(
      Element element, String attribute, Quantity quantity, double otherwise) {
    return element.attribute(attribute).isPresent()
        ? read(element, attribute, quantity, FormulaRole.COEFFICIENT)
        : Optional.of(new Expression.Constant(otherwise));
  }

  /**
   * Returns an item of a list of coefficients, zero if the attribute is missing.
   *
   * @param count how many items the list must have
   * @param index index of the item
   */
  public Optional<Expression> item(
      Element element, String attribute, int count, int index, Quantity quantity) {
    if (element.attribute(attribute).isEmpty()) {
      return Optional.of(Expression.ZERO);
    }
    List<AttributeText> items = AttributeText.itemsOf(element, attribute);
    if (!values.hasCount(items, count)) {
      return Optional.empty();
    }
    return values
        .unitOfItem(element, attribute, quantity)
        .flatMap(unit -> read(items.get(index), unit, FormulaRole.COEFFICIENT));
  }

  /** Returns a coefficient that must not be negative, zero if the attribute is missing. */
  public Optional<Expression> notNegative(Element element, String attribute, Quantity quantity) {
    return coefficient(element, attribute, quantity, 0)
        .filter(c -> satisfies(element, attribute, c, x -> x >= 0, "must not be negative"));
  }

  /** Returns a required positive coefficient. */
  public Optional<Expression> positive(Element element, String attribute, Quantity quantity) {
    return coefficient(element, attribute, quantity, 0)
        .filter(c -> satisfies(element, attribute, c, x -> x > 0, "must be positive"));
  }

  /**
   * Returns whether a coefficient satisfies a condition, and reports an error if not. The value of
   * a tunable parameter is checked before a run.
   */
  public boolean satisfies(
      Element element,
      String attribute,
      Expression coefficient,
      DoublePredicate condition,
      String rule) {
    if (!(coefficient instanceof Expression.Constant constant)
        || condition.test(constant.value())) {
      return true;
    }
    String found = element.attribute(attribute).isEmpty() ? "is missing" : "is " + constant.value();
    diagnostics.error(
        MessageCode.FORCE_VALUE,
        element.position(),
        Phrase.of("%s: %s %s; it %s", element.label(), attribute, found, rule));
    return false;
  }
}
