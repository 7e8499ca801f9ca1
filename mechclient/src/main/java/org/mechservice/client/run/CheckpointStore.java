package org.mechservice.client.run;

import java.io.IOException;
import java.util.Optional;

/** Keeps checkpoints of a run on this side, and gives back the one to go on from. */
public interface CheckpointStore {
  /** Keeps nothing and begins at the start. */
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

  /** Returns the wall-clock time between two checkpoints, s; infinite: none are wanted. */
  double secondsBetween();

  /** Returns the checkpoint to go on from; empty: the run begins at the start. */
  Optional<byte[]> saved();

  /**
   * Keeps a checkpoint in place of the one before. All rows before it were handed to the sink.
   *
   * @throws IOException if it cannot be kept
   */
  void keep(byte[] checkpoint) throws IOException;
}
