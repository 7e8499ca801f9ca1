package org.mechservice.admin.live;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.admin.AdminConsole;
import org.mechservice.admin.AdminTarget;
import org.mechservice.admin.ServerReading;
import org.mechservice.idl.HostStatus;
import org.mechservice.idl.ServiceEvent;

/**
 * The present state of the servers of a console. Each server is followed by a thread of its own, so
 * that one that hangs delays nothing but its own line. Thread-safe.
 */
public final class LiveView implements AutoCloseable {
  private static final int EVENTS_KEPT = 500;

  /** Ten minutes, at one sample a second. */
  private static final int SAMPLES_KEPT = 600;

  private static final long SAMPLE_MILLIS = 1000;

  private final List<ServerFollower> followers;
  private final Map<String, ServerReading> readings = new LinkedHashMap<>();
  private final Deque<ReceivedEvent> events = new ArrayDeque<>();
  private final Map<AdminTarget, Deque<LoadSample>> loads = new HashMap<>();
  private long lastEvent;

  /** The first version: no server has answered yet. */
  private long version = 1;

  private boolean closed;

  /**
   * Begins to follow.
   *
   * @param console of whose servers; stays open
   */
  public LiveView(AdminConsole console) {
    for (String server : console.servers()) {
      readings.put(server, new ServerReading.Connecting(server));
    }
    followers =
        console.servers().stream()
            .map(server -> new ServerFollower(console, server, this))
            .toList();
    followers.forEach(ServerFollower::start);
  }

  /** Returns the latest reading of each server. */
  public synchronized List<ServerReading> readings() {
    return List.copyOf(readings.values());
  }

  /** Returns the latest events of all servers, oldest first. */
  public synchronized List<ReceivedEvent> events() {
    return List.copyOf(events);
  }

  /** Returns how busy a host was, oldest first, as long as this was followed. */
  public synchronized List<LoadSample> loads(AdminTarget host) {
    return List.copyOf(loads.getOrDefault(host, new ArrayDeque<>()));
  }

  /** Returns a number that grows with each change. */
  public synchronized long version() {
    return version;
  }

  /**
   * Waits for a change after a version, the end of the time, or the end of the view.
   *
   * @return the version now
   */
  public synchronized long awaitAfter(long known, Duration longest) throws InterruptedException {
    long deadline = System.nanoTime() + longest.toNanos();
    while (version <= known && !closed) {
      long left = (deadline - System.nanoTime() + 999_999) / 1_000_000;
      if (left <= 0) {
        break;
      }
      wait(left);
    }
    return version;
  }

  /** Returns whether the view is closed, so that no change follows. */
  public synchronized boolean isClosed() {
    return closed;
  }

  synchronized void took(ServerReading reading) {
    readings.put(reading.address(), reading);
    if (reading instanceof ServerReading.Answering answering) {
      long now = System.currentTimeMillis();
      for (HostStatus host : answering.hosts()) {
        if (host.reachable) {
          sample(new AdminTarget(reading.address(), host.info.name), LoadSample.of(host.load, now));
        }
      }
      loads
          .keySet()
          .removeIf(host -> host.server().equals(reading.address()) && !has(answering, host));
    }
    changed();
  }

  private static boolean has(ServerReading.Answering reading, AdminTarget place) {
    return reading.hosts().stream().anyMatch(host -> host.info.name.equals(place.host()));
  }

  private void sample(AdminTarget host, LoadSample sample) {
    Deque<LoadSample> samples = loads.computeIfAbsent(host, unused -> new ArrayDeque<>());
    LoadSample last = samples.peekLast();
    if (last == null || sample.at() - last.at() >= SAMPLE_MILLIS) {
      samples.addLast(sample);
      if (samples.size() > SAMPLES_KEPT) {
        samples.removeFirst();
      }
    }
  }

  synchronized void record(String server, List<ServiceEvent> happened) {
    for (ServiceEvent event : happened) {
      lastEvent++;
      events.addLast(new ReceivedEvent(lastEvent, server, event));
      if (events.size() > EVENTS_KEPT) {
        events.removeFirst();
      }
    }
    if (!happened.isEmpty()) {
      changed();
    }
  }

  private void changed() {
    version++;
    notifyAll();
  }

  @Override
  public void close() {
    followers.forEach(ServerFollower::close);
    synchronized (this) {
      closed = true;
      notifyAll();
    }
  }
}
