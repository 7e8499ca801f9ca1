package org.mechservice.mechml.resolve.value;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.expression.ParsedExpression;
import org.mechservice.mechml.expression.References;
import org.mechservice.mechml.unit.Dimension;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Compares the dimension of an expression with the one that its attribute needs.
 *
 * <p>Only parameters with a unit say what they are; time, coordinates and points are what they are.
 * A number may stand for a quantity, as 9.81 in {@code 9.81*m}, and so may a parameter without a
 * unit: a product with one of them has any dimension, and the check keeps silent about it. Values
 * of functions such as {@code sin} are pure numbers. Angles count as pure numbers, as in {@code
 * r*phi}. Every term of a sum must have the dimension of the sum, so one term with a parameter is
 * enough; terms without a parameter, such as {@code - hinge.v} in a controller with the gain 1, are
 * left alone.
 *
 * <p>A contradiction among parameters and attributes alone is an error. One that involves time or
 * the state may be a gain of 1 that was left out, and is a warning.
 */
public final class DimensionCheck {
  /**
   * The dimension of a part of an expression, as far as it is known.
   *
   * @param dimension with angles left out; empty if it may be anything
   * @param declared whether a parameter with a unit is in it
   * @param measured whether time or the state is in it
   */
  private record Known(Optional<Dimension> dimension, boolean declared, boolean measured) {
    static final Known ANYTHING = new Known(Optional.empty(), false, false);

    static Known number(boolean measured) {
      return new Known(Optional.of(Dimension.NONE), false, measured);
    }

    static Known of(Dimension dimension, boolean declared, boolean measured) {
      Dimension flat = flat(dimension);
      return flat.equals(Dimension.NONE)
          ? number(measured)
          : new Known(Optional.of(flat), declared, measured);
    }

    boolean isNumber() {
      return dimension.equals(Optional.of(Dimension.NONE));
    }
  }

  private final AttributeText text;
  private final ParameterTable parameters;
  private final Function<ParsedExpression.Reference, Optional<Dimension>> state;
  private final Diagnostics diagnostics;

  private DimensionCheck(
      AttributeText text,
      ParameterTable parameters,
      Function<ParsedExpression.Reference, Optional<Dimension>> state,
      Diagnostics diagnostics) {
    this.text = text;
    this.parameters = parameters;
    this.state = state;
    this.diagnostics = diagnostics;
  }

  /**
   * Reports contradictions.
   *
   * @param unit in which the value is read; a pure number stands for a value of any dimension
   * @param state dimension of a name that is no parameter: time, a coordinate, a point; empty if it
   *     may be anything
   */
  public static void check(
      AttributeText text,
      ParsedExpression expression,
      Unit unit,
      ParameterTable parameters,
      Function<ParsedExpression.Reference, Optional<Dimension>> state,
      Diagnostics diagnostics) {
    DimensionCheck check = new DimensionCheck(text, parameters, state, diagnostics);
    Known value = check.known(expression);
    Dimension needed = flat(unit.dimension());
    if (!value.declared()
        || value.isNumber()
        || needed.equals(Dimension.NONE)
        || value.dimension().equals(Optional.of(needed))) {
      return;
    }
    check.report(
        value.measured(),
        Phrase.of(
            "is %s, but %s is needed%s",
            inWords(value.dimension().orElse(needed)),
            unit.dimension(),
            check.unitsOf(expression)));
  }

  private static Dimension flat(Dimension dimension) {
    return new Dimension(dimension.mass(), dimension.length(), dimension.time(), 0);
  }

  private static String inWords(Dimension dimension) {
    String words = dimension.toString();
    return words.startsWith("a") ? words : "of the dimension " + words;
  }

  private Known known(ParsedExpression part) {
    if (part instanceof ParsedExpression.Reference name) {
      return named(name);
    }
    if (part instanceof ParsedExpression.Sum sum) {
      return sum(sum.parts().stream().map(ParsedExpression.Part::operand).toList());
    }
    if (part instanceof ParsedExpression.Product product) {
      return product(product);
    }
    if (part instanceof ParsedExpression.Negation negation) {
      return known(negation.operand());
    }
    if (part instanceof ParsedExpression.Power power) {
      return power(power.base(), power.exponent());
    }
    if (part instanceof ParsedExpression.Call call) {
      return call(call);
    }
    if (part instanceof ParsedExpression.TableCall call) {
      call.arguments().forEach(this::known);
    }
    return Known.ANYTHING;
  }

