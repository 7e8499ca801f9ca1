package org.mechservice.client.failure;

/** The call is not permitted in the present state of the simulation or session. */
public final class InvalidStateException extends ServiceException {
  private static final long serialVersionUID = 1L;

  private final RunState state;

  public InvalidStateException(String code, String text, RunState state) {
    super(code, coded(code, text));
    this.state = state;
  }

  /** Returns the state of the simulation. */
  public RunState state() {
    return state;
  }
}
