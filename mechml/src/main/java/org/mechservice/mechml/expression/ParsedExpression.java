package org.mechservice.mechml.expression;

import java.util.List;
import java.util.OptionalInt;

/** An expression, read but not evaluated; every part knows where in the text it stands. */
public sealed interface ParsedExpression {
  /** Returns the character this part begins at, or its operator's, from 0. */
  int offset();

  /** A number. */
  record Literal(double value, int offset) implements ParsedExpression {}

  /**
   * A name, or several joined by dots, and perhaps the number of a component.
   *
   * @param names at least one
   * @param index the number in square brackets, from 0
   */
  record Reference(List<String> names, OptionalInt index, int offset) implements ParsedExpression {
    public Reference {
      names = List.copyOf(names);
    }

    /** Returns the names joined by dots, with the index behind them. */
    public String text() {
      String joined = String.join(".", names);
      return index.isPresent() ? joined + "[" + index.getAsInt() + "]" : joined;
    }
  }

  /**
   * One part of a chain of operations of equal rank.
   *
   * @param inverse whether the part is subtracted or divided by
   * @param operand the part
   * @param offset of the operator before it, or of the part if it is the first
   */
  record Part(boolean inverse, ParsedExpression operand, int offset) {}

  /** A sum, taken from left to right; the first part may not be inverse. */
  record Sum(List<Part> parts, int offset) implements ParsedExpression {
    public Sum {
      parts = List.copyOf(parts);
    }
  }

  /** A product, taken from left to right; the first part may not be inverse. */
  record Product(List<Part> parts, int offset) implements ParsedExpression {
    public Product {
      parts = List.copyOf(parts);
    }
  }

  /** The negative of an expression. */
  record Negation(ParsedExpression operand, int offset) implements ParsedExpression {}

  /** A power. */
  record Power(ParsedExpression base, ParsedExpression exponent, int offset)
      implements ParsedExpression {}

  /** A function and its arguments, as many as it takes. */
  record Call(Function function, List<ParsedExpression> arguments, int offset)
      implements ParsedExpression {
    public Call {
      arguments = List.copyOf(arguments);
    }
  }
}
