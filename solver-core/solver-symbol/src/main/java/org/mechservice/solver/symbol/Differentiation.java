package org.mechservice.solver.symbol;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Derivatives of expressions along a direction. The direction gives the rates of some nodes; the
 * rates of all others follow by the chain rule. Equal derivatives are one node, so a derivative
 * costs little more than the expression.
 */
public final class Differentiation {
  private final Expressions expressions;
  private final Map<Scalar, Scalar> rates;

  /** Nodes that change through one that is marked as steep. */
  private final Set<Scalar> steep = new HashSet<>();

  /**
   * Creates the derivatives along a direction.
   *
   * @param rates rates of inputs or of other nodes; a node that is not in it, and none of whose
   *     operands changes, has rate 0; not modified
   */
  public Differentiation(Expressions expressions, Map<Scalar, Scalar> rates) {
    this.expressions = expressions;
    this.rates = new HashMap<>(rates);
  }

  /** Returns the rate of an expression. */
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

  /**
   * Derives the rates of all values of a program, those of each section in one of their own, so
   * that sections which compute the same have rates that compute the same.
   *
   * @param into a program of the same graph, after whose sections the new ones come
   */
  public void sections(Program program, Program into) {
    int[] uses = program.uses();
    List<Program.Section> sections = program.sections();
    int end = uses.length;
    int[] next = new int[sections.size()];
    for (int s = sections.size() - 1; s >= 0; s--) {
      next[s] = end;
      end = sections.get(s).firstNode();
    }
    for (int s = 0; s < next.length; s++) {
      Program.Section section = sections.get(s);
      into.section("Rates of: " + section.title(), section.subject());
      for (int id = section.firstNode(); id < next[s]; id++) {
        if (uses[id] > 0) {
          of(expressions.node(id));
        }
      }
    }
  }

  private Scalar known(Scalar node) {
    return rates.getOrDefault(node, expressions.zero());
  }

  /**
   * Returns whether the rate of a node may be that of a value with an unbounded slope. What is
   * steep and does not change along the direction, such as a function of time, does no harm.
   */
  private boolean isSteep(Scalar node) {
    if (!node.isSteep()) {
      return false;
    }
    boolean changes = false;
    for (Scalar operand : node.operands()) {
      if (steep.contains(operand)) {
        return true;
      }
      changes |= !known(operand).isZero();
    }
    return changes && node.isMarkedSteep();
  }

  private Scalar rate(Scalar node) {
    boolean guarded = isSteep(node);
    if (guarded) {
      steep.add(node);
    }
    return rate(node, guarded);
  }

  private Scalar rate(Scalar node, boolean guarded) {
    return switch (node.operation()) {
      case CONSTANT, INPUT -> expressions.zero();
      case ADD -> known(node.first()).plus(known(node.second()));
      case SUBTRACT -> known(node.first()).minus(known(node.second()));
      case NEGATE -> known(node.first()).negated();
      case MULTIPLY ->
          product(guarded, known(node.first()), node.second())
              .plus(product(guarded, node.first(), known(node.second())));
      case DIVIDE -> quotient(node, guarded);
      case SQUARE_ROOT -> root(node, guarded);
      case SINE -> expressions.cosine(node.first()).times(known(node.first()));
      case COSINE -> expressions.sine(node.first()).times(known(node.first())).negated();
      case FUNCTION -> function(node, guarded);
    };
  }

  /** In a steep node a product with a zero factor is 0, even if the other factor is infinite. */
  private Scalar product(boolean guarded, Scalar a, Scalar b) {
    return guarded ? Simplification.guardedProduct(a, b) : a.times(b);
  }

  private Scalar quotient(Scalar node, boolean guarded) {
    Scalar dividend = known(node.first());
    Scalar divisor = known(node.second());
    if (!guarded) {
      return dividend.minus(node.times(divisor)).over(node.second());
    }
    Scalar slope = node.over(node.second());
    return product(true, expressions.one().over(node.second()).markedSteep(), dividend)
        .minus(product(true, slope, divisor));
  }

  private Scalar root(Scalar node, boolean guarded) {
    Scalar inner = known(node.first());
    return guarded
        ? product(true, expressions.constant(0.5).over(node), inner)
        : inner.times(0.5).over(node);
  }

  private Scalar function(Scalar node, boolean guarded) {
    return node.function().isChoice() ? chosen(node) : smooth(node, guarded);
  }

  /**
   * Returns the derivative of a choice; the operand that is not chosen adds nothing, even if its
   * derivative is NaN.
   */
  private Scalar chosen(Scalar node) {
    List<Scalar> x = node.function().choice().stream().map(node.operands()::get).toList();
    return expressions.function(
        MathFunction.CHOOSE, x.get(0), x.get(1), known(x.get(2)), known(x.get(3)));
  }

  private Scalar smooth(Scalar node, boolean guarded) {
    Scalar sum = expressions.zero();
    for (int i = 0; i < node.operands().size(); i++) {
      Scalar inner = known(node.operands().get(i));
      if (!inner.isZero()) {
        sum = sum.plus(product(guarded, node.function().slope(node, i), inner));
      }
    }
    return sum;
  }
}
