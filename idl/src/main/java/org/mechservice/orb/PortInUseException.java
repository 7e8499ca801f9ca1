package org.mechservice.orb;

import org.mechservice.solver.catalogue.MessageCode;

/** The address to listen on is taken or not this machine's; the message carries code S-003. */
public final class PortInUseException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /**
   * @param address {@code host:port} requested
   * @param cause the error of the system
   */
  public PortInUseException(String address, Throwable cause) {
    super(
        MessageCode.PORT_IN_USE
            + " cannot listen on "
            + address
            + ": "
            + cause.getMessage()
            + ". Stop what listens there, or choose another address or port",
        cause);
  }
}
