package org.mechservice.study.run;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * Runs numbered pieces of work in several threads and hands out their results in order. Pieces are
 * taken in chunks of about a fifth of a second; a bounded number of chunks is under way or waits.
 *
 * @param <R> result of a piece
 */
final class OrderedChunks<R> {
  private static final double CHUNK_SECONDS = 0.2;
  private static final int MOST_PIECES = 1024;
  private static final int CHUNKS_PER_THREAD = 8;

  /** A piece of work. */
  interface Piece<R> {
    R run(int number) throws IOException;
  }

  /** Takes results. */
  interface Taker<R> {
    /**
     * Takes the results of successive pieces.
     *
     * @return whether more are wanted
     */
    boolean take(int first, Iterable<R> results) throws IOException;
  }

  private record Chunk<R>(int first, Deque<R> results, double seconds) {}

  private final Piece<R> piece;
  private final AtomicBoolean stopped = new AtomicBoolean();

  OrderedChunks(Piece<R> piece) {
    this.piece = piece;
  }

  /** Makes {@link #run} return soon; may be called from any thread. */
  void stop() {
    stopped.set(true);
  }

  /**
   * Runs pieces.
   *
   * @throws IOException if a piece or the taker throws it
   * @throws InterruptedException if the thread is interrupted
   */
  void run(int from, int to, int threads, Taker<R> taker) throws IOException, InterruptedException {
    ExecutorService pool =
        Executors.newFixedThreadPool(
            threads,
            work -> {
              Thread thread = new Thread(work, "mechservice-study");
              thread.setDaemon(true);
              return thread;
            });
    try {
      Deque<Future<Chunk<R>>> open = new ArrayDeque<>();
      int next = from;
      int size = 1;
      boolean wanted = true;
      while (wanted && !stopped.get() && (next < to || !open.isEmpty())) {
        while (next < to && open.size() < CHUNKS_PER_THREAD * threads) {
          int first = next;
          int end = Math.min(to, first + Math.min(size, 1 + (to - first) / (4 * threads)));
          open.addLast(pool.submit(() -> chunk(first, end)));
          next = end;
        }
        Chunk<R> done = open.removeFirst().get();
        wanted = done.results.isEmpty() || taker.take(done.first, done.results);
        size = size(done);
      }
    } catch (ExecutionException e) {
      if (e.getCause() instanceof IOException failure) {
        throw failure;
      } else if (e.getCause() instanceof RuntimeException failure) {
        throw failure;
      }
      throw new IllegalStateException(e.getCause());
    } finally {
      stopped.set(true);
      pool.shutdown();
    }
  }

  private static int size(Chunk<?> done) {
    double each = done.seconds / Math.max(1, done.results.size());
    return (int) Math.max(1, Math.min(MOST_PIECES, CHUNK_SECONDS / Math.max(each, 1e-9)));
  }

  /** Returns the results of the pieces until the work is stopped. */
  private Chunk<R> chunk(int first, int end) throws IOException {
    long begun = System.nanoTime();
    Deque<R> results = new ArrayDeque<>(end - first);
    for (int i = first; i < end && !stopped.get(); i++) {
      results.addLast(piece.run(i));
    }
    return new Chunk<>(first, results, (System.nanoTime() - begun) * 1e-9);
  }
}
