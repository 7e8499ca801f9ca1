package org.mechservice.orb;

import java.util.function.BooleanSupplier;
import org.jacorb.orb.dsi.ServerRequest;
import org.jacorb.poa.RPPoolManagerListener;
import org.jacorb.poa.RequestProcessor;
import org.jacorb.poa.RequestQueueListener;

/**
 * Counts the pending calls of an object adapter: those that wait in its queue and those that a
 * thread of its pool works on.
 *
 * <p>The adapter itself keeps the set of the objects that are being called, not the number of
 * calls: when the first of two calls of one object ends, the object leaves the set, and the second
 * one is forgotten. An adapter that is destroyed then has the forgotten call fail in a place where
 * its thread dies of it, and waits for that thread without end. So no adapter is destroyed before
 * this count is zero.
 */
final class PendingCalls implements RequestQueueListener, RPPoolManagerListener {
  private int waiting;
  private int working;
  private boolean moved;

  // A call leaves the queue after a thread has it, so on its way it is counted twice, never zero
  // times.

  @Override
  public synchronized void requestAddedToQueue(ServerRequest request, int queueSize) {
    waiting++;
  }

  @Override
  public synchronized void requestRemovedFromQueue(ServerRequest request, int queueSize) {
    waiting--;
    moved = true;
    notifyAll();
  }

  @Override
  public synchronized void processorRemovedFromPool(
      RequestProcessor processor, int unused, int all) {
    working++;
  }

  @Override
  public synchronized void processorAddedToPool(RequestProcessor processor, int unused, int all) {
    working--;
    notifyAll();
  }

  /**
   * Waits until the calls that a thread works on, or is about to, are finished. The adapter must
   * refuse the others; however many of them come, this ends.
   */
  synchronized void awaitWorked() {
    moved = false;
    // The one the adapter is about to hand to a thread is still in the queue then.
    await(() -> working == 0 && (waiting == 0 || moved));
  }

  /** Waits until there are none at all. No new ones must come, or this has no end. */
  synchronized void awaitNone() {
    await(() -> working == 0 && waiting == 0);
  }

  /** An interrupt does not end the wait, but is kept for the caller. */
  private void await(BooleanSupplier condition) {
    boolean interrupted = false;
    while (!condition.getAsBoolean()) {
      try {
        wait();
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
