package org.mechservice.client.failure;

/** An internal error of the server; its operator finds the details by the incident's id. */
public final class ServerFailureException extends ServiceException {
  private static final long serialVersionUID = 1L;

  private final String incident;

  public ServerFailureException(String code, String text, String incident) {
    super(code, coded(code, incident.isEmpty() ? text : text + " (incident " + incident + ")"));
    this.incident = incident;
  }

  /** Returns the id of the incident in the server's log; may be empty. */
  public String incident() {
    return incident;
  }
}
