package org.mechservice.sim.worker;

/** A worker has ended without a result. */
public final class WorkerLostException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final String advice;
  private final boolean outOfMemory;

  WorkerLostException(String text, String advice, boolean outOfMemory) {
    super(text);
    this.advice = advice;
    this.outOfMemory = outOfMemory;
  }

  /** Returns what the user or the operator can do. */
  public String advice() {
    return advice;
  }

  /** Returns whether it needed more memory than it was given. */
  public boolean outOfMemory() {
    return outOfMemory;
  }
}
