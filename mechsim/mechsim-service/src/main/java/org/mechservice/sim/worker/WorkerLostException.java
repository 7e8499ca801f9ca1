package org.mechservice.sim.worker;

/** A worker has ended without a result. */
public final class WorkerLostException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final boolean outOfMemory;

  WorkerLostException(String text, boolean outOfMemory) {
    super(text);
    this.outOfMemory = outOfMemory;
  }

  /** Returns whether it needed more memory than it was given. */
  public boolean outOfMemory() {
    return outOfMemory;
  }
}
