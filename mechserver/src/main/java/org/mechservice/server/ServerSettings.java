package org.mechservice.server;

/**
 * How a server process runs.
 *
 * @param name the server's name
 * @param listenAddress address to listen on
 * @param port port to listen on; 0: any free one
 * @param localCapacity simulations the server's own process runs at once; 0: hosts only
 */
public record ServerSettings(String name, String listenAddress, int port, int localCapacity) {}
