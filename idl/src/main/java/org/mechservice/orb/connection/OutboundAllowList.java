package org.mechservice.orb.connection;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Map;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;

/**
 * The addresses an ORB may connect to. An object reference sent by a client can name any address,
 * and a server that calls it would connect there on the client's behalf. Servers and hosts
 * therefore connect to registered addresses only; callbacks need none, they use the client's own
 * connection.
 */
public final class OutboundAllowList {
  /** The ORB makes its socket factory itself and hands it properties only: this finds the list. */
  private static final Map<String, OutboundAllowList> BY_ID = new ConcurrentHashMap<>();

  /** Allows nothing, ever: what a factory holds until it is configured. */
  public static final OutboundAllowList NONE = new OutboundAllowList(false);

  private final String id = UUID.randomUUID().toString();
  private final boolean everything;
  private final Set<String> allowed = ConcurrentHashMap.newKeySet();

  private OutboundAllowList(boolean everything) {
    this.everything = everything;
    BY_ID.put(id, this);
  }

  public static OutboundAllowList ofEverything() {
    return new OutboundAllowList(true);
  }

  public static OutboundAllowList ofNothing() {
    return new OutboundAllowList(false);
  }

  public static OutboundAllowList byId(String id) {
    OutboundAllowList list = BY_ID.get(id);
    if (list == null) {
      throw new IllegalArgumentException("no allow-list " + id);
    }
    return list;
  }

  public String id() {
    return id;
  }

  public void forget() {
    BY_ID.remove(id);
  }

  /**
   * Allows connections to an address from now on.
   *
   * @throws UnknownHostException if the host has no address
   */
  public void allow(String host, int port) throws UnknownHostException {
    for (InetAddress address : InetAddress.getAllByName(host)) {
      allowed.add(entry(address, port));
    }
  }

  /** Allows no new connections to an address any more. */
  public void forbid(String host, int port) {
    try {
      for (InetAddress address : InetAddress.getAllByName(host)) {
        allowed.remove(entry(address, port));
      }
    } catch (UnknownHostException e) {
      allowed.removeIf(entry -> entry.endsWith(":" + port));
    }
  }

  /** Returns whether a connection to an address may be opened. */
  boolean allows(InetAddress address, int port) {
    return everything || allowed.contains(entry(address, port));
  }

  private static String entry(InetAddress address, int port) {
    return address.getHostAddress() + ":" + port;
  }
}
