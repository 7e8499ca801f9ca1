package org.mechservice.client;

/** Measures the wall-clock time of successive pieces of work. */
final class Stopwatch {
  private static final double SECONDS = 1e-9;

  private long startedAt = System.nanoTime();

  /** Returns the time since the last call of this method, or since the start, s. */
  double lap() {
    long now = System.nanoTime();
    double seconds = (now - startedAt) * SECONDS;
    startedAt = now;
    return seconds;
  }
}
