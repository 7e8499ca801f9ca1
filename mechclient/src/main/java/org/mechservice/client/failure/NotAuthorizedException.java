package org.mechservice.client.failure;

/** The server does not permit this client the requested operation. */
public final class NotAuthorizedException extends ServiceException {
  private static final long serialVersionUID = 1L;

  NotAuthorizedException(String code, String text) {
    super(code, coded(code, text));
  }
}
