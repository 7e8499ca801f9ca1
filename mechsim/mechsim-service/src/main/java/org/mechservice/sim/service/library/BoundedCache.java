package org.mechservice.sim.service.library;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.function.Supplier;
import java.util.function.ToLongFunction;
import org.jspecify.annotations.Nullable;

/**
 * A cache of the most recently used values, bounded in number and in total size; the latest value
 * is kept whatever its size. A second request for a value that is being made waits for it.
 * Thread-safe.
 *
 * @param <K> type of keys
 * @param <V> type of values
 */
final class BoundedCache<K, V> {
  private final int most;
  private final long largest;
  private final ToLongFunction<V> size;

  /** In the order of use, the latest last. */
  private final Map<K, Making<V>> kept = new LinkedHashMap<>(16, 0.75f, true);

  /**
   * @param most largest number of values
   * @param largest largest total size
   * @param size of one of them
   */
  BoundedCache(int most, long largest, ToLongFunction<V> size) {
    this.most = most;
    this.largest = largest;
    this.size = size;
  }

  /** Returns a value that is in the cache. */
  synchronized Optional<V> known(K key) {
    Making<V> making = kept.get(key);
    return making == null ? Optional.empty() : Optional.ofNullable(made(making));
  }

  /**
   * Returns a value; makes it if it is not in the cache. If the thread is interrupted it waits no
   * longer; an interrupt stops the making once no caller waits for it.
   *
   * @param make runs in the executor; its exception is thrown here, and the next call makes it
   *     again
   * @throws CancellationException if the thread is interrupted, which it stays
   */
  V get(K key, Executor executor, Supplier<V> make) {
    while (true) {
      try {
        return once(key, executor, make);
      } catch (CancellationException e) {
        if (Thread.currentThread().isInterrupted()) {
          throw e;
        }
        // the thread of another caller was interrupted while it made the value for both
      }
    }
  }

  private V once(K key, Executor executor, Supplier<V> make) {
    Making<V> making;
    boolean begins;
    synchronized (this) {
      begins = !kept.containsKey(key);
      making = kept.computeIfAbsent(key, absent -> new Making<>());
      making.waiting++;
    }
    if (begins) {
      executor.execute(() -> making.make(make));
    }
    try {
      V value = making.value.get();
      bound(making);
      return value;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      CancellationException cancelled = new CancellationException("the caller was interrupted");
      cancelled.initCause(e);
      throw cancelled;
    } catch (ExecutionException e) {
      synchronized (this) {
        kept.remove(key, making);
      }
      if (e.getCause() instanceof RuntimeException cause) {
        throw cause;
      }
      throw new CompletionException(e.getCause());
    } finally {
      leave(key, making);
    }
  }

  private synchronized void leave(K key, Making<V> making) {
    making.waiting--;
    if (making.waiting == 0 && !making.value.isDone()) {
      kept.remove(key, making);
      making.cancel();
    }
  }

  /** Removes a value. */
  synchronized void forget(K key) {
    kept.remove(key);
  }

  /** Removes the least recently used values; a value that is still being made has no size yet. */
  private synchronized void bound(Making<V> wanted) {
    long sum = kept.values().stream().mapToLong(this::sizeOf).sum();
    Iterator<Making<V>> oldest = kept.values().iterator();
    while (oldest.hasNext() && (sum > largest || kept.size() > most)) {
      Making<V> next = oldest.next();
      if (next != wanted && next.value.isDone()) {
        sum -= sizeOf(next);
        oldest.remove();
      }
    }
  }

  private long sizeOf(Making<V> making) {
    V value = made(making);
    return value == null ? 0 : size.applyAsLong(value);
  }

  private static <V> @Nullable V made(Making<V> making) {
    CompletableFuture<V> value = making.value;
    return value.isDone() && !value.isCompletedExceptionally() ? value.join() : null;
  }

  /** A value that is being made, or is there. */
  private static final class Making<V> {
    final CompletableFuture<V> value = new CompletableFuture<>();

    /** Callers that wait; guarded by the cache. */
    int waiting;

    private Optional<Thread> maker = Optional.empty();
    private boolean cancelled;

    void make(Supplier<V> supplier) {
      synchronized (this) {
        if (cancelled) {
          value.completeExceptionally(new CancellationException());
          return;
        }
        maker = Optional.of(Thread.currentThread());
      }
      try {
        value.complete(supplier.get());
      } catch (Throwable e) { // the caller throws it
        value.completeExceptionally(e);
      } finally {
        synchronized (this) {
          maker = Optional.empty();
          if (cancelled) {
            Thread.interrupted(); // the thread makes other values next
          }
        }
      }
    }

    /** Stops the making. */
    synchronized void cancel() {
      cancelled = true;
      maker.ifPresent(Thread::interrupt);
    }
  }
}
