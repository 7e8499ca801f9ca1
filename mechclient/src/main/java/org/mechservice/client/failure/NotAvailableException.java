package org.mechservice.client.failure;

/** This version of the server does not support the requested operation. */
public final class NotAvailableException extends ServiceException {
  private static final long serialVersionUID = 1L;

  NotAvailableException(String code, String text) {
    super(code, coded(code, text));
  }
}
