package org.mechservice.guard.worker;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.mechservice.solver.api.run.Checkpoints;

/**
 * The checkpoints that a worker starts from and makes.
 *
 * @param possible whether the worker can make checkpoints
 * @param modelHash what identifies the model to the bit
 * @param saved what to go on from; empty: the run begins at the start
 */
record CheckpointOrder(boolean possible, String modelHash, Optional<byte[]> saved) {
  static CheckpointOrder of(Checkpoints checkpoints) {
    return new CheckpointOrder(
        Double.isFinite(checkpoints.secondsBetween()),
        checkpoints.modelHash(),
        checkpoints.saved());
  }

  void write(DataOutputStream out) throws IOException {
    out.writeBoolean(possible);
    writeBytes(out, modelHash.getBytes(StandardCharsets.UTF_8));
    out.writeBoolean(saved.isPresent());
    if (saved.isPresent()) {
      writeBytes(out, saved.get());
    }
  }

  private static void writeBytes(DataOutputStream out, byte[] bytes) throws IOException {
    out.writeInt(bytes.length);
    out.write(bytes);
  }

  static CheckpointOrder read(DataInputStream in) throws IOException {
    boolean possible = in.readBoolean();
    String modelHash = new String(readBytes(in), StandardCharsets.UTF_8);
    return new CheckpointOrder(
        possible, modelHash, in.readBoolean() ? Optional.of(readBytes(in)) : Optional.empty());
  }

  private static byte[] readBytes(DataInputStream in) throws IOException {
    int length = in.readInt();
    byte[] bytes = in.readNBytes(length);
    if (bytes.length < length) {
      throw new EOFException();
    }
    return bytes;
  }
}
