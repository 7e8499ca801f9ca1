package org.mechservice.guard;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;

/**
 * Processes with bounded memory that run the product's own code on input which may be dear to work
 * on. Each serves one request at a time, see {@link WarmMain}; afterwards it waits for the next,
 * and later requests find it warm. A thread that is interrupted while it waits for an answer ends
 * the process, so that nothing is computed for a client that has gone. A process that works for
 * long has a lower priority than the others, and ends afterwards. Thread-safe.
 */
public final class WarmProcesses implements AutoCloseable {
  private static final int EXIT_OUT_OF_MEMORY = 3;
  private static final long END_SECONDS = 60;
  private static final long LOOK_MILLIS = 50;

  /** One request and its answer. The first byte that is written says what is asked for. */
  @FunctionalInterface
  public interface Dialogue<T> {
    /** Writes a request and reads the answer. */
    T hold(DataOutputStream out, DataInputStream in) throws IOException;
  }

  private static final class Warm {
    private final Process process;
    private final DataOutputStream out;
    private final DataInputStream in;
    private final WorkerBounds bounds;
    private Object topic = "";

    private Warm(Process process, WorkerBounds bounds) {
      this.process = process;
      this.bounds = bounds;
      out = new DataOutputStream(new BufferedOutputStream(process.getOutputStream()));
      in = new DataInputStream(new BufferedInputStream(process.getInputStream()));
    }
  }

  /** An answer that somebody waits for. */
  private static final class Held {
    private final Process process;
    private final Thread caller;
    private final long end;
    private final long since = System.nanoTime();
    private volatile boolean late;
    private volatile boolean lowered;

    /**
     * @param end latest time of the answer, in the time of {@link System#nanoTime}; the largest
     *     number: none
     */
    private Held(Process process, Thread caller, long end) {
      this.process = process;
      this.caller = caller;
      this.end = end;
    }
  }

  private final Class<?> main;
  private final boolean optimising;
  private final int mostIdle;
  private final Semaphore places;

  /** The latest used first. */
  private final Deque<Warm> idle = new ArrayDeque<>();

  private final Set<Held> watched = new HashSet<>();
  private boolean watching;
  private boolean closed;

  /**
   * @param main main class of the processes, which calls {@link WarmMain#serve}
   * @param optimising whether their code runs long enough to be compiled a second time
   * @param most processes that there are at once; further requests wait
   * @param mostIdle processes that are kept for later requests
   */
  public WarmProcesses(Class<?> main, boolean optimising, int most, int mostIdle) {
    this.main = main;
    this.optimising = optimising;
    this.mostIdle = mostIdle;
    places = new Semaphore(most, true);
  }

  /**
   * Asks a process, if possible the one that was asked about the same topic last.
   *
   * @param topic what the request is about
   * @param seconds longest time of the answer, s
   * @throws LostProcessException if the process ended without an answer
   * @throws IOException if no process can be started
   * @throws CancellationException if the thread is interrupted, which it stays, or the processes
   *     are closed
   */
  public <T> T ask(WorkerBounds bounds, Object topic, long seconds, Dialogue<T> dialogue)
      throws IOException {
    try {
      places.acquire();
    } catch (InterruptedException e) {
      throw interrupted();
    }
    try {
      if (isClosed()) {
        throw ended();
      }
      Optional<Warm> waiting = waiting(bounds, topic);
      if (waiting.isPresent()) {
        try {
          return answer(waiting.get(), topic, seconds, dialogue);
        } catch (LostProcessException e) {
          if (e.why() != LostProcessException.Cause.OTHER) {
            throw e;
          }
          // It may have waited long enough just now: another one is asked.
        }
      }
      return answer(start(bounds), topic, seconds, dialogue);
    } finally {
      places.release();
    }
  }

  /**
   * Starts a process ahead of its first request, in the thread that calls; none if all places are
   * taken, since their processes are left for later requests.
   *
   * @param first what it is asked at once, so that its classes are loaded; the answer is dropped
   */
  public void prepare(WorkerBounds bounds, Dialogue<?> first) throws IOException {
    if (places.tryAcquire()) {
      try {
        answer(start(bounds), "", END_SECONDS, first);
      } finally {
        places.release();
      }
    }
  }

  private synchronized Optional<Warm> waiting(WorkerBounds bounds, Object topic) {
    idle.removeIf(other -> !other.process.isAlive() || ended(other, bounds));
    for (Iterator<Warm> each = idle.iterator(); each.hasNext(); ) {
      Warm known = each.next();
      if (known.topic.equals(topic)) {
        each.remove();
        return Optional.of(known);
      }
    }
    return Optional.ofNullable(idle.pollFirst());
  }

