package org.mechservice.cli.shell;

/** What was asked for cannot be done as it was asked. */
public final class UsageException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /**
   * @param message code and text
   */
  public UsageException(String message) {
    super(message);
  }
}
