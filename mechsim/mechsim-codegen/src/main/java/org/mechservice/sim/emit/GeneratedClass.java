package org.mechservice.sim.emit;

/** A model's class, ready to be written as Java source or as a class file. Immutable. */
public sealed interface GeneratedClass permits ModelPlan, ProgramsClass, CompactClass {
  /** Returns the class's simple name. */
  String simpleName();

  /** Returns how the class computes, with the operations of its programs, for people. */
  String code();

  /**
   * Returns whether its constructor is given numbers, because it computes with some: values of
   * parameters, loads of forces that users have written.
   */
  boolean takesNumbers();

  /** Returns how many values the plans of its programs hold. */
  long plannedValues();

  /** Returns the formatted source. */
  String source();

  /** Returns the class file; its results have the same bits as those of {@link #source}. */
  byte[] classFile();
}
