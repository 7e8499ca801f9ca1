package org.mechservice.cli;

/** What the process says to the shell. */
final class ExitStatus {
  static final int DONE = 0;
  static final int SIMULATION_FAILED = 1;
  static final int BAD_INPUT = 2;
  static final int SERVER = 3;

  /** As a shell reports a program that was ended by Ctrl-C. */
  static final int INTERRUPTED = 130;

  private ExitStatus() {}
}
