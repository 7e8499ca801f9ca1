package org.mechservice.solver.linear;

import java.util.concurrent.CancellationException;

/**
 * Stops long computations at an interrupt of their thread; they check for it between their parts.
 * The set-up of a large mechanism takes minutes.
 */
public final class Interruption {
  private Interruption() {}

  /**
   * Returns if the computation shall go on.
   *
   * @throws CancellationException if the thread is interrupted, which it stays
   */
  public static void check() {
    if (Thread.currentThread().isInterrupted()) {
      throw new CancellationException("the computation was cancelled");
    }
  }
}
