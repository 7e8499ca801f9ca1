package org.mechservice.cli.shell;

/** Exit statuses of the process. */
public final class ExitStatus {
  public static final int DONE = 0;
  public static final int SIMULATION_FAILED = 1;
  public static final int BAD_INPUT = 2;
  public static final int SERVER = 3;

  /** A robot was imported, and moves otherwise than in its own engine. */
  public static final int MOTION_CHANGED = 4;

  /** As a shell reports a program that was ended by Ctrl-C. */
  public static final int INTERRUPTED = 130;

  private ExitStatus() {}
}
