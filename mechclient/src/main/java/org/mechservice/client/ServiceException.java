package org.mechservice.client;

/**
 * The service refused a call, or could not be reached. Every case has a stable code and one message
 * for people; the kinds are closed, so a {@code switch} over them is complete.
 */
public abstract sealed class ServiceException extends RuntimeException
    permits InvalidModelException,
        InvalidOptionException,
        InvalidStateException,
        JarRefusedException,
        LimitExceededException,
        NotAuthorizedException,
        NotAvailableException,
        NotFoundException,
        ServerFailureException,
        ServerLostException {
  private static final long serialVersionUID = 1L;

  private final String code;

  ServiceException(String code, String text) {
    super(text.contains(code) ? text : code + " " + text);
    this.code = code;
  }

  /** Returns the entry of the error catalogue, such as {@code S-031}. */
  public final String code() {
    return code;
  }
}
