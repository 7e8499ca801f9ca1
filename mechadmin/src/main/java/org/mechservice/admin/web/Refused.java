package org.mechservice.admin.web;

import org.mechservice.admin.AdminFailure;
import org.mechservice.solver.catalogue.MessageCode;

/** A request that is not answered as it was meant. */
final class Refused extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final int status;

  /**
   * @param status of the response, by HTTP
   * @param message code and text
   */
  Refused(int status, String message) {
    super(message);
    this.status = status;
  }

  /** Returns the refusal that reports a failure. */
  static Refused of(AdminFailure failure) {
    int status =
        switch (failure.reason()) {
          case NO_ANSWER -> 504;
          case NOT_ALLOWED -> 403;
          case NOT_FOUND -> 404;
          case NOT_USABLE -> 400;
        };
    return new Refused(status, failure.text());
  }

  /** The request cannot be read. */
  static Refused notUnderstood(String what) {
    return new Refused(400, MessageCode.REQUEST_UNUSABLE + " the request cannot be used: " + what);
  }

  int status() {
    return status;
  }

  String text() {
    return String.valueOf(getMessage());
  }
}
