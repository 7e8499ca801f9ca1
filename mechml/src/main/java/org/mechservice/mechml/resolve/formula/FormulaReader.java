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
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;

/**
 * Reads attributes whose value may change: to expressions in SI units. What cannot be read is
 * reported and comes back empty.
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

  /** Returns the formula that a text means, its value read in a unit. */
  public Optional<Expression> read(AttributeText text, Unit unit, FormulaRole role) {
    try {
      ParsedExpression parsed = ExpressionParser.parse(text.text());
      if (values.usesWhatIsUnreadable(parsed)) {
        return Optional.empty();
      }
      Expression formula = FormulaTranslation.of(parsed, names, role);
      if (formula instanceof Expression.Constant constant
          && !Double.isFinite(unit.toSi(constant.value()))) {
        throw new ExpressionException(MessageCode.EXPRESSION_VALUE, 0, "too large in SI units");
      }
      values.warnOfDegrees(text, parsed, unit);
      return Optional.of(FormulaNames.toSi(formula, unit));
    } catch (ExpressionException e) {
      values.report(text, e);
      return Optional.empty();
    }
  }

  /** Returns the unit beside an attribute if there is one, else the file's. */
  public Optional<Unit> unit(Element element, String attribute, Quantity quantity) {
    return values.unit(element, attribute, quantity);
  }

  /** Returns a joint's position as formulas see it. */
  public Expression inFileUnits(ResolvedCoordinate place) {
    return names.position(place.joint(), place.component());
  }

  /** Returns an attribute's formula; a unit beside it counts. */
  public Optional<Expression> read(
      Element element, String attribute, Quantity quantity, FormulaRole role) {
    return values
        .unit(element, attribute, quantity)
        .flatMap(unit -> read(AttributeText.of(element, attribute), unit, role));
  }

  /** Returns an attribute's formula, zero if the attribute is missing. */
  Optional<Expression> readOrZero(
      Element element, String attribute, Quantity quantity, FormulaRole role) {
    return element.attribute(attribute).isPresent()
        ? read(element, attribute, quantity, role)
        : Optional.of(Expression.ZERO);
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
   * @param otherwise what holds if the attribute is missing
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
   * @param index the item wanted
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
    return unitOfItem(element, attribute, quantity)
        .flatMap(unit -> read(items.get(index), unit, FormulaRole.COEFFICIENT));
  }

  /** A unit beside a list of several quantities is that of the items it can measure. */
  private Optional<Unit> unitOfItem(Element element, String attribute, Quantity quantity) {
    Optional<String> own = element.attribute(attribute + "Unit");
    if (own.isEmpty()) {
      return Optional.of(values.units().of(quantity));
    }
    boolean single = AttributeText.itemsOf(element, attribute).size() == 1;
    return single
        ? values.unit(element, attribute, quantity)
        : values
            .parse(element, own.get())
            .map(u -> quantity.isMeasuredBy(u) ? u : values.units().of(quantity));
  }

  /** Returns a coefficient that must not be negative, zero if the attribute is missing. */
  public Optional<Expression> notNegative(Element element, String attribute, Quantity quantity) {
    return coefficient(element, attribute, quantity, 0)
        .filter(c -> satisfies(element, attribute, c, x -> x >= 0, "must not be negative"));
  }

  /** Returns a coefficient that must be given and positive. */
  public Optional<Expression> positive(Element element, String attribute, Quantity quantity) {
    return coefficient(element, attribute, quantity, 0)
        .filter(c -> satisfies(element, attribute, c, x -> x > 0, "must be positive"));
  }

  /**
   * Returns whether a coefficient satisfies a condition, and reports it if not; that of a tunable
   * parameter is only known before a run.
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
