package org.mechservice.server.hosts;

import static java.time.temporal.ChronoUnit.SECONDS;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.mechservice.idl.HostInfo;
import org.mechservice.idl.HostLoad;
import org.mechservice.idl.HostStatus;
import org.mechservice.idl.MechSimHostOperations;
import org.mechservice.idl.NameValue;
import org.mechservice.orb.connection.Endpoint;

/** A host as its server knows it. Thread-safe. */
public final class RegisteredHost {
  private static final AtomicLong JOINED = new AtomicLong();

  private final HostInfo info;
  private final MechSimHostOperations host;
  private final boolean own;
  private final Endpoint endpoint;
  private long renewedAt = System.nanoTime();
  private long lastSeen = System.currentTimeMillis();
  private final Deque<Long> placedAt = new ArrayDeque<>();
  private final long joined = JOINED.incrementAndGet();
  private HostLoad load = new HostLoad(0, 0, 0, 0, 0, false, new NameValue[0]);
  private long drainingSaidAt = Long.MIN_VALUE;
  private long lastEvent;
  private boolean reachable = true;
  private boolean dropped;
  private String text = "";
  private long answeredAt = System.currentTimeMillis();
  private long heardAt = System.nanoTime();
  private final Deque<Long> unanswered = new ArrayDeque<>();
  private final Deque<HostCalls.Query<?>> owed = new ArrayDeque<>();
  private volatile Runnable farewell = () -> {};

  /**
   * @param host reference for calls
   * @param own whether it is the server's own process
   * @param endpoint where it is
   */
  public RegisteredHost(HostInfo info, MechSimHostOperations host, boolean own, Endpoint endpoint) {
    this.info = info;
    this.host = host;
    this.own = own;
    this.endpoint = endpoint;
  }

  /** Sets an action for the time when the host is removed. */
  void onRemoval(Runnable last) {
    farewell = last;
  }

  /** Called when the host is known no longer. */
  void removed() {
    farewell.run();
  }

  public String name() {
    return info.name;
  }

  public MechSimHostOperations host() {
    return host;
  }

  public boolean own() {
    return own;
  }

  Endpoint endpoint() {
    return endpoint;
  }

  /** Records the start of a call; returns its time, by {@link System#nanoTime}. */
  synchronized long callBegins() {
    long now = System.nanoTime();
    unanswered.addLast(now);
    return now;
  }

  /** Notes that a question has ended, with an answer or without. */
  synchronized void callEnded(long askedAt) {
    unanswered.removeFirstOccurrence(askedAt);
  }

  /**
   * Returns whether a call has waited for so long, and no other call was answered meanwhile: one
   * hanging call does not make a host silent that answers others.
   */
  synchronized boolean isOverdue(Duration since) {
    Long oldest = unanswered.peekFirst();
    if (oldest == null) {
      return false;
    }
    long now = System.nanoTime();
    return Math.min(now - oldest, now - heardAt) >= since.toNanos();
  }

  /** Adds a call to be made as soon as the host answers again. */
  synchronized void callLater(HostCalls.Query<?> later) {
    owed.addLast(later);
  }

  /** Removes and returns the calls to be made. */
  synchronized List<HostCalls.Query<?>> takePendingCalls() {
    List<HostCalls.Query<?>> all = List.copyOf(owed);
    owed.clear();
    return all;
  }

  synchronized void renew() {
    renewedAt = System.nanoTime();
    lastSeen = System.currentTimeMillis();
  }

  synchronized boolean expired(Duration lease) {
    return !own && System.nanoTime() - renewedAt > lease.toNanos();
  }

  /** Returns the host's place in the order in which hosts joined. */
  long joined() {
    return joined;
  }

  /**
   * Records the load that the host has reported. A dropped host stays dropped: an answer to an
   * earlier call is ignored.
   *
   * @param askedAt when the call began, by {@link System#nanoTime}
   */
  synchronized void answered(HostLoad said, long askedAt) {
    if (dropped) {
      return;
    }
    int more = said.sessions - load.sessions;
    boolean knowsWhatItWasTold = drainingSaidAt == Long.MIN_VALUE || askedAt - drainingSaidAt > 0;
    load = draining(said, knowsWhatItWasTold ? said.draining : load.draining);
    reachable = true;
    text = "";
    lastSeen = System.currentTimeMillis();
    answeredAt = lastSeen;
    heardAt = System.nanoTime();
    // The reported load includes sessions placed before; and of those placed while it was on its
    // way at least as many as it has grown by otherwise.
    while (!placedAt.isEmpty() && (placedAt.peekFirst() - askedAt < 0 || more > 0)) {
      placedAt.removeFirst();
      more--;
    }
  }

  /** Records a drain or undrain call that the reported load does not show yet. */
  public synchronized void recordDraining(boolean drain) {
    drainingSaidAt = System.nanoTime();
    load = draining(load, drain);
  }

  private static HostLoad draining(HostLoad load, boolean drain) {
    return new HostLoad(
        load.sessions,
        load.running,
        load.queued,
        load.cpuLoad,
        load.memoryUsed,
        drain,
        load.statistics);
  }

  /** Records a session placed on the host that the reported load does not show yet. */
  synchronized void placed() {
    placedAt.addLast(System.nanoTime());
  }

  /** Returns the number of the last event received from it. */
  synchronized long lastEvent() {
    return lastEvent;
  }

  /** Records the number of the last event received. */
  synchronized void tookOver(long event) {
    lastEvent = event;
  }

  /** Records that the host did not answer. */
  synchronized void silent(String why) {
    if (!dropped) {
      reachable = false;
      text = "silent since " + Instant.ofEpochMilli(answeredAt).truncatedTo(SECONDS) + ": " + why;
    }
  }

  /** Returns whether it answers. */
  public synchronized boolean reachable() {
    return reachable;
  }

  /** Returns why it does not answer; empty if it does. */
  public synchronized String trouble() {
    return text;
  }

  synchronized boolean isDropped() {
    return dropped;
  }

  /** Marks the host as dropped, permanently. */
  synchronized void dropped(String why) {
    dropped = true;
    reachable = false;
    text = "dropped: " + why;
  }

  public synchronized HostLoad load() {
    return load;
  }

  /** Returns whether the host may get new sessions. */
  public synchronized boolean open() {
    return reachable && !load.draining;
  }

  /** Returns how many simulations it runs at once. */
  int capacity() {
    return info.capacity;
  }

  /** Returns how many more simulations find a place at once; negative: so many wait. */
  synchronized int freePlaces() {
    return info.capacity - Math.max(load.sessions, load.running + load.queued) - placedAt.size();
  }

  /** Returns the memory that its process may use, B. */
  public long memoryBytes() {
    return info.memoryBytes;
  }

  synchronized HostStatus status() {
    return new HostStatus(info, load, reachable, lastSeen, text);
  }
}
