package org.mechservice.sim.symbolic;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Derivatives of expressions along a direction: the direction tells how fast some nodes change, and
 * every other node changes as the nodes it is made of. Equal derivatives are one node, so a
 * derivative costs little more than the expression.
 */
public final class Differentiation {
  private final Expressions expressions;
  private final Map<Scalar, Scalar> rates;

  /**
   * Takes a direction.
   *
   * @param rates how fast inputs, or any other nodes, change; what is not in it and not made of
   *     what is does not change; not modified
   */
  public Differentiation(Expressions expressions, Map<Scalar, Scalar> rates) {
    this.expressions = expressions;
    this.rates = new HashMap<>(rates);
  }

  /** Returns how fast an expression changes. */
  public Scalar of(Scalar value) {
    List<Scalar> open = new ArrayList<>();
    open.add(value);
    // operands first; a stack of our own, since graphs are deep
    while (!open.isEmpty()) {
      Scalar node = open.get(open.size() - 1);
      int before = open.size();
      if (!rates.containsKey(node)) {
        for (Scalar operand : node.operands()) {
          if (!rates.containsKey(operand)) {
            open.add(operand);
          }
        }
      }
      if (open.size() == before) {
        open.remove(before - 1);
        rates.computeIfAbsent(node, this::rate);
      }
    }
    return known(value);
  }

  private Scalar known(Scalar node) {
    return rates.getOrDefault(node, expressions.zero());
  }

  private Scalar rate(Scalar node) {
    return switch (node.operation()) {
      case CONSTANT, INPUT -> expressions.zero();
      case ADD -> known(node.first()).plus(known(node.second()));
      case SUBTRACT -> known(node.first()).minus(known(node.second()));
      case NEGATE -> known(node.first()).negated();
      case MULTIPLY ->
          known(node.first()).times(node.second()).plus(node.first().times(known(node.second())));
      case DIVIDE ->
          known(node.first()).minus(node.times(known(node.second()))).over(node.second());
      case SQUARE_ROOT -> known(node.first()).times(0.5).over(FunctionSlopes.awayFromZero(node));
      case SINE -> expressions.cosine(node.first()).times(known(node.first()));
      case COSINE -> expressions.sine(node.first()).times(known(node.first())).negated();
      case FUNCTION -> function(node);
    };
  }

  private Scalar function(Scalar node) {
    return switch (node.function()) {
      case CHOOSE ->
          chosen(node.first(), node.second(), node.operands().get(2), node.operands().get(3));
      case MIN -> chosen(node.first(), node.second(), node.first(), node.second());
      case MAX -> chosen(node.second(), node.first(), node.first(), node.second());
      default -> bySlopes(node);
    };
  }

  /** What is not chosen does not count, even where it has no slope. */
  private Scalar chosen(Scalar a, Scalar b, Scalar first, Scalar second) {
    return expressions.function(MathFunction.CHOOSE, a, b, known(first), known(second));
  }

  private Scalar bySlopes(Scalar node) {
    Scalar sum = expressions.zero();
    for (int i = 0; i < node.operands().size(); i++) {
      Scalar inner = known(node.operands().get(i));
      if (!inner.isZero()) {
        sum = sum.plus(FunctionSlopes.slope(node, i).times(inner));
      }
    }
    return sum;
  }
}
