package org.mechservice.orb.http;

import org.mechservice.solver.catalogue.MessageCode;

/** A request is refused; the message says why, with its code. */
public final class RefusedRequestException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final int status;

  /**
   * @param status of the response, by HTTP
   * @param message code and text
   */
  public RefusedRequestException(int status, String message) {
    super(message);
    this.status = status;
  }

  /** The request cannot be read. */
  public static RefusedRequestException notUnderstood(String what) {
    return new RefusedRequestException(
        400, MessageCode.REQUEST_UNUSABLE + " the request cannot be used: " + what);
  }

  public int status() {
    return status;
  }

  public String text() {
    return String.valueOf(getMessage());
  }
}
