package org.mechservice.guard;

import java.io.IOException;

/** A process of {@link WarmProcesses} has ended without an answer. */
public final class LostProcessException extends IOException {
  private static final long serialVersionUID = 1L;

  /** Why it ended. */
  public enum Cause {
    /** Its heap was full. */
    MEMORY,
    /** The answer took too long. */
    TIME,
    /** Anything else, such as a kill from outside. */
    OTHER
  }

  private final Cause why;

  LostProcessException(Cause why, String text) {
    super(text);
    this.why = why;
  }

  /** Returns why it ended. */
  public Cause why() {
    return why;
  }
}
