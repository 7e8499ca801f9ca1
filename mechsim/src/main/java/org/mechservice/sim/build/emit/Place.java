package org.mechservice.sim.build.emit;

/**
 * Where a value is found inside a method; a value without a place is written out where it is used.
 */
sealed interface Place {
  /** A local variable. */
  record Local(String name) implements Place {}

  /** An element of the model's workspace. */
  record Slot(int index) implements Place {}

  /** An element of the state. */
  record Input(int index) implements Place {}
}
