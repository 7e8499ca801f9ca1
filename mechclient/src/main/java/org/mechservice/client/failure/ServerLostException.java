package org.mechservice.client.failure;

import org.mechservice.solver.catalogue.MessageCode;

/** The server cannot be reached, does not answer any more, or has forgotten the session. */
public final class ServerLostException extends ServiceException {
  private static final long serialVersionUID = 1L;

  private final String address;

  public ServerLostException(String code, String text, String address) {
    super(code, coded(code, text));
    this.address = address;
  }

  /**
   * Returns whether the connection was cut, or there is none; the server may be there all the same.
   */
  boolean isConnectionCut() {
    return code().equals(MessageCode.CONNECTION_LOST.code());
  }

  /** Returns the address that was asked. */
  public String address() {
    return address;
  }
}
