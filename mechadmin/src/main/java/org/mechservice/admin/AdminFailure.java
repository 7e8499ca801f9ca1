package org.mechservice.admin;

/** A server did not do what it was asked, or there is nothing to ask it about. */
public final class AdminFailure extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** Why it came to nothing. */
  public enum Reason {
    /** No answer, or none in time. */
    NO_ANSWER,
    /** The server refuses this to whoever asked. */
    NOT_ALLOWED,
    /** There is no server, host or simulation of that name. */
    NOT_FOUND,
    /** What was asked for makes no sense. */
    NOT_USABLE
  }

  private final Reason reason;

  /**
   * @param message code and text
   */
  public AdminFailure(Reason reason, String message) {
    super(message);
    this.reason = reason;
  }

  /** Returns why it came to nothing. */
  public Reason reason() {
    return reason;
  }

  /** Returns code and text. */
  public String text() {
    return String.valueOf(getMessage());
  }
}
