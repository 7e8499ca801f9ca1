package org.mechservice.client.failure;

/** The server does not allow this client to do what it asked for. */
public final class NotAuthorizedException extends ServiceException {
  private static final long serialVersionUID = 1L;

  NotAuthorizedException(String code, String text) {
    super(code, coded(code, text));
  }
}
