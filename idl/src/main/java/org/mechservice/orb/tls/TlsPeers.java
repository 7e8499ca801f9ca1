package org.mechservice.orb.tls;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.security.cert.X509Certificate;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import org.mechservice.orb.connection.Endpoint;

/** The TLS side of an ORB's connections: its own identity, and the certificates of its peers. */
public final class TlsPeers {
  /** The ORB makes its socket factories itself and hands them properties only: this finds these. */
  private static final Map<String, TlsPeers> BY_ID = new ConcurrentHashMap<>();

  private final String id = UUID.randomUUID().toString();
  private final TlsIdentity identity;
  private final Map<String, Set<String>> names = new ConcurrentHashMap<>();
  private final Map<String, X509Certificate> shown = new ConcurrentHashMap<>();
  private final Map<String, String> refused = new ConcurrentHashMap<>();

  public TlsPeers(TlsIdentity identity) {
    this.identity = identity;
    BY_ID.put(id, this);
  }

  static TlsPeers byId(String id) {
    TlsPeers peers = BY_ID.get(id);
    if (peers == null) {
      throw new IllegalArgumentException("no identity " + id);
    }
    return peers;
  }

  public String id() {
    return id;
  }

  public TlsIdentity identity() {
    return identity;
  }

  public void forget() {
    BY_ID.remove(id);
  }

  /** Records the name that a user wrote for an address; the ORB itself knows the address only. */
  public void calledBy(String name) throws UnknownHostException {
    for (InetAddress address : InetAddress.getAllByName(name)) {
      names
          .computeIfAbsent(address.getHostAddress(), any -> ConcurrentHashMap.newKeySet())
          .add(name);
    }
  }

  /** Returns the names that users wrote for an address. */
  Set<String> namesOf(String address) {
    return names.getOrDefault(address, Set.of());
  }

  /** Records the verified certificate of a peer. */
  void accepted(String address, int port, X509Certificate certificate) {
    shown.put(address + ":" + port, certificate);
    refused.remove(address + ":" + port);
  }

  /** Notes why a connection was not made. */
  void refused(String address, int port, String why) {
    refused.put(address + ":" + port, why);
  }

  /** Returns what was shown at an address when it was connected to last. */
  public Optional<X509Certificate> shownAt(Endpoint endpoint) {
    return Optional.ofNullable(shown.get(endpoint.toString()));
  }

  /** Returns why the last connection to an address was not made, if it was not. */
  public Optional<String> refusedAt(Endpoint endpoint) {
    return Optional.ofNullable(refused.get(endpoint.toString()));
  }
}
