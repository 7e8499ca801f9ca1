package org.mechservice.solver.symbol;

import java.util.HashMap;
import java.util.Map;

/**
 * Replaces inputs by expressions, all at once. Results derived for an input, such as a slope, then
 * hold for its expression, however it is simplified.
 */
public final class Substitution {
  private final Expressions expressions;
  private final Map<Scalar, Scalar> images = new HashMap<>();

  /** Replaces {@code input} by {@code value}. */
  public Substitution(Scalar input, Scalar value) {
    this(input.expressions(), Map.of(input, value));
  }

  /** Replaces inputs by values, in which nothing is replaced. */
  public Substitution(Expressions expressions, Map<Scalar, Scalar> values) {
    this.expressions = expressions;
    images.putAll(values);
  }

  /** Returns an expression with the inputs replaced. */
  public Scalar of(Scalar node) {
    Scalar known = images.get(node);
    if (known == null) {
      known = image(node);
      images.put(node, known);
    }
    return known;
  }

  private Scalar image(Scalar node) {
    return switch (node.operation()) {
      case CONSTANT, INPUT -> node;
      case ADD -> of(node.first()).plus(of(node.second()));
      case SUBTRACT -> of(node.first()).minus(of(node.second()));
      case MULTIPLY -> of(node.first()).times(of(node.second()));
      case DIVIDE -> of(node.first()).over(of(node.second()));
      case NEGATE -> of(node.first()).negated();
      case SQUARE_ROOT -> of(node.first()).squareRoot();
      case SINE -> expressions.sine(of(node.first()));
      case COSINE -> expressions.cosine(of(node.first()));
      case FUNCTION -> expressions.function(node, node.operands().stream().map(this::of).toList());
    };
  }
}
