package org.mechservice.sim.emit.method;

import org.mechservice.solver.symbol.Scalar;

/** One step of a planned method. */
public sealed interface Statement {
  /** A comment on the statements that follow; lines are separated by line feeds. */
  record Comment(String text) implements Statement {}

  /**
   * Loads a value from an input or the workspace into a local variable, for the first time or
   * {@code again}.
   */
  record Load(Scalar value, ValueLocation from, boolean again) implements Statement {}

  /** Computes a value and stores it in a local variable. */
  record Define(Scalar value) implements Statement {}

  /** Stores a value that later methods need in the workspace. */
  record Store(int slot, Scalar value) implements Statement {}

  /** Stores a value in an output. */
  record PutOut(int index, Scalar value) implements Statement {}

  /** Stores a value in an element of an array parameter. */
  record Put(ValueLocation.Element to, Scalar value) implements Statement {}

  /** Copies {@code count} inputs from {@code input} on to outputs from {@code index} on. */
  record CopyInputs(int input, int index, int count) implements Statement {}

  /** Ends the program if a pivot is not above its bound. */
  record Check(Scalar pivot, Scalar bound, IndexExpression result, String meaning)
      implements Statement {}
}
