package org.mechservice.mechml.unit;

/** Thrown when a text is not a unit; the message gives the reason. */
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
