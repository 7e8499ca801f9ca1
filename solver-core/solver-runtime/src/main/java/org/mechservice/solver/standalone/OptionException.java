package org.mechservice.solver.standalone;

/** The command line cannot be obeyed; the message says what to write instead. */
final class OptionException extends Exception {
  private static final long serialVersionUID = 1L;

  OptionException(String message) {
    super(message);
  }
}
