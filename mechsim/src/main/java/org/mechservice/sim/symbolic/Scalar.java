package org.mechservice.sim.symbolic;

import java.util.List;

/**
 * A number known only when the program runs: one node of an {@link Expressions} graph.
 *
 * <p>Two scalars of one graph are the same object exactly if they are the same expression.
 */
public final class Scalar {
  private final Expressions expressions;
  private final int id;
  private final Operation operation;
  private final List<Scalar> operands;
  private final double value;
  private final int index;

  Scalar(
      Expressions expressions,
      int id,
      Operation operation,
      List<Scalar> operands,
      double value,
      int index) {
    this.expressions = expressions;
    this.id = id;
    this.operation = operation;
    this.operands = operands;
    this.value = value;
    this.index = index;
  }

  /** Returns the graph the node belongs to. */
  public Expressions expressions() {
    return expressions;
  }

  /** Returns the node's number; operands have smaller ones. */
  public int id() {
    return id;
  }

  /** Returns what the node does. */
  public Operation operation() {
    return operation;
  }

  /** Returns what it does it with. */
  public List<Scalar> operands() {
    return operands;
  }

  /** Returns the first operand. */
  public Scalar first() {
    return operands.get(0);
  }

  /** Returns the second operand. */
  public Scalar second() {
    return operands.get(1);
  }

  /** Returns the number of a {@link Operation#CONSTANT}. */
  public double value() {
    return value;
  }

  /** Returns which input an {@link Operation#INPUT} is. */
  public int index() {
    return index;
  }

  /** Returns whether it is a number already known. */
  public boolean isConstant() {
    return operation == Operation.CONSTANT;
  }

  /** Returns whether it is zero whatever the inputs are. */
  public boolean isZero() {
    return isConstant() && value == 0;
  }

  boolean is(Operation what) {
    return operation == what;
  }

  boolean isConstant(double number) {
    return isConstant() && value == number;
  }

  /** Returns this + other. */
  public Scalar plus(Scalar other) {
    return Simplification.sum(this, other);
  }

  /** Returns this − other. */
  public Scalar minus(Scalar other) {
    return Simplification.difference(this, other);
  }

  /** Returns this · other. */
  public Scalar times(Scalar other) {
    return Simplification.product(this, other);
  }

  /** Returns factor · this. */
  public Scalar times(double factor) {
    return Simplification.product(expressions.constant(factor), this);
  }

  /**
   * Returns this / other.
   *
   * @throws ArithmeticException if the other is the constant zero
   */
  public Scalar over(Scalar other) {
    return Simplification.quotient(this, other);
  }

  /** Returns −this. */
  public Scalar negated() {
    return Simplification.negation(this);
  }

  /** Returns the square root. */
  public Scalar squareRoot() {
    return Simplification.squareRoot(this);
  }

  /** Returns this². */
  public Scalar squared() {
    return times(this);
  }

  /** The number of the node, so that tables of nodes cost little and are the same in every run. */
  @Override
  public int hashCode() {
    return id;
  }

  @Override
  public String toString() {
    return switch (operation) {
      case CONSTANT -> Double.toString(value);
      case INPUT -> "in[" + index + "]";
      default -> "#" + id;
    };
  }
}
