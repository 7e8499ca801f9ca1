package org.mechservice.solver.ode.solve;

/**
 * An integration between two steps as bytes, to be taken up by {@link Ode#resume} or {@link
 * Dae#resume} with the same bits: in another process, too. Immutable.
 */
public final class OdeCheckpoint {
  private final byte[] bytes;

  private OdeCheckpoint(byte[] bytes) {
    this.bytes = bytes;
  }

  /** Returns the checkpoint with the given bytes; they are checked when it is taken up. */
  public static OdeCheckpoint of(byte[] bytes) {
    return new OdeCheckpoint(bytes.clone());
  }

  /** Returns the bytes, with a checksum. */
  public byte[] bytes() {
    return bytes.clone();
  }
}
