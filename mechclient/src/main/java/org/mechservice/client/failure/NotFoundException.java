package org.mechservice.client.failure;

/** The server has no object of the given name or id. */
public final class NotFoundException extends ServiceException {
  private static final long serialVersionUID = 1L;

  NotFoundException(String code, String text) {
    super(code, coded(code, text));
  }
}
