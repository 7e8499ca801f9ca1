package org.mechservice.client.failure;

/** The server's limit for this client would be exceeded. */
public final class LimitExceededException extends ServiceException {
  private static final long serialVersionUID = 1L;

  private final String limit;
  private final long allowed;
  private final long requested;

  LimitExceededException(String code, String text, String limit, long allowed, long requested) {
    super(code, coded(code, text));
    this.limit = limit;
    this.allowed = allowed;
    this.requested = requested;
  }

  /** Returns the limit's name. */
  public String limit() {
    return limit;
  }

  /** Returns the largest value allowed. */
  public long allowed() {
    return allowed;
  }

  /** Returns the value this call would have needed, at least. */
  public long requested() {
    return requested;
  }
}
