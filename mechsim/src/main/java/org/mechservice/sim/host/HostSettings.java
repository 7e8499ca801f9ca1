package org.mechservice.sim.host;

import java.util.List;

/**
 * How a host process runs.
 *
 * @param serverUrls the servers to register with
 * @param listenAddress address to listen on
 * @param port port to listen on; 0: any free one
 * @param host what it is like
 */
public record HostSettings(
    List<String> serverUrls, String listenAddress, int port, HostOptions host) {
  public HostSettings {
    serverUrls = List.copyOf(serverUrls);
  }

  /** A host of one server that nobody configured. */
  public HostSettings(String serverUrl, String name, String listenAddress, int port, int capacity) {
    this(List.of(serverUrl), listenAddress, port, new HostOptions(name, capacity));
  }
}
