package org.mechservice.client.failure;

/** Something went wrong inside the server; its operator finds the details under the incident. */
public final class ServerFailureException extends ServiceException {
  private static final long serialVersionUID = 1L;

  private final String incident;

  public ServerFailureException(String code, String text, String incident) {
    super(code, coded(code, incident.isEmpty() ? text : text + " (incident " + incident + ")"));
    this.incident = incident;
  }

  /** Returns the identity under which the server logged what happened; may be empty. */
  public String incident() {
    return incident;
  }
}
