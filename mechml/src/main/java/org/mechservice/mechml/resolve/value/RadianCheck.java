package org.mechservice.mechml.resolve.value;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.mechservice.mechml.expression.ParsedExpression;

/**
 * Finds what gives an expression a value in rad, or in rad/s: a parameter with the unit of an angle
 * or of an angular speed, a coordinate of a joint that turns, an arc function. A factor with PI
 * turns it into degrees, and an angle in a divisor or within a function such as {@code sin} leaves
 * a pure number.
 */
final class RadianCheck {
  private final Predicate<ParsedExpression.Reference> inRadians;

  /**
   * @param inRadians whether a name stands for an angle or an angular speed
   */
  RadianCheck(Predicate<ParsedExpression.Reference> inRadians) {
    this.inRadians = inRadians;
  }

  /** Returns the first name or function that gives the value in rad; empty if none does. */
  Optional<String> source(ParsedExpression part) {
    if (part instanceof ParsedExpression.Reference name) {
      return inRadians.test(name) ? Optional.of(name.text()) : Optional.empty();
    }
    if (part instanceof ParsedExpression.Negation negation) {
      return source(negation.operand());
    }
    if (part instanceof ParsedExpression.Sum sum) {
      return first(sum.parts().stream().map(ParsedExpression.Part::operand).toList());
    }
    if (part instanceof ParsedExpression.Product product) {
      return ofProduct(product.parts());
    }
    return part instanceof ParsedExpression.Call call ? ofCall(call) : Optional.empty();
  }

  private Optional<String> first(List<ParsedExpression> terms) {
    return terms.stream().map(this::source).flatMap(Optional::stream).findFirst();
  }

  private Optional<String> ofProduct(List<ParsedExpression.Part> parts) {
    int power = 0;
    Optional<String> first = Optional.empty();
    for (ParsedExpression.Part part : parts) {
      if (isPi(part.operand())) {
        return Optional.empty();
      }
      Optional<String> source = source(part.operand());
      if (source.isPresent()) {
        power += part.inverse() ? -1 : 1;
        first = first.or(() -> source);
      }
    }
    return power == 1 ? first : Optional.empty();
  }

  private static boolean isPi(ParsedExpression part) {
    return part instanceof ParsedExpression.Reference name
        && (name.text().equals("PI") || name.text().equals("Math.PI"));
  }

  private Optional<String> ofCall(ParsedExpression.Call call) {
    return switch (call.function().units()) {
      case ANGLE, ANGLE_OF_TWO -> Optional.of(call.function().symbol());
      case SAME, COMMON, COUNT -> first(call.arguments());
      case NUMBER, ROOT, POWER -> Optional.empty();
    };
  }
}
