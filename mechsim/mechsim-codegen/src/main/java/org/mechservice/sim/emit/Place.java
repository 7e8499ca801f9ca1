package org.mechservice.sim.emit;

import org.mechservice.sim.symbolic.Scalar;

/**
 * Where a value is found inside a method; a value without a place is written out where it is used.
 */
sealed interface Place {
  /** The local variable that holds a value. */
  record Local(Scalar value) implements Place {}

  /** An element of the model's workspace. */
  record Slot(int index) implements Place {}

  /** An input of the program. */
  record Input(int index) implements Place {}

  /** An element of an array that the method is given. */
  record Element(String array, Index index) implements Place {}

  /** A number that is the same in every call. */
  record Constant(double value) implements Place {}
}
