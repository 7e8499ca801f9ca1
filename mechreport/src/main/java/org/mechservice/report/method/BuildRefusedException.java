package org.mechservice.report.method;

/** A model cannot be built so; the message says why, with its code. */
public final class BuildRefusedException extends Exception {
  private static final long serialVersionUID = 1L;

  public BuildRefusedException(Exception refusal) {
    super(String.valueOf(refusal.getMessage()), refusal);
  }

  /** Returns why, with its code. */
  public String reason() {
    return String.valueOf(getMessage());
  }
}
