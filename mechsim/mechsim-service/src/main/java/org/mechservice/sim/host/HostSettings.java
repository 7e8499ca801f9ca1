package org.mechservice.sim.host;

import java.util.List;
import java.util.Optional;
import org.mechservice.orb.tls.TlsIdentity;

/**
 * The settings of a host process.
 *
 * @param serverUrls the servers to register with
 * @param listenAddress address to listen on
 * @param port port to listen on; 0: any free one
 * @param host its options
 * @param tls identity of the host; empty: it serves this machine only, unencrypted
 */
public record HostSettings(
    List<String> serverUrls,
    String listenAddress,
    int port,
    HostOptions host,
    Optional<TlsIdentity> tls) {
  public HostSettings {
    serverUrls = List.copyOf(serverUrls);
  }

  /** A host of one server with default options. */
  public HostSettings(String serverUrl, String name, String listenAddress, int port, int capacity) {
    this(List.of(serverUrl), listenAddress, port, new HostOptions(name, capacity));
  }

  /** A host without encryption. */
  public HostSettings(List<String> serverUrls, String listenAddress, int port, HostOptions host) {
    this(serverUrls, listenAddress, port, host, Optional.empty());
  }
}
