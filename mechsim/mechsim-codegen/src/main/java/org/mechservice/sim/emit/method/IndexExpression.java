package org.mechservice.sim.emit.method;

/**
 * An index, or another integer, in a planned method.
 *
 * @param parameter index of the method's integer parameter to which the offset is added; {@link
 *     #NONE} for none
 * @param offset constant offset
 */
public record IndexExpression(int parameter, int offset) {
  public static final int NONE = -1;

  /** Returns a constant index. */
  public static IndexExpression of(int number) {
    return new IndexExpression(NONE, number);
  }

  /** Returns the name of a method's integer parameter. */
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
