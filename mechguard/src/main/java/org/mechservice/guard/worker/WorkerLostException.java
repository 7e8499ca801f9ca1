package org.mechservice.guard.worker;

import org.mechservice.solver.catalogue.MessageCode;

/** A worker has ended without a result. */
public final class WorkerLostException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final MessageCode code;
  private final String advice;

  WorkerLostException(MessageCode code, String text, String advice) {
    super(text);
    this.code = code;
    this.advice = advice;
  }

  /**
   * Returns why it ended: without memory (S-110), killed from outside (S-178), or by something in
   * it (S-157).
   */
  public MessageCode code() {
    return code;
  }

  /** Returns what the user or the operator can do. */
  public String advice() {
    return advice;
  }
}
