package org.mechservice.sim.service.run;

import java.util.ArrayDeque;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.sim.service.limits.CurrentLimits;
import org.mechservice.sim.service.limits.HostLimit;

/**
 * Runs simulations, as many at once as the host's capacity; the others wait. A free place goes to
 * the user who has the fewest, of several to the one who was served least recently, and there to
 * the run that came first: who has a thousand runs delays one who has one by no more than a run.
 * Runs may take a day, so a user without a run does not wait for a user with several: his first run
 * begins beside them, as long as there are no more than twice the capacity.
 */
public final class RunQueue implements AutoCloseable {
  private final int capacity;
  private final CurrentLimits limits;
  private final ThreadPoolExecutor threads;

  /** Waiting runs by user. No user without runs. */
  private final Map<String, Deque<Runnable>> waiting = new LinkedHashMap<>();

  /** Runs that compute or are paused, by user. */
  private final Map<String, Integer> active = new HashMap<>();

  /** When users with runs that wait or compute were served last, as a count of runs served. */
  private final Map<String, Long> served = new HashMap<>();

  private long servings;

  /**
   * @param capacity simulations at once
   */
  public RunQueue(int capacity, CurrentLimits limits) {
    this.capacity = Math.max(1, capacity);
    this.limits = limits;
    threads =
        new ThreadPoolExecutor(
            0,
            Integer.MAX_VALUE,
            0, // a thread may have lost its priority to a long run
            TimeUnit.SECONDS,
            new SynchronousQueue<>(),
            task -> {
              Thread thread = new Thread(task, "mechservice-run");
              thread.setDaemon(true);
              return thread;
            });
  }

  /**
   * Makes sure that one more can wait. Who has less than an equal part of a full queue finds room.
   *
   * @throws LimitExceeded if too many wait already
   */
  synchronized void requireRoom(String user) throws LimitExceeded {
    int own = waiting.getOrDefault(user, new ArrayDeque<>()).size();
    int others = waiting.size() - (own > 0 ? 1 : 0);
    if (activeRuns() >= capacity
        && (others == 0 || own >= limits.now().bound(HostLimit.QUEUE) / (others + 1))) {
      limits.now().requireBelow(HostLimit.QUEUE, waitingRuns());
    }
  }

  private int activeRuns() {
    return active.values().stream().mapToInt(Integer::intValue).sum();
  }

  private int waitingRuns() {
    return waiting.values().stream().mapToInt(Deque::size).sum();
  }

  /**
   * Runs something as soon as there is a place.
   *
   * @param user whose it is
   */
  synchronized void submit(String user, Runnable run) {
    waiting.computeIfAbsent(user, any -> new ArrayDeque<>()).add(run);
    fill();
  }

  /** Gives free places to waiting runs. */
  private void fill() {
    while (!waiting.isEmpty()) {
      String user = next(waiting, active, served).orElseThrow();
      if (activeRuns() >= capacity && !beginsBeside(user)) {
        return;
      }
      Runnable run = taken(user, waiting);
      served.put(user, ++servings);
      active.merge(user, 1, Integer::sum);
      threads.execute(
          () -> {
            try {
              run.run();
            } finally {
              ended(user);
            }
          });
    }
  }

  /** Returns whether a run of a user begins although no place is free. */
  private boolean beginsBeside(String user) {
    return !active.containsKey(user)
        && activeRuns() < 2 * capacity
        && active.values().stream().anyMatch(count -> count > 1);
  }

  private synchronized void ended(String user) {
    active.computeIfPresent(user, (any, count) -> count == 1 ? null : count - 1);
    if (!threads.isShutdown()) {
      fill();
    }
    served.keySet().removeIf(any -> !active.containsKey(any) && !waiting.containsKey(any));
  }

  /** Returns the user who is served next. */
  private static Optional<String> next(
      Map<String, Deque<Runnable>> waiting, Map<String, Integer> active, Map<String, Long> served) {
    return waiting.keySet().stream()
        .min(
            Comparator.comparingInt((String user) -> active.getOrDefault(user, 0))
                .thenComparingLong(user -> served.getOrDefault(user, 0L)));
  }

  /** Takes the first run of a user. */
  private static Runnable taken(String user, Map<String, Deque<Runnable>> waiting) {
    Deque<Runnable> own = waiting.get(user);
    if (own == null) {
      throw new IllegalArgumentException(user + " has no run that waits");
    }
    Runnable first = own.remove();
    if (own.isEmpty()) {
      waiting.remove(user);
    }
    return first;
  }

  /** Takes a run that still waits out of the queue; returns whether it was there. */
  synchronized boolean withdraw(Runnable run) {
    boolean found = waiting.values().stream().anyMatch(own -> own.remove(run));
    waiting.values().removeIf(Deque::isEmpty);
    return found;
  }

  /**
   * Returns the place of a waiting run, from 1, if no more are added and those that run end one
   * after the other; 0 if it does not wait.
   */
  synchronized int positionOf(Runnable run) {
    if (waiting.values().stream().noneMatch(own -> own.contains(run))) {
      return 0;
    }
    Map<String, Deque<Runnable>> left = new LinkedHashMap<>();
    waiting.forEach((user, own) -> left.put(user, new ArrayDeque<>(own)));
    Map<String, Integer> running = new HashMap<>(active);
    Map<String, Long> last = new HashMap<>(served);
    for (int position = 1; ; position++) {
      String user = next(left, running, last).orElseThrow();
      if (taken(user, left) == run) {
        return position;
      }
      running.merge(user, 1, Integer::sum);
      last.put(user, servings + position);
    }
  }

  /** Takes no more runs; those there are must have been stopped. */
  @Override
  public synchronized void close() {
    threads.shutdown();
    waiting.clear();
  }

  /** Waits until no run is left. */
  public void awaitEnd(long millis) throws InterruptedException {
    threads.awaitTermination(millis, TimeUnit.MILLISECONDS);
  }
}
