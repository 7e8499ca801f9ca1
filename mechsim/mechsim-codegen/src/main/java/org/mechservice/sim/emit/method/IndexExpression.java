package org.mechservice.sim.emit.method;

/**
 * An index, or another whole number, in a planned method.
 *
 * @param parameter which of the method's whole numbers it counts from; {@link #NONE}: from 0
 * @param offset how far it is from there
 */
public record IndexExpression(int parameter, int offset) {
  public static final int NONE = -1;

  /** A number that is the same in every call. */
  public static IndexExpression of(int number) {
    return new IndexExpression(NONE, number);
  }

  /** Returns the name of a method's whole number. */
  public static String name(int parameter) {
    return "at" + parameter;
  }

  /** Returns it as a Java expression. */
  public String text() {
    if (parameter == NONE) {
      return Integer.toString(offset);
    }
    return offset == 0 ? name(parameter) : name(parameter) + " + " + offset;
  }
}
