package org.mechservice.client.failure;

/** The call does not fit what the simulation or session has done so far. */
public final class InvalidStateException extends ServiceException {
  private static final long serialVersionUID = 1L;

  private final RunState state;

  public InvalidStateException(String code, String text, RunState state) {
    super(code, coded(code, text));
    this.state = state;
  }

  /** Returns the state the simulation was in. */
  public RunState state() {
    return state;
  }
}
