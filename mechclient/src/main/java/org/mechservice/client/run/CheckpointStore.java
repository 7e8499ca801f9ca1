package org.mechservice.client.run;

import java.io.IOException;
import java.util.Optional;
import org.mechservice.solver.api.run.Checkpoints;

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

  /** Returns a store that keeps what a run in process would keep. */
  static CheckpointStore of(Checkpoints checkpoints) {
    return new CheckpointStore() {
      @Override
      public double secondsBetween() {
        return checkpoints.secondsBetween();
      }

      @Override
      public Optional<byte[]> saved() {
        return checkpoints.saved();
      }

      @Override
      public void keep(byte[] checkpoint) throws IOException {
        checkpoints.keep(checkpoint);
      }
    };
  }

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
