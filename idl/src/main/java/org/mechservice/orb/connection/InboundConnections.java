package org.mechservice.orb.connection;

import java.io.IOException;
import java.net.InetAddress;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.mechservice.orb.connection.InboundSocketFactory.Accepted;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The connections that others have opened to an ORB. The ORB itself forgets those that it accepts
 * while it closes; they would stay open unread, and their peers would wait for an answer. Here all
 * of them are closed.
 *
 * <p>Useless connections do not keep others out. One that is late with its first message, or with
 * the rest of a message, is closed. Where there are as many as are allowed, a new one takes the
 * place of another, of the address that has most of them: of the oldest that has not sent a message
 * yet, if these have more than a quarter of the places; else of the one that has been silent
 * longest, among those whose peers have no session here and wait for no answer; else of one that
 * has been silent for longer than any lease. A peer whose connection is closed connects anew with
 * its next call. No other machine may have more than three quarters of the places.
 */
public final class InboundConnections {
  private static final Logger LOG = LoggerFactory.getLogger(InboundConnections.class);

  /** The ORB makes its socket factory itself and hands it properties only: this finds the set. */
  private static final Map<String, InboundConnections> BY_ID = new ConcurrentHashMap<>();

  private final String id = UUID.randomUUID().toString();

  /** Time between two looks for connections that are late, ms. */
  private static final long WATCH_MILLIS = 500;

  /** Longer than any lease: the peer has nothing left here that it could come back to. */
  private static final long IDLE_NANOS = 150_000_000_000L;

  private final Set<Accepted> open = new LinkedHashSet<>();
  private final ReplyMemory room = new ReplyMemory();
  private final RequestMemory requests = new RequestMemory();
  private int most = Integer.MAX_VALUE;
  private boolean closed;
  private @Nullable Thread watch;

  public InboundConnections() {
    BY_ID.put(id, this);
  }

  static InboundConnections byId(String id) {
    InboundConnections connections = BY_ID.get(id);
    if (connections == null) {
      throw new IllegalArgumentException("no connections " + id);
    }
    return connections;
  }

  public String id() {
    return id;
  }

  /** Returns the memory for answers to those connected. */
  public ReplyMemory room() {
    return room;
  }

  /** Returns the memory for large messages from those connected. */
  RequestMemory requests() {
    return requests;
  }

  /** Sets how many connections there may be; those there are stay. */
  public synchronized void allow(int connections) {
    most = connections;
  }

  /**
   * Takes a connection in. One too many is closed at once if no other can make room; so is each one
   * when all have been closed.
   */
  void add(Accepted connection) throws IOException {
    Optional<Accepted> inTheWay = Optional.empty();
    boolean entered = false;
    synchronized (this) {
      if (!closed) {
        inTheWay = inTheWayOf(connection);
        inTheWay.ifPresent(open::remove);
        entered = hasRoomFor(connection);
        if (entered) {
          enter(connection);
        }
      }
    }
    inTheWay.ifPresent(Accepted::abandon);
    if (!entered) {
      connection.close();
    }
  }

  private void enter(Accepted connection) {
    open.add(connection);
    if (watch == null) {
      watch = new Thread(this::watch, "mechservice-connections");
      watch.setDaemon(true);
      watch.start();
    }
  }

  private boolean hasRoomFor(Accepted connection) {
    return open.size() < most && !hasTooMany(connection.getInetAddress());
  }

  /** Other machines share the places; all clients of this one have the same address. */
  private boolean hasTooMany(InetAddress address) {
    return !address.isLoopbackAddress()
        && open.stream().filter(other -> address.equals(other.getInetAddress())).count()
            >= most - most / 4;
  }

  /** Returns the connection that gives its place to a new one, if it must and one can. */
  private Optional<Accepted> inTheWayOf(Accepted connection) {
    if (hasRoomFor(connection)) {
      return Optional.empty();
    }
    InetAddress address = connection.getInetAddress();
    InetAddress crowd = hasTooMany(address) ? address : mostCommonAddress();
    Optional<Accepted> ofCrowd =
        leastUseful(open.stream().filter(other -> crowd.equals(other.getInetAddress())).toList());
    return hasTooMany(address) ? ofCrowd : ofCrowd.or(() -> leastUseful(List.copyOf(open)));
  }

  private InetAddress mostCommonAddress() {
    Map<InetAddress, Long> counts =
        open.stream()
            .collect(Collectors.groupingBy(Accepted::getInetAddress, Collectors.counting()));
    return Collections.max(counts.entrySet(), Map.Entry.comparingByValue()).getKey();
  }

  /** Newcomers have a quarter of the places: they are given up first where they have more. */
  private Optional<Accepted> leastUseful(List<Accepted> candidates) {
    List<Accepted> unused = candidates.stream().filter(other -> !other.isUsed()).toList();
    Optional<Accepted> newcomer = unused.stream().findFirst();
    Optional<Accepted> idle = longestSilent(candidates, each -> each.isUsed() && each.isIdle());
    return (unused.size() > most / 4 ? newcomer.or(() -> idle) : idle.or(() -> newcomer))
        .or(() -> longestSilent(candidates, other -> other.stalledNanos() > IDLE_NANOS));
  }

  private static Optional<Accepted> longestSilent(
      List<Accepted> candidates, Predicate<Accepted> which) {
    return candidates.stream().filter(which).max(Comparator.comparingLong(Accepted::stalledNanos));
  }

  /** Closes connections whose peers are late, until all are closed. */
  private void watch() {
    try {
      while (true) {
        List<Accepted> all;
        synchronized (this) {
          if (closed) {
            return;
          }
          wait(WATCH_MILLIS);
          all = List.copyOf(open);
        }
        for (Accepted connection : all) {
          if (connection.isOverdue()) {
            LOG.debug("closed a connection from {} that is late", connection.getInetAddress());
            connection.abandon();
          }
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  synchronized void remove(Accepted connection) {
    open.remove(connection);
  }

  /** Returns how many connections have sent a message. */
  public synchronized int count() {
    return (int) open.stream().filter(Accepted::isUsed).count();
  }

  /**
   * Returns how many connections are in use: their peers wait for an answer or have a session here.
   * The others would give their places to new ones.
   */
  public synchronized int countBusy() {
    return (int) open.stream().filter(each -> each.isUsed() && !each.isIdle()).count();
  }

  /** Closes all connections, and those to come. */
  public void closeAll() {
    List<Accepted> all;
    synchronized (this) {
      closed = true;
      notifyAll(); // ends the watch
      all = List.copyOf(open);
    }
    for (Accepted connection : all) {
      try {
        connection.close();
      } catch (IOException e) {
        LOG.debug("a connection does not close in order: {}", e.toString());
      }
    }
    BY_ID.remove(id);
    room.close();
  }
}
