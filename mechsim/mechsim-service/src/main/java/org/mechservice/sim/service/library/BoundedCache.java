package org.mechservice.sim.service.library;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
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
  private final Map<K, CompletableFuture<V>> kept = new LinkedHashMap<>(16, 0.75f, true);

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
    CompletableFuture<V> future = kept.get(key);
    return future == null ? Optional.empty() : Optional.ofNullable(made(future));
  }

  /**
   * Returns a value; makes it if it is not in the cache.
   *
   * @param make runs in the executor; its exception is thrown here, and the next call makes it
   *     again
   */
  V get(K key, Executor executor, Supplier<V> make) {
    CompletableFuture<V> future;
    synchronized (this) {
      future = kept.get(key);
      if (future == null) {
        future = CompletableFuture.supplyAsync(make, executor);
        kept.put(key, future);
      }
    }
    try {
      V value = future.join();
      bound(future);
      return value;
    } catch (CompletionException e) {
      synchronized (this) {
        kept.remove(key, future);
      }
      if (e.getCause() instanceof RuntimeException cause) {
        throw cause;
      }
      throw e;
    }
  }

  /** Removes a value. */
  synchronized void forget(K key) {
    kept.remove(key);
  }

  /** Removes the least recently used values; a value that is still being made has no size yet. */
  private synchronized void bound(CompletableFuture<V> wanted) {
    long sum = kept.values().stream().mapToLong(this::sizeOf).sum();
    Iterator<CompletableFuture<V>> oldest = kept.values().iterator();
    while (oldest.hasNext() && (sum > largest || kept.size() > most)) {
      CompletableFuture<V> next = oldest.next();
      if (next != wanted && next.isDone()) {
        sum -= sizeOf(next);
        oldest.remove();
      }
    }
  }

  private long sizeOf(CompletableFuture<V> future) {
    V value = made(future);
    return value == null ? 0 : size.applyAsLong(value);
  }

  private static <V> @Nullable V made(CompletableFuture<V> future) {
    return future.isDone() && !future.isCompletedExceptionally() ? future.join() : null;
  }
}
