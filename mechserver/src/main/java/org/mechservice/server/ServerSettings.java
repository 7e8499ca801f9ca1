package org.mechservice.server;

import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.Optional;
import org.mechservice.orb.tls.TlsIdentity;
import org.mechservice.server.hosts.PlacementPolicy;
import org.mechservice.sim.host.HostOptions;

/**
 * Settings of a server process.
 *
 * @param listenAddress address to listen on
 * @param port port to listen on; 0: any free one
 * @param host name of the server and of its own host, which has no capacity if only others run
 *     simulations
 * @param placement how hosts are chosen
 * @param iorFile file to write the server's reference to; empty: none
 * @param naming naming service to bind the server's reference at; empty: none
 * @param tls identity of the server; empty: it serves this machine only, unencrypted
 * @param metrics address where figures are to be had; port 0: any free one; empty: none
 * @param auditFile file of the audit log; empty: none
 */
public record ServerSettings(
    String listenAddress,
    int port,
    HostOptions host,
    PlacementPolicy placement,
    Optional<Path> iorFile,
    Optional<String> naming,
    Optional<TlsIdentity> tls,
    Optional<InetSocketAddress> metrics,
    Optional<Path> auditFile) {

  /** A server with default settings. */
  public ServerSettings(String name, String listenAddress, int port, int localCapacity) {
    this(listenAddress, port, new HostOptions(name, localCapacity));
  }

  /** A server that only its own host is configured of. */
  public ServerSettings(String listenAddress, int port, HostOptions host) {
    this(
        listenAddress,
        port,
        host,
        PlacementPolicy.LEAST_LOADED,
        Optional.empty(),
        Optional.empty(),
        Optional.empty());
  }

  /** A server without audit log and metrics. */
  public ServerSettings(
      String listenAddress,
      int port,
      HostOptions host,
      PlacementPolicy placement,
      Optional<Path> iorFile,
      Optional<String> naming,
      Optional<TlsIdentity> tls) {
    this(
        listenAddress,
        port,
        host,
        placement,
        iorFile,
        naming,
        tls,
        Optional.empty(),
        Optional.empty());
  }

  /** Returns the server's name. */
  public String name() {
    return host.name();
  }
}