  /** Ends a process whose bounds are those of before. */
  private static boolean ended(Warm other, WorkerBounds bounds) {
    boolean differs = !other.bounds.equals(bounds);
    if (differs) {
      other.process.destroyForcibly();
    }
    return differs;
  }

  private Warm start(WorkerBounds bounds) throws IOException {
    return new Warm(
        Confinement.ordinary(bounds, main, optimising)
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start(),
        bounds);
  }

  /** Keeps a process for requests that wait or come later, and ends what is left over. */
  private void keep(Warm done) {
    List<Warm> last = new ArrayList<>();
    synchronized (this) {
      idle.addFirst(done);
      while (closed ? !idle.isEmpty() : idle.size() > mostIdle && !places.hasQueuedThreads()) {
        last.add(idle.removeLast());
      }
    }
    last.forEach(WarmProcesses::end);
  }

  /** Ends a process and waits for it, so that its memory is free before the next one starts. */
  private static void end(Warm last) {
    last.process.destroyForcibly();
    try {
      last.process.waitFor(END_SECONDS, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // it ends without a witness
    }
  }

  /** The thread of the caller holds the dialogue, since each change of threads takes time. */
  private <T> T answer(Warm warm, Object topic, long seconds, Dialogue<T> dialogue)
      throws IOException {
    warm.topic = topic;
    Held held = new Held(warm.process, Thread.currentThread(), end(seconds));
    watch(held);
    boolean done = false;
    try {
      T answer = dialogue.hold(warm.out, warm.in);
      done = true;
      return answer;
    } catch (IOException e) {
      if (Thread.currentThread().isInterrupted()) {
        throw interrupted();
      } else if (isClosed()) {
        throw ended();
      } else if (held.late) {
        throw new LostProcessException(
            LostProcessException.Cause.TIME, "it takes more than " + seconds + " s");
      }
      throw lost(warm);
    } finally {
      synchronized (this) {
        watched.remove(held);
      }
      if (done && !held.lowered) {
        keep(warm);
      } else {
        end(warm);
      }
    }
  }

  private static long end(long seconds) {
    long nanos = TimeUnit.SECONDS.toNanos(seconds);
    return nanos == Long.MAX_VALUE ? nanos : System.nanoTime() + nanos;
  }

  private synchronized void watch(Held held) {
    watched.add(held);
    if (!watching) {
      watching = true;
      Thread watch = new Thread(this::watch, "mechservice-watches-" + main.getSimpleName());
      watch.setDaemon(true);
      watch.start();
    }
  }

  /** Ends the processes of answers that take too long or are not wanted any more. */
  private void watch() {
    while (isWatched()) {
      try {
        Thread.sleep(LOOK_MILLIS);
      } catch (InterruptedException e) {
        // Nobody has this thread but the answers.
      }
    }
  }

  private synchronized boolean isWatched() {
    for (Held held : watched) {
      if (!held.lowered && LowPriority.isDue(held.since)) {
        held.lowered = true;
        LowPriority.lower(held.process.toHandle());
      }
      held.late = held.end != Long.MAX_VALUE && System.nanoTime() - held.end > 0;
      if (held.late || held.caller.isInterrupted()) {
        held.process.destroyForcibly();
      }
    }
    watching = !watched.isEmpty();
    return watching;
  }

  private synchronized boolean isClosed() {
    return closed;
  }

  private static CancellationException ended() {
    return new CancellationException("the processes have been ended");
  }

  private static CancellationException interrupted() {
    Thread.currentThread().interrupt();
    return new CancellationException("the caller was interrupted");
  }

  private static IOException lost(Warm warm) throws InterruptedIOException {
    try {
      if (warm.process.waitFor(END_SECONDS, TimeUnit.SECONDS)
          && warm.process.exitValue() == EXIT_OUT_OF_MEMORY) {
        return new LostProcessException(
            LostProcessException.Cause.MEMORY,
            "it needs more than the "
                + Math.round(warm.bounds.heapBytes() / 1e6)
                + " MB of memory that it has");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new InterruptedIOException("the caller was interrupted");
    }
    return new LostProcessException(LostProcessException.Cause.OTHER, "its process ended");
  }

  /** Ends all processes; who waits for an answer is told. */
  @Override
  public synchronized void close() {
    closed = true;
    idle.forEach(other -> other.process.destroyForcibly());
    idle.clear();
    watched.forEach(held -> held.process.destroyForcibly());
  }
}
