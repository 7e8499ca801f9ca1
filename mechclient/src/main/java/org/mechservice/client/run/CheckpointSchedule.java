package org.mechservice.client.run;

import java.io.IOException;
import java.util.Optional;

/** Schedule of the checkpoints of a run. */
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

  /** Stores a checkpoint if there is one, and schedules the next. */
  void keep(Optional<byte[]> checkpoint) throws IOException {
    if (checkpoint.isPresent()) {
      store.keep(checkpoint.get());
    }
    lastAt = System.nanoTime();
  }
}
