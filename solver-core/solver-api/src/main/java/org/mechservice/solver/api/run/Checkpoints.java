package org.mechservice.solver.api.run;

import java.io.IOException;
import java.util.Optional;

/**
 * Stores checkpoints, from which a run can be resumed with the same bits, and returns the
 * checkpoint of an earlier run.
 */
public interface Checkpoints {
  /** Stores nothing; the run begins at its start. */
  Checkpoints NONE =
      new Checkpoints() {
        @Override
        public String modelHash() {
          return "";
        }

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

  /** Returns an exact identification of the model, such as the SHA-256 of its JAR. */
  String modelHash();

  /**
   * Returns the wall-clock time between two checkpoints, s; 0: after every step; infinite: none.
   */
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
