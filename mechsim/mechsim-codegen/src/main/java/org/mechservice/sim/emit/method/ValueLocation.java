package org.mechservice.sim.emit.method;

import org.mechservice.solver.symbol.Scalar;

/**
 * The location of a value inside a method; a value without a location is written out at its use.
 */
public sealed interface ValueLocation {
  /** The local variable that holds a value. */
  record Local(Scalar value) implements ValueLocation {}

  /** An element of the model's workspace. */
  record Slot(int index) implements ValueLocation {}

  /** An input of the program. */
  record Input(int index) implements ValueLocation {}

  /** An element of an array parameter. */
  record Element(String array, IndexExpression index) implements ValueLocation {}

  /** A number that is the same in every call. */
  record Constant(double value) implements ValueLocation {}
}
