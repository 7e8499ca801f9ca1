package org.mechservice.client.failure;

/** What was asked for by name or identity does not exist at the server. */
public final class NotFoundException extends ServiceException {
  private static final long serialVersionUID = 1L;

  NotFoundException(String code, String text) {
    super(code, coded(code, text));
  }
}
