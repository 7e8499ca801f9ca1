package org.mechservice.sim.host;

/**
 * How a host process runs.
 *
 * @param serverUrl the server to register with
 * @param name the host's name, unique at the server
 * @param listenAddress address to listen on
 * @param port port to listen on; 0: any free one
 * @param capacity simulations it runs at once
 */
public record HostSettings(
    String serverUrl, String name, String listenAddress, int port, int capacity) {}
