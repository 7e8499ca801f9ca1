package org.mechservice.client.failure;

/** An option is unknown or has a value that cannot be used. */
public final class InvalidOptionException extends ServiceException {
  private static final long serialVersionUID = 1L;

  private final String option;

  public InvalidOptionException(String code, String text, String option) {
    super(code, coded(code, text));
    this.option = option;
  }

  /** Returns the key of the option, such as {@code rtol}; empty if none can be named. */
  public String option() {
    return option;
  }
}
