package org.mechservice.sim.emit;

/**
 * An index, or another whole number, in a planned method.
 *
 * @param parameter which of the method's whole numbers it counts from; {@link #NONE}: from 0
 * @param offset how far it is from there
 */
record Index(int parameter, int offset) {
  static final int NONE = -1;

  /** A number that is the same in every call. */
  static Index of(int number) {
    return new Index(NONE, number);
  }

  /** Returns the name of a method's whole number. */
  static String name(int parameter) {
    return "at" + parameter;
  }

  /** Returns it as a Java expression. */
  String text() {
    if (parameter == NONE) {
      return Integer.toString(offset);
    }
    return offset == 0 ? name(parameter) : name(parameter) + " + " + offset;
  }
}
