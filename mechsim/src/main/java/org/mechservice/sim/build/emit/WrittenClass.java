package org.mechservice.sim.build.emit;

/** A model's class, ready to be written as Java source or as a class file. Immutable. */
public sealed interface WrittenClass permits ModelPlan, TermsPlan, ValuesPlan, CompactClass {
  /** Returns the class's simple name. */
  String simpleName();

  /** Returns how the class computes, with the operations of its programs, for people. */
  String code();

  /** Returns the formatted source. */
  String source();

  /** Returns the class file; it computes what {@link #source} says, bit by bit. */
  byte[] classFile();
}
