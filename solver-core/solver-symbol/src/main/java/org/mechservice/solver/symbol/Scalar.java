package org.mechservice.solver.symbol;

import java.util.List;
import java.util.Optional;

/**
 * A number known only when the program runs: one node of an {@link Expressions} graph.
 *
 * <p>Two scalars of one graph are the same object exactly if they are the same expression.
 */
public final class Scalar {
  private final Expressions expressions;
  private final int id;
  private final ScalarOperation operation;
  private final List<Scalar> operands;

  /**
   * Numbers of the operands, −1 for none; for a leaf, its value or input. Together with the
   * operation they identify a node.
   */
  final long identity;

  final long secondIdentity;
  private final double value;
  private final int index;
  private final Optional<MathFunction> function;
  private final Optional<FixedPart> fixed;
  private boolean steep;
  private boolean ownSteep;
  private boolean positive;

  /** Creates a node that is not a function. */
  Scalar(
      Expressions expressions,
      int id,
      ScalarOperation operation,
      List<Scalar> operands,
      long identity,
      long secondIdentity,
      double value,
      int index) {
    this.expressions = expressions;
    this.id = id;
    this.operation = operation;
    this.operands = operands;
    this.identity = identity;
    this.secondIdentity = secondIdentity;
    this.value = value;
    this.index = index;
    this.function = Optional.empty();
    this.fixed = Optional.empty();
    this.steep = anySteep(operands);
  }

  /** Creates a node of a function, with what it reads, if it reads anything. */
  Scalar(
      Expressions expressions,
      int id,
      MathFunction function,
      Optional<FixedPart> fixed,
      List<Scalar> operands) {
    this.expressions = expressions;
    this.id = id;
    this.operation = ScalarOperation.FUNCTION;
    this.operands = List.copyOf(operands);
    this.identity = -1;
    this.secondIdentity = -1;
    this.value = 0;
    this.index = 0;
    this.function = Optional.of(function);
    this.fixed = fixed;
    this.steep = anySteep(operands);
  }

  private static boolean anySteep(List<Scalar> operands) {
    for (Scalar operand : operands) {
      if (operand.steep) {
        return true;
      }
    }
    return false;
  }

  /** Returns the graph the node belongs to. */
  public Expressions expressions() {
    return expressions;
  }

  /** Returns the node's number; operands have smaller ones. */
  public int id() {
    return id;
  }

  /** Returns the operation of the node. */
  public ScalarOperation operation() {
    return operation;
  }

  /** Returns the operands of the node. */
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

  /** Returns the number of a {@link ScalarOperation#CONSTANT}. */
  public double value() {
    return value;
  }

  /** Returns the function of a {@link ScalarOperation#FUNCTION}. */
  public MathFunction function() {
    return function.orElseThrow();
  }

  /** Returns the row that a function {@linkplain MathFunction#readsRow() reads}. */
  public NumberRow row() {
    return (NumberRow) fixed.orElseThrow();
  }

  /** Returns the function of points that {@link MathFunction#GIVEN} is, or that has the place. */
  public GivenFunction given() {
    return (GivenFunction) fixed.orElseThrow();
  }

  /** Returns what it reads, if it reads anything. */
  Optional<FixedPart> fixed() {
    return fixed;
  }

  /**
   * Returns the index of an {@link ScalarOperation#INPUT}, or that of a {@linkplain
   * Expressions#number number} among those of the graph.
   */
  public int index() {
    return index;
  }

  /** Returns whether it is a constant that simplifications look at. */
  public boolean isConstant() {
    return operation == ScalarOperation.CONSTANT && secondIdentity < 0;
  }

  /** Returns whether it is a constant or a {@linkplain Expressions#number number}. */
  public boolean isNumber() {
    return operation == ScalarOperation.CONSTANT;
  }

  /** Returns whether it is zero for all inputs. */
  public boolean isZero() {
    return isConstant() && value == 0;
  }

  boolean is(ScalarOperation what) {
    return operation == what;
  }

  boolean isConstant(double number) {
    return isConstant() && value == number;
  }

  /**
   * Marks this as steep: it may be infinite or have an unbounded slope, as a root at zero. Every
   * value computed from it afterwards is steep too. In derivatives of steep values a product with a
   * zero factor is 0, even if the other factor is not finite. Returns this.
   */
  public Scalar markedSteep() {
    steep |= !isConstant();
    ownSteep |= !isConstant();
    return this;
  }

  /** Marks this as larger than zero for all inputs: choices that ask for it are decided. */
  public Scalar markedPositive() {
    positive |= !isConstant();
    return this;
  }

  boolean isPositive() {
    return positive;
  }

  /**
   * Returns whether it, or a value it is computed from, is {@linkplain #markedSteep() marked as
   * steep}.
   */
  boolean isSteep() {
    return steep;
  }

  /** Returns whether it is marked as steep itself. */
  boolean isMarkedSteep() {
    return ownSteep;
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
   * Returns this / other. Division by the constant zero is kept as an operation without a finite
   * value.
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

  /** Returns the number of the node: cheap, and the same in every run. */
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
