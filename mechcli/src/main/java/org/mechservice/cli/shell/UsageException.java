package org.mechservice.cli.shell;

/** The options of a command are not valid. */
public final class UsageException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /**
   * @param message code and text
   */
  public UsageException(String message) {
    super(message);
  }
}
