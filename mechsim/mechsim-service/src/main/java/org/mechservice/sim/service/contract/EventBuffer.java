package org.mechservice.sim.service.contract;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.function.LongFunction;
import java.util.function.Predicate;
import java.util.function.ToLongFunction;

/**
 * The latest events of a session, a host or a server, numbered from 1, for readers that poll.
 * Thread-safe.
 *
 * @param <E> type of the events; each contains its number
 */
final class EventBuffer<E> {
  private final int capacity;
  private final ToLongFunction<E> number;
  private final Deque<E> events = new ArrayDeque<>();
  private long lastNumber;
  private boolean closed;

  /**
   * @param capacity most events kept
   * @param number returns the number of an event
   */
  EventBuffer(int capacity, ToLongFunction<E> number) {
    this.capacity = capacity;
    this.number = number;
  }

  /**
   * Adds an event.
   *
   * @param create makes the event with the number given
   * @return the event
   */
  synchronized E add(LongFunction<E> create) {
    lastNumber++;
    E added = create.apply(lastNumber);
    events.addLast(added);
    if (events.size() > capacity) {
      events.removeFirst();
    }
    notifyAll();
    return added;
  }

  /** Replaces events by a new one. */
  synchronized void replace(Predicate<E> old, LongFunction<E> create) {
    events.removeIf(old);
    add(create);
  }

  /**
   * Returns the events after a number, oldest first; waits until there is one, the time is over or
   * the buffer is closed.
   *
   * @param afterNumber number of the last event already known
   * @param maxCount most events to return
   * @param millis longest wait, ms
   */
  synchronized List<E> after(long afterNumber, long maxCount, long millis)
      throws InterruptedException {
    long deadline = System.nanoTime() + millis * 1_000_000;
    while (lastNumber <= afterNumber && !closed) {
      long left = (deadline - System.nanoTime() + 999_999) / 1_000_000;
      if (left <= 0) {
        break;
      }
      wait(left);
    }
    List<E> found = new ArrayList<>();
    for (E event : events) {
      if (number.applyAsLong(event) > afterNumber && found.size() < maxCount) {
        found.add(event);
      }
    }
    return found;
  }

  /** Returns the events that are kept and match, oldest first. */
  synchronized List<E> matching(Predicate<E> wanted) {
    return events.stream().filter(wanted).toList();
  }

  /** Wakes all readers that wait; later calls do not wait. */
  synchronized void close() {
    closed = true;
    notifyAll();
  }
}
