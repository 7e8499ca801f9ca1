package org.mechservice.orb;

import java.util.Optional;
import org.mechservice.orb.connection.InboundConnections;
import org.mechservice.orb.connection.OutboundAllowList;
import org.mechservice.orb.tls.TlsIdentity;
import org.mechservice.orb.tls.TlsPeers;

/**
 * The peers of an ORB.
 *
 * @param outbound addresses it may connect to
 * @param inbound the connections that others have opened
 * @param tls how connections are encrypted; empty: they are not
 */
record Peers(OutboundAllowList outbound, InboundConnections inbound, Optional<TlsPeers> tls) {
  /** Peers of an ORB that may connect to any address. */
  static Peers ofClient(Optional<TlsIdentity> identity) {
    return new Peers(
        OutboundAllowList.ofEverything(), new InboundConnections(), identity.map(TlsPeers::new));
  }

  /** Peers of an ORB that may connect to allowed addresses only. */
  static Peers ofServer(Optional<TlsIdentity> identity) {
    return new Peers(
        OutboundAllowList.ofNothing(), new InboundConnections(), identity.map(TlsPeers::new));
  }

  /** Closes what others have opened. */
  void close() {
    inbound.closeAll();
    outbound.forget();
    tls.ifPresent(TlsPeers::forget);
  }
}
