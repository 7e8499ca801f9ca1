package org.mechservice.solver.standalone;

/** The command line cannot be obeyed; the message says what to write instead. */
final class UsageException extends Exception {
  private static final long serialVersionUID = 1L;

  UsageException(String message) {
    super(message);
  }
}
