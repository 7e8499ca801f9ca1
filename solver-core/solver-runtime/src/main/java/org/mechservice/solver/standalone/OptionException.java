package org.mechservice.solver.standalone;

/** Thrown if the command line is invalid; the message says what to write instead. */
final class OptionException extends Exception {
  private static final long serialVersionUID = 1L;

  OptionException(String message) {
    super(message);
  }
}
