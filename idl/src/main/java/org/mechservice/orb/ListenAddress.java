package org.mechservice.orb;

import java.net.InetAddress;
import java.net.UnknownHostException;

/**
 * Where a service listens. Plain IIOP is neither encrypted nor does it know who calls, so only
 * addresses of this machine alone are accepted.
 *
 * @param host numeric loopback address or a name that resolves to one
 * @param port port; 0: any free one
 */
public record ListenAddress(String host, int port) {
  private static final int HIGHEST_PORT = 65535;

  /**
   * @throws IllegalArgumentException with code S-004 if the host is unknown or can be reached from
   *     other machines, or the port is out of range
   */
  public ListenAddress {
    if (port < 0 || port > HIGHEST_PORT) {
      throw new IllegalArgumentException(
          "S-004 cannot listen on port " + port + ": a port is a number from 0 to 65535");
    }
    if (!isLoopback(host)) {
      throw new IllegalArgumentException(
          "S-004 cannot listen on "
              + host
              + ": other machines could connect without encryption or identity."
              + " This version listens on addresses of this machine only, such as 127.0.0.1");
    }
  }

  private static boolean isLoopback(String host) {
    try {
      return !host.isEmpty() && InetAddress.getByName(host).isLoopbackAddress();
    } catch (UnknownHostException e) {
      throw new IllegalArgumentException(
          "S-004 cannot listen on " + host + ": no such host; use 127.0.0.1", e);
    }
  }

  /** Returns {@code host:port}. */
  @Override
  public String toString() {
    return host + ":" + port;
  }
}
