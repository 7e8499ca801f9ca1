package org.mechservice.mechml.expression;

import org.mechservice.solver.catalogue.MessageCode;

/** Thrown when an expression cannot be read or has no value. */
public final class ExpressionException extends Exception {
  private static final long serialVersionUID = 1L;

  private final MessageCode code;
  private final int offset;

  /**
   * Creates an exception with the error and its position in the text.
   *
   * @param code entry of the catalogue
   * @param offset character in the text, from 0
   * @param message what is wrong, without the position
   */
  public ExpressionException(MessageCode code, int offset, String message) {
    super(message);
    this.code = code;
    this.offset = offset;
  }

  /** Returns the entry of the catalogue. */
  public MessageCode code() {
    return code;
  }

  /** Returns the character in the text, from 0. */
  public int offset() {
    return offset;
  }

  /** Returns what is wrong, without the position. */
  public String reason() {
    return String.valueOf(getMessage());
  }
}
