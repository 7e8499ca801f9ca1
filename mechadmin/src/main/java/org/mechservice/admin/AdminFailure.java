package org.mechservice.admin;

/** A server refused or could not answer a request, or the object of the request does not exist. */
public final class AdminFailure extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** Why it came to nothing. */
  public enum Reason {
    /** No answer, or none in time. */
    NO_ANSWER,
    /** The server refuses this to the caller. */
    NOT_ALLOWED,
    /** No server, host or simulation has that name. */
    NOT_FOUND,
    /** The request is not valid. */
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
