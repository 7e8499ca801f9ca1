package org.mechservice.mechml.unit;

/** A text is not a unit; the message says why. */
public final class UnitException extends Exception {
  private static final long serialVersionUID = 1L;

  UnitException(String message) {
    super(message);
  }

  /** Returns what is wrong. */
  public String reason() {
    return String.valueOf(getMessage());
  }
}
