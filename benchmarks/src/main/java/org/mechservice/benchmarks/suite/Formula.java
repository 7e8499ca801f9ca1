package org.mechservice.benchmarks.suite;

import java.util.List;
import java.util.function.BinaryOperator;
import java.util.function.ToIntFunction;
import org.mechservice.mechml.expression.ExpressionException;
import org.mechservice.mechml.expression.ExpressionParser;
import org.mechservice.mechml.expression.ParsedExpression;
import org.mechservice.solver.symbol.MathFunction;

/**
 * An expression of the suite's problem file: one of model files, with the catalogue's functions,
 * but for what Python, which evaluates the same texts in {@code peers.py}, writes otherwise: powers
 * are {@code **}, and π is {@code pi}. Names stand for places of one array.
 */
final class Formula {
  private Formula() {}

  /** Evaluates with the values of all names. */
  interface Node {
    /** Returns the value, given those of the names by slot. */
    double at(double[] values);
  }

  /**
   * Reads an expression.
   *
   * @param slots place of each name among the values, negative for what is none
   * @throws IllegalArgumentException if it cannot be read
   */
  static Node of(String text, ToIntFunction<String> slots) {
    try {
      return node(ExpressionParser.parse(text.replace("**", "^")), slots);
    } catch (ExpressionException e) {
      throw new IllegalArgumentException("cannot read " + text + ": " + e.reason(), e);
    }
  }

  private static Node node(ParsedExpression expression, ToIntFunction<String> slots) {
    if (expression instanceof ParsedExpression.Literal literal) {
      return values -> literal.value();
    } else if (expression instanceof ParsedExpression.Reference name) {
      return named(name.text(), slots);
    } else if (expression instanceof ParsedExpression.Sum sum) {
      return chain(
          sum.parts(), slots, (a, b) -> v -> a.at(v) + b.at(v), (a, b) -> v -> a.at(v) - b.at(v));
    } else if (expression instanceof ParsedExpression.Product product) {
      return chain(
          product.parts(),
          slots,
          (a, b) -> v -> a.at(v) * b.at(v),
          (a, b) -> v -> a.at(v) / b.at(v));
    } else if (expression instanceof ParsedExpression.Negation negation) {
      Node positive = node(negation.operand(), slots);
      return values -> -positive.at(values);
    } else if (expression instanceof ParsedExpression.Power power) {
      return call(MathFunction.POWER, List.of(power.base(), power.exponent()), slots);
    } else if (expression instanceof ParsedExpression.Call call) {
      return call(call.function(), call.arguments(), slots);
    }
    throw new IllegalArgumentException("the suite has no tables");
  }

  private static Node named(String name, ToIntFunction<String> slots) {
    if (name.equals("pi")) {
      return values -> Math.PI;
    }
    int slot = slots.applyAsInt(name);
    if (slot < 0) {
      throw new IllegalArgumentException("cannot read " + name);
    }
    return values -> values[slot];
  }

  private static Node chain(
      List<ParsedExpression.Part> parts,
      ToIntFunction<String> slots,
      BinaryOperator<Node> direct,
      BinaryOperator<Node> inverse) {
    Node chain = node(parts.get(0).operand(), slots);
    for (ParsedExpression.Part part : parts.subList(1, parts.size())) {
      chain = (part.inverse() ? inverse : direct).apply(chain, node(part.operand(), slots));
    }
    return chain;
  }

  private static Node call(
      MathFunction function, List<ParsedExpression> arguments, ToIntFunction<String> slots) {
    Node a = node(arguments.get(0), slots);
    Node b = node(arguments.get(arguments.size() - 1), slots);
    return values -> function.value(a.at(values), b.at(values));
  }
}
