package org.mechservice.client.run;

import java.io.IOException;
import java.util.Optional;

/** Tells when the next checkpoint of a run is due. */
final class CheckpointSchedule {
  private static final double NANOSECONDS = 1e9;

  private final CheckpointStore store;
  private long lastAt = System.nanoTime();

  CheckpointSchedule(CheckpointStore store) {
    this.store = store;
  }

  boolean isWanted() {
    return Double.isFinite(store.secondsBetween());
  }

  boolean isDue() {
    return isWanted() && System.nanoTime() - lastAt >= store.secondsBetween() * NANOSECONDS;
  }

  /** Keeps a checkpoint if there is one; without one the next is due as late. */
  void keep(Optional<byte[]> checkpoint) throws IOException {
    if (checkpoint.isPresent()) {
      store.keep(checkpoint.get());
    }
    lastAt = System.nanoTime();
  }
}
