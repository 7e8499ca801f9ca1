package org.mechservice.server;

import java.time.Duration;
import org.mechservice.idl.HostInfo;
import org.mechservice.idl.HostLoad;
import org.mechservice.idl.HostStatus;
import org.mechservice.idl.MechSimHostOperations;
import org.mechservice.orb.Endpoint;

/** A host as its server knows it. Thread-safe. */
final class KnownHost {
  private final HostInfo info;
  private final MechSimHostOperations host;
  private final boolean own;
  private final Endpoint endpoint;
  private long renewedAt = System.nanoTime();
  private long lastSeen = System.currentTimeMillis();
  private HostLoad load = new HostLoad(0, 0, 0, 0, 0, false);
  private boolean reachable = true;
  private String text = "";

  /**
   * @param host how it is asked
   * @param own whether it is the server's own process
   * @param endpoint where it is
   */
  KnownHost(HostInfo info, MechSimHostOperations host, boolean own, Endpoint endpoint) {
    this.info = info;
    this.host = host;
    this.own = own;
    this.endpoint = endpoint;
  }

  String name() {
    return info.name;
  }

  MechSimHostOperations host() {
    return host;
  }

  boolean own() {
    return own;
  }

  Endpoint endpoint() {
    return endpoint;
  }

  synchronized void renew() {
    renewedAt = System.nanoTime();
    lastSeen = System.currentTimeMillis();
  }

  synchronized boolean expired(Duration lease) {
    return !own && System.nanoTime() - renewedAt > lease.toNanos();
  }

  /** Notes what the host said of its load. */
  synchronized void answered(HostLoad said) {
    load = said;
    reachable = true;
    text = "";
    lastSeen = System.currentTimeMillis();
  }

  /** Notes that the host did not answer. */
  synchronized void silent(String why) {
    reachable = false;
    text = why;
  }

  synchronized HostLoad load() {
    return load;
  }

  /** Returns whether the host may get new sessions. */
  synchronized boolean open() {
    return reachable && !load.draining;
  }

  /** Returns how many more simulations find a place at once; negative: so many wait. */
  synchronized int freePlaces() {
    return info.capacity - Math.max(load.sessions, load.running + load.queued);
  }

  synchronized HostStatus status() {
    return new HostStatus(info, load, reachable, lastSeen, text);
  }
}
