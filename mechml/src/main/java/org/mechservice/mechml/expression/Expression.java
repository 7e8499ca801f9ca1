package org.mechservice.mechml.expression;

import java.util.List;

/** An expression, read but not evaluated; every part knows where in the text it stands. */
public sealed interface Expression {
  /** Returns the character this part begins at, or its operator's, from 0. */
  int offset();

  /** A number. */
  record Literal(double value, int offset) implements Expression {}

  /**
   * A name, or several joined by dots.
   *
   * @param names at least one
   */
  record Reference(List<String> names, int offset) implements Expression {
    public Reference {
      names = List.copyOf(names);
    }

    /** Returns the names joined by dots. */
    public String text() {
      return String.join(".", names);
    }
  }

  /**
   * One part of a chain of operations of equal rank.
   *
   * @param inverse whether the part is subtracted or divided by
   * @param operand the part
   * @param offset of the operator before it, or of the part if it is the first
   */
  record Part(boolean inverse, Expression operand, int offset) {}

  /** A sum, taken from left to right; the first part may not be inverse. */
  record Sum(List<Part> parts, int offset) implements Expression {
    public Sum {
      parts = List.copyOf(parts);
    }
  }

  /** A product, taken from left to right; the first part may not be inverse. */
  record Product(List<Part> parts, int offset) implements Expression {
    public Product {
      parts = List.copyOf(parts);
    }
  }

  /** The negative of an expression. */
  record Negation(Expression operand, int offset) implements Expression {}

  /** A power. */
  record Power(Expression base, Expression exponent, int offset) implements Expression {}

  /** A function and its arguments, as many as it takes. */
  record Call(Function function, List<Expression> arguments, int offset) implements Expression {
    public Call {
      arguments = List.copyOf(arguments);
    }
  }
}
