package org.mechservice.client.failure;

import org.mechservice.solver.catalogue.MessageCode;

/** The server cannot be reached, no longer answers, or no longer has the session. */
public final class ServerLostException extends ServiceException {
  private static final long serialVersionUID = 1L;

  private final String address;

  public ServerLostException(String code, String text, String address) {
    super(code, coded(code, text));
    this.address = address;
  }

  /**
   * Returns whether the connection was cut or could not be made; the server may still be running.
   */
  boolean isConnectionCut() {
    return code().equals(MessageCode.CONNECTION_LOST.code());
  }

  /** Returns the address of the server. */
  public String address() {
    return address;
  }
}
