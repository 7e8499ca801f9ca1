package org.mechservice.sim.emit.method;

import org.mechservice.sim.symbolic.Scalar;

/** One step of a planned method. */
public sealed interface Statement {
  /** Says what follows; lines are separated by line feeds. */
  record Comment(String text) implements Statement {}

  /** Takes a value from an input or the workspace into a local variable, once or {@code again}. */
  record Load(Scalar value, ValueLocation from, boolean again) implements Statement {}

  /** Computes a value into a local variable. */
  record Define(Scalar value) implements Statement {}

  /** Puts a value that later methods need into the workspace. */
  record Store(int slot, Scalar value) implements Statement {}

  /** Puts a value out. */
  record PutOut(int index, Scalar value) implements Statement {}

  /** Puts a value into an element of an array that the method is given. */
  record Put(ValueLocation.Element to, Scalar value) implements Statement {}

  /** Puts {@code count} inputs from {@code input} on out from {@code index} on. */
  record CopyInputs(int input, int index, int count) implements Statement {}

  /** Ends the program where a pivot is not above its bound. */
  record Check(Scalar pivot, Scalar bound, IndexExpression result, String meaning)
      implements Statement {}
}
