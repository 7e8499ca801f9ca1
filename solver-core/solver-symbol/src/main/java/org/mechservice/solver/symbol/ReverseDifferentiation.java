package org.mechservice.solver.symbol;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.IntConsumer;

/**
 * The gradient of a weighted sum of expressions by every node below them: reverse mode. For values
 * y with weights λ it gives Jᵀλ, where {@link Differentiation} gives Jd for a direction d. One
 * sweep from the values down to the inputs costs a few times the values, however many inputs there
 * are.
 *
 * <p>Source: A. Griewank, A. Walther, Evaluating Derivatives, 2nd edition, SIAM 2008, chapter 3.
 */
public final class ReverseDifferentiation {
  private final Expressions expressions;

  /** Derivative of the sum by each node, as far as the sweep has come. */
  private final Map<Scalar, Scalar> slopes;

  /**
   * Nodes below one that may not be chosen, or whose slope may be infinite: a slope or factor 0
   * must stay 0 there.
   */
  private final Set<Scalar> guardedNodes = new HashSet<>();

  /**
   * Records the derivatives of Σ weight · value.
   *
   * @param weights weight of each value; a weight may be an expression, which counts as constant;
   *     not modified
   */
  public ReverseDifferentiation(Expressions expressions, Map<Scalar, Scalar> weights) {
    this(expressions, weights, id -> {});
  }

  private ReverseDifferentiation(
      Expressions expressions, Map<Scalar, Scalar> weights, IntConsumer before) {
    this.expressions = expressions;
    this.slopes = new HashMap<>(weights);
    int last = weights.keySet().stream().mapToInt(Scalar::id).max().orElse(-1);
    // an operand is older than what is made of it, so every slope is complete when it is used
    for (int id = last; id >= 0; id--) {
      before.accept(id);
      Scalar node = expressions.node(id);
      Scalar slope = by(node);
      if (!slope.isZero()) {
        passOn(node, slope);
      }
    }
  }

  /**
   * Records the derivatives for values of a program, by those of each section in one of their own,
   * so that sections which compute the same have derivatives that compute the same.
   *
   * @param into a program of the same graph, after whose sections the new ones come
   */
  public static ReverseDifferentiation sections(
      Program program, Map<Scalar, Scalar> weights, Program into) {
    Deque<Program.Section> left = new ArrayDeque<>(program.sections());
    return new ReverseDifferentiation(
        program.expressions(),
        weights,
        id -> {
          while (!left.isEmpty() && id < left.getLast().firstNode()) {
            left.removeLast();
            if (!left.isEmpty()) {
              Program.Section section = left.getLast();
              into.section("Derivatives by: " + section.title(), section.subject());
            }
          }
        });
  }

  /** Returns the derivative of the weighted sum by a node; 0 if it does not depend on the node. */
  public Scalar by(Scalar node) {
    return slopes.getOrDefault(node, expressions.zero());
  }

  private void add(Scalar operand, Scalar slope) {
    if (!operand.isNumber()) {
      slopes.merge(operand, slope, Scalar::plus);
    }
  }

  private void passOn(Scalar node, Scalar slope) {
    boolean guarded = node.isSteep() || guardedNodes.contains(node);
    if (node.isMarkedSteep() || guardedNodes.contains(node)) {
      guardedNodes.addAll(node.operands());
    }
    switch (node.operation()) {
      case CONSTANT, INPUT -> {}
      case ADD -> {
        add(node.first(), slope);
        add(node.second(), slope);
      }
      case SUBTRACT -> {
        add(node.first(), slope);
        add(node.second(), slope.negated());
      }
      case NEGATE -> add(node.first(), slope.negated());
      case MULTIPLY -> {
        add(node.first(), product(guarded, node.second(), slope));
        add(node.second(), product(guarded, node.first(), slope));
      }
      case DIVIDE -> quotient(guarded, node, slope);
      case SQUARE_ROOT -> add(node.first(), root(guarded, node, slope));
      case SINE -> add(node.first(), product(guarded, expressions.cosine(node.first()), slope));
      case COSINE ->
          add(node.first(), product(guarded, expressions.sine(node.first()), slope).negated());
      case FUNCTION -> function(guarded, node, slope);
    }
  }

  /** A guarded product with a zero factor is 0, even if the other factor is infinite or NaN. */
  private Scalar product(boolean guarded, Scalar a, Scalar b) {
    return guarded ? Simplification.guardedProduct(a, b) : a.times(b);
  }

  private void quotient(boolean guarded, Scalar node, Scalar slope) {
    Scalar byDividend =
        guarded
            ? product(true, expressions.one().over(node.second()).markedSteep(), slope)
            : slope.over(node.second());
    add(node.first(), byDividend);
    add(node.second(), product(guarded, node, byDividend).negated());
  }

  private Scalar root(boolean guarded, Scalar node, Scalar slope) {
    return guarded
        ? product(true, expressions.constant(0.5).over(node), slope)
        : slope.times(0.5).over(node);
  }

  private void function(boolean guarded, Scalar node, Scalar slope) {
    if (node.function().isChoice()) {
      choice(node.function().choice().stream().map(node.operands()::get).toList(), slope);
      return;
    }
    for (int i = 0; i < node.operands().size(); i++) {
      if (!node.operands().get(i).isNumber()) {
        add(node.operands().get(i), product(guarded, node.function().slope(node, i), slope));
      }
    }
  }

  /** The operand that is not chosen gets 0, even if the slope is NaN, and so does all below it. */
  private void choice(List<Scalar> x, Scalar slope) {
    Scalar zero = expressions.zero();
    guardedNodes.add(x.get(2));
    guardedNodes.add(x.get(3));
    add(x.get(2), expressions.function(MathFunction.CHOOSE, x.get(0), x.get(1), slope, zero));
    add(x.get(3), expressions.function(MathFunction.CHOOSE, x.get(0), x.get(1), zero, slope));
  }
}
