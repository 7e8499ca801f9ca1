package org.mechservice.sim.emit;

/** A model's class, ready to be written as Java source or as a class file. Immutable. */
public sealed interface GeneratedClass permits ModelPlan, ProgramsClass, CompactClass {
  /** Returns the class's simple name. */
  String simpleName();

  /** Returns a description of the class with the number of operations of its programs. */
  String code();

  /**
   * Returns whether its constructor takes an array of numbers: values of parameters and loads of
   * user forces.
   */
  boolean takesNumbers();

  /** Returns the number of values in the plans of its programs. */
  long plannedValues();

  /** Returns the formatted source. */
  String source();

  /** Returns the class file; its results have the same bits as those of {@link #source}. */
  byte[] classFile();
}
