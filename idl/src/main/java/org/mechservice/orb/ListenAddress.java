package org.mechservice.orb;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Optional;
import org.mechservice.orb.tls.TlsIdentity;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The address a service listens on. Plain IIOP is not encrypted and does not identify callers;
 * without an identity only addresses of this machine alone are accepted.
 *
 * @param host numeric address or a name that resolves to one
 * @param port port; 0: any free one
 * @param tls identity of the service; empty: without encryption
 */
public record ListenAddress(String host, int port, Optional<TlsIdentity> tls) {
  private static final int HIGHEST_PORT = 65535;

  /**
   * @throws IllegalArgumentException with code S-004 if the host is unknown, or can be reached from
   *     other machines without encryption, or stands for all addresses of the machine, or the port
   *     is out of range
   */
  public ListenAddress {
    if (port < 0 || port > HIGHEST_PORT) {
      throw new IllegalArgumentException(
          MessageCode.LISTEN_ADDRESS
              + " cannot listen on port "
              + port
              + ": a port is a number from 0 to 65535");
    }
    InetAddress address = addressOf(host);
    if (tls.isEmpty() && !address.isLoopbackAddress()) {
      throw new IllegalArgumentException(
          MessageCode.LISTEN_ADDRESS
              + " cannot listen on "
              + host
              + ": other machines could connect without encryption or identity. Make certificates"
              + " with \"mech keys\" and name them with --tls, or listen on 127.0.0.1");
    }
    if (address.isAnyLocalAddress()) {
      throw new IllegalArgumentException(
          MessageCode.LISTEN_ADDRESS
              + " cannot listen on "
              + host
              + ", which stands for every address of this machine: references need the one address"
              + " at which clients reach it");
    }
  }

  /** An address without encryption. */
  public ListenAddress(String host, int port) {
    this(host, port, Optional.empty());
  }

  private static InetAddress addressOf(String host) {
    try {
      return InetAddress.getByName(host.isEmpty() ? "0.0.0.0" : host);
    } catch (UnknownHostException e) {
      throw new IllegalArgumentException(
          MessageCode.LISTEN_ADDRESS
              + " cannot listen on "
              + host
              + ": no such host; use 127.0.0.1",
          e);
    }
  }

  /** Returns {@code host:port}. */
  @Override
  public String toString() {
    return host + ":" + port;
  }
}
