package org.mechservice.solver.api.run;

import java.io.IOException;
import java.util.Optional;

/**
 * Keeps what a run needs to be taken up again with the same bits, and gives back what another run
 * left.
 */
public interface Checkpoints {
  /** Keeps nothing and begins at the start. */
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

  /** Returns what identifies the model to the bit, such as the SHA-256 of its JAR. */
  String modelHash();

  /**
   * Returns the wall-clock time between two checkpoints, s; 0: after every step; infinite: none.
   */
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
