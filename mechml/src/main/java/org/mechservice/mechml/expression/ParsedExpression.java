package org.mechservice.mechml.expression;

import java.util.List;
import java.util.OptionalInt;
import org.mechservice.solver.symbol.MathFunction;

/** A parsed expression; every part knows its position in the text. */
public sealed interface ParsedExpression {
  /** Returns the position, from 0, of this part's first character or of its operator. */
  int offset();

  /** A number. */
  record Literal(double value, int offset) implements ParsedExpression {}

  /**
   * A name or several names joined by dots, with an optional component index.
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
   * @param offset position of the operator before it; for the first part its own position
   */
  record Part(boolean inverse, ParsedExpression operand, int offset) {}

  /** A sum, evaluated from left to right; the first part is not inverse. */
  record Sum(List<Part> parts, int offset) implements ParsedExpression {
    public Sum {
      parts = List.copyOf(parts);
    }
  }

  /** A product, evaluated from left to right; the first part is not inverse. */
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

  /** A table or map of the model with its arguments. */
  record TableCall(String table, List<ParsedExpression> arguments, int offset)
      implements ParsedExpression {
    public TableCall {
      arguments = List.copyOf(arguments);
    }
  }

  /** A function with all its arguments. */
  record Call(MathFunction function, List<ParsedExpression> arguments, int offset)
      implements ParsedExpression {
    public Call {
      arguments = List.copyOf(arguments);
    }
  }
}
