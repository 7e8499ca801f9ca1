package org.mechservice.client.run;

import java.io.IOException;
import java.util.Optional;

/** Stores checkpoints of a run on the client's machine, and returns the one to resume from. */
public interface CheckpointStore {
  /** Stores nothing; the run begins at its start. */
  CheckpointStore NONE =
      new CheckpointStore() {
        @Override
        public double secondsBetween() {
          return Double.POSITIVE_INFINITY;
        }

        @Override
        public Optional<byte[]> saved() {
          return Optional.empty();
        }

        @Override
        public void keep(byte[] checkpoint) {}
      };

  /** Returns the wall-clock time between two checkpoints, s; infinite for none. */
  double secondsBetween();

  /** Returns the checkpoint to resume from; empty if the run begins at its start. */
  Optional<byte[]> saved();

  /**
   * Stores a checkpoint in place of the previous one. All rows before it have been passed to the
   * sink.
   *
   * @throws IOException if it cannot be stored
   */
  void keep(byte[] checkpoint) throws IOException;
}
