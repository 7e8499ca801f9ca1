package org.mechservice.orb.http;

import org.mechservice.solver.catalogue.MessageCode;

/** A request that is not answered as it was meant. */
public final class Refused extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final int status;

  /**
   * @param status of the response, by HTTP
   * @param message code and text
   */
  public Refused(int status, String message) {
    super(message);
    this.status = status;
  }

  /** The request cannot be read. */
  public static Refused notUnderstood(String what) {
    return new Refused(400, MessageCode.REQUEST_UNUSABLE + " the request cannot be used: " + what);
  }

  public int status() {
    return status;
  }

  public String text() {
    return String.valueOf(getMessage());
  }
}
