package org.mechservice.orb;

/**
 * Whom an ORB is connected with.
 *
 * @param outbound where it may connect to
 * @param inbound who is connected to it
 */
record Peers(OutboundAllowList outbound, InboundConnections inbound) {
  /** Peers of an ORB that connects wherever it is told. */
  static Peers ofClient() {
    return new Peers(OutboundAllowList.ofEverything(), new InboundConnections());
  }

  /** Peers of an ORB that connects to nobody until it is allowed to. */
  static Peers ofServer() {
    return new Peers(OutboundAllowList.ofNothing(), new InboundConnections());
  }

  /** Closes what others have opened. */
  void close() {
    inbound.closeAll();
    outbound.forget();
  }
}