  private Known named(ParsedExpression.Reference name) {
    if (name.text().equals("PI") || name.text().equals("Math.PI")) {
      return Known.number(false);
    }
    Optional<ResolvedParameter> parameter = parameters.find(name);
    if (parameter.isPresent()) {
      Dimension dimension = parameter.get().unit().dimension();
      return dimension.equals(Dimension.NONE) ? Known.ANYTHING : Known.of(dimension, true, false);
    }
    return state
        .apply(name)
        .map(dimension -> Known.of(dimension, false, true))
        .orElse(Known.ANYTHING);
  }

  /** Terms of a sum, or arguments that are compared. */
  private Known sum(List<ParsedExpression> terms) {
    List<Known> declared = new ArrayList<>();
    boolean measured = false;
    for (ParsedExpression term : terms) {
      Known known = known(term);
      measured |= known.measured();
      if (known.declared() && !known.isNumber()) {
        declared.add(known);
      }
    }
    if (declared.isEmpty()) {
      return Known.ANYTHING;
    }
    Known first = declared.get(0);
    for (Known other : declared) {
      if (!other.dimension().equals(first.dimension())) {
        report(
            first.measured() || other.measured(),
            Phrase.of(
                "adds or compares %s and %s%s",
                first.dimension().orElse(Dimension.NONE),
                other.dimension().orElse(Dimension.NONE),
                unitsOf(terms)));
        return Known.ANYTHING;
      }
    }
    return new Known(first.dimension(), true, measured);
  }

  private Known product(ParsedExpression.Product product) {
    Dimension dimension = Dimension.NONE;
    boolean open = false;
    boolean declared = false;
    boolean measured = false;
    for (ParsedExpression.Part part : product.parts()) {
      Known known = known(part.operand());
      open |= known.dimension().isEmpty();
      declared |= known.declared();
      measured |= known.measured();
      Dimension factor = known.dimension().orElse(Dimension.NONE);
      dimension = dimension.times(part.inverse() ? factor.power(-1) : factor);
    }
    return open ? Known.ANYTHING : Known.of(dimension, declared, measured);
  }

  private Known power(ParsedExpression base, ParsedExpression exponent) {
    Known known = known(base);
    known(exponent);
    return exponent instanceof ParsedExpression.Literal literal
        ? power(known, literal.value())
        : Known.ANYTHING;
  }

  /** Whole powers, and roots of what is a whole power itself. */
  private static Known power(Known base, double exponent) {
    if (base.dimension().isEmpty() || base.isNumber()) {
      return base;
    }
    Dimension d = base.dimension().get();
    long twice = Math.round(2 * exponent);
    boolean whole = twice % 2 == 0;
    boolean even = d.mass() % 2 == 0 && d.length() % 2 == 0 && d.time() % 2 == 0;
    if (twice != 2 * exponent || Math.abs(twice) > 20 || !(whole || even)) {
      return Known.ANYTHING;
    }
    int n = (int) twice;
    return Known.of(
        new Dimension(n * d.mass() / 2, n * d.length() / 2, n * d.time() / 2, 0),
        base.declared(),
        base.measured());
  }

  private Known call(ParsedExpression.Call call) {
    List<ParsedExpression> arguments = call.arguments();
    return switch (call.function().units()) {
      case SAME -> known(arguments.get(0));
      case ROOT -> power(known(arguments.get(0)), 0.5);
      case POWER -> power(arguments.get(0), arguments.get(1));
      case COMMON -> sum(arguments);
      case ANGLE_OF_TWO -> Known.number(sum(arguments).measured());
      case COUNT -> {
        arguments.forEach(this::known);
        yield Known.ANYTHING;
      }
      case NUMBER, ANGLE ->
          Known.number(
              arguments.stream()
                  .map(this::known)
                  .map(Known::measured)
                  .reduce(false, (a, b) -> a || b));
    };
  }

  private String unitsOf(ParsedExpression expression) {
    return unitsOf(List.of(expression));
  }

  /** Returns what the units of the parameters in expressions are. */
  private String unitsOf(List<ParsedExpression> expressions) {
    List<String> units =
        expressions.stream()
            .flatMap(expression -> References.in(expression).stream())
            .map(parameters::find)
            .flatMap(Optional::stream)
            .distinct()
            .limit(6)
            .map(p -> Quoted.of(p.name()) + " in " + p.unitSymbol())
            .toList();
    return units.isEmpty() ? "" : "; the file gives " + String.join(", ", units);
  }

  private void report(boolean measured, String found) {
    String message =
        Phrase.of(
            "%s: %s=%s %s",
            text.element().label(),
            text.attribute(),
            Quoted.of(text.element().required(text.attribute())),
            found);
    if (measured) {
      diagnostics.warning(
          MessageCode.FORMULA_DIMENSION,
          text.element().position(),
          message + ". Write a factor of 1 as a parameter with its unit if one was left out");
    } else {
      diagnostics.error(MessageCode.EXPRESSION_DIMENSION, text.element().position(), message);
    }
  }
}
