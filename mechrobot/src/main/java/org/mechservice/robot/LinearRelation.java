package org.mechservice.robot;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * An expression that is a constant and a sum of other expressions with factors.
 *
 * @param factors by expression: positions, velocities, states
 */
record LinearRelation(double constant, Map<Expression, Double> factors) {
  LinearRelation {
    factors = Collections.unmodifiableMap(new LinkedHashMap<>(factors)); // in their order
  }

  /** Returns the factor of an expression, 0 if it is not there. */
  double factor(Expression of) {
    return factors.getOrDefault(of, 0.0);
  }

  private LinearRelation plus(LinearRelation other) {
    Map<Expression, Double> sum = new LinkedHashMap<>(factors);
    other.factors.forEach((of, factor) -> sum.merge(of, factor, Double::sum));
    return new LinearRelation(constant + other.constant, sum);
  }

  private LinearRelation times(double factor) {
    Map<Expression, Double> scaled = new LinkedHashMap<>();
    factors.forEach((of, old) -> scaled.put(of, old * factor));
    return new LinearRelation(constant * factor, scaled);
  }

  /**
   * Returns an expression as such a sum; empty if it is none.
   *
   * @param mechanism whose parameters have their values
   * @param part whether an expression may be a part of the sum
   */
  static Optional<LinearRelation> of(
      Expression expression, Mechanism mechanism, Predicate<Expression> part) {
    if (part.test(expression)) {
      return Optional.of(new LinearRelation(0, Map.of(expression, 1.0)));
    } else if (expression instanceof Expression.Sum sum) {
      return of(sum.left(), mechanism, part)
          .flatMap(a -> of(sum.right(), mechanism, part).map(a::plus));
    } else if (expression instanceof Expression.Negation negation) {
      return of(negation.operand(), mechanism, part).map(a -> a.times(-1));
    } else if (expression instanceof Expression.Product product) {
      Optional<Double> factor = number(product.left(), mechanism);
      return factor.isPresent()
          ? of(product.right(), mechanism, part).map(a -> a.times(factor.get()))
          : number(product.right(), mechanism)
              .flatMap(f -> of(product.left(), mechanism, part).map(a -> a.times(f)));
    } else if (expression instanceof Expression.Quotient quotient) {
      return number(quotient.divisor(), mechanism)
          .filter(divisor -> divisor != 0)
          .flatMap(d -> of(quotient.dividend(), mechanism, part).map(a -> a.times(1 / d)));
    }
    return number(expression, mechanism).map(value -> new LinearRelation(value, Map.of()));
  }

  /** Returns the value of a number or a parameter, and of sums and products of these. */
  static Optional<Double> number(Expression expression, Mechanism mechanism) {
    if (expression instanceof Expression.Constant constant) {
      return Optional.of(constant.value());
    } else if (expression instanceof Expression.ParameterValue parameter) {
      return Optional.of(mechanism.parameters().get(parameter.index()).value());
    } else if (expression instanceof Expression.Negation negation) {
      return number(negation.operand(), mechanism).map(value -> -value);
    } else if (expression instanceof Expression.Sum sum) {
      return number(sum.left(), mechanism)
          .flatMap(a -> number(sum.right(), mechanism).map(b -> a + b));
    } else if (expression instanceof Expression.Product product) {
      return number(product.left(), mechanism)
          .flatMap(a -> number(product.right(), mechanism).map(b -> a * b));
    } else if (expression instanceof Expression.Quotient quotient) {
      return number(quotient.dividend(), mechanism)
          .flatMap(a -> number(quotient.divisor(), mechanism).map(b -> a / b));
    } else if (expression instanceof Expression.Power power) {
      return number(power.base(), mechanism)
          .flatMap(a -> number(power.exponent(), mechanism).map(b -> StrictMath.pow(a, b)));
    }
    return Optional.empty();
  }
}
