package org.mechservice.solver.ode;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;

/**
 * Carries a state bit by bit to bytes or back from them. One description of a state serves both
 * ways: every method returns what it was given when it writes, and what was written then when it
 * reads.
 *
 * <pre>{@code
 * void transfer(SavedState state) {
 *   order = state.integer(order);
 *   error = state.number(error);
 * }
 * }</pre>
 */
public abstract sealed class SavedState {
  private static final int MAGIC = 0x4d535354;
  private static final int FORMAT = 5;
  private static final int CHECKSUM_BYTES = Long.BYTES;

  /** A part of a state. */
  @FunctionalInterface
  public interface Part {
    /** Carries the part over. */
    void transfer(SavedState state);
  }

  private SavedState() {}

  /** Returns the bytes of a state. */
  public static byte[] save(Part part) {
    Saving saving = new Saving();
    saving.require("kind of file", MAGIC);
    saving.require("format of the saved state", FORMAT);
    part.transfer(saving);
    return saving.bytes();
  }

  /**
   * Takes up a state from its bytes.
   *
   * @throws IllegalArgumentException if they are damaged, of another format, or refused by the part
   */
  public static void restore(byte[] bytes, Part part) {
    int length = bytes.length - CHECKSUM_BYTES;
    if (length < 0 || checksum(bytes, length) != longAt(bytes, length)) {
      throw new IllegalArgumentException("the saved state is damaged or incomplete");
    }
    Restoring restoring = new Restoring(bytes, length);
    restoring.require("kind of file", MAGIC);
    restoring.require("format of the saved state", FORMAT);
    part.transfer(restoring);
    if (restoring.left() != 0) {
      throw new IllegalArgumentException("the saved state is longer than it should be");
    }
  }

  private static long checksum(byte[] bytes, int length) {
    CRC32 sum = new CRC32();
    sum.update(bytes, 0, length);
    return sum.getValue();
  }

  private static long longAt(byte[] bytes, int offset) {
    long value = 0;
    for (int i = 0; i < Long.BYTES; i++) {
      value = (value << Byte.SIZE) | (bytes[offset + i] & 0xff);
    }
    return value;
  }

  /** Carries a floating-point number over. */
  public abstract double number(double value);

  /** Carries an integer over. */
  public abstract long integer(long value);

  /** Carries an integer over. */
  public final int integer(int value) {
    return (int) integer((long) value);
  }

  /** Carries a truth value over. */
  public final boolean flag(boolean value) {
    return integer(value ? 1L : 0L) != 0;
  }

  /** Carries a text over. */
  public abstract String text(String value);

  /** Carries a sequence of bytes over. */
  public abstract byte[] bytes(byte[] value);

  /** Carries the elements of an array over, which keeps its length. */
  public final void numbers(double[] values) {
    for (int i = 0; i < values.length; i++) {
      values[i] = number(values[i]);
    }
  }

  /** Carries the rows of a matrix over, which keep their lengths. */
  public final void numbers(double[][] rows) {
    for (double[] row : rows) {
      numbers(row);
    }
  }

  /**
   * Carries over what must be the same when the state is taken up.
   *
   * @throws IllegalArgumentException naming it with both values if it is not
   */
  public final void require(String what, Object value) {
    String saved = text(value.toString());
    if (!saved.equals(value.toString())) {
      throw new IllegalArgumentException(
          "the " + what + " is " + value + ", but that of the saved state is " + saved);
    }
  }

  /** Returns whether a state is being taken up. */
  public abstract boolean restoring();

  private static final class Saving extends SavedState {
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final DataOutputStream out = new DataOutputStream(bytes);

    @Override
    public double number(double value) {
      integer(Double.doubleToRawLongBits(value));
      return value;
    }

    @Override
    public long integer(long value) {
      try {
        out.writeLong(value);
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
      return value;
    }

    @Override
    public String text(String value) {
      bytes(value.getBytes(StandardCharsets.UTF_8));
      return value;
    }

    @Override
    public byte[] bytes(byte[] value) {
      integer(value.length);
      bytes.writeBytes(value);
      return value;
    }

    @Override
    public boolean restoring() {
      return false;
    }

    byte[] bytes() {
      byte[] content = bytes.toByteArray();
      integer(checksum(content, content.length));
      return bytes.toByteArray();
    }
  }

  private static final class Restoring extends SavedState {
    private final ByteBuffer content;

    Restoring(byte[] bytes, int length) {
      content = ByteBuffer.wrap(bytes, 0, length);
    }

    @Override
    public double number(double value) {
      return Double.longBitsToDouble(integer(0L));
    }

    @Override
    public long integer(long value) {
      requireLeft(Long.BYTES);
      return content.getLong();
    }

    @Override
    public String text(String value) {
      return new String(bytes(new byte[0]), StandardCharsets.UTF_8);
    }

    @Override
    public byte[] bytes(byte[] value) {
      long length = integer(0L);
      requireLeft(length);
      byte[] read = new byte[(int) length];
      content.get(read);
      return read;
    }

    private void requireLeft(long length) {
      if (length < 0 || length > left()) {
        throw new IllegalArgumentException("the saved state is shorter than it should be");
      }
    }

    @Override
    public boolean restoring() {
      return true;
    }

    int left() {
      return content.remaining();
    }
  }
}
