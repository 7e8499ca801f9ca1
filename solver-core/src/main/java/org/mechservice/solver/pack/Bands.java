package org.mechservice.solver.pack;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.zip.DataFormatException;
import java.util.zip.Deflater;
import java.util.zip.Inflater;

/**
 * Streams of bytes, each of one meaning: written one after the other in any order, deflated each by
 * itself, read back in the order in which they were written.
 */
final class Bands {
  /** Bands by number; a number of two bytes has two of them. */
  private static final int COUNT = 1024;

  private static final int MORE = 0x80;
  private static final int SEVEN_BITS = 0x7f;
  private static final int BYTE = 0xff;

  /** No solver is larger: what claims to be is damaged. */
  private static final int LARGEST = 1 << 26;

  private final byte[][] bytes = new byte[COUNT][0];
  private final int[] end = new int[COUNT];
  private final int[] next = new int[COUNT];

  void put(int band, int value) {
    if (end[band] == bytes[band].length) {
      bytes[band] = Arrays.copyOf(bytes[band], 2 * end[band] + 64);
    }
    bytes[band][end[band]++] = (byte) value;
  }

  int get(int band) throws IOException {
    if (next[band] >= end[band]) {
      throw new IOException("the packed classes end too early (band " + band + ")");
    }
    return bytes[band][next[band]++] & BYTE;
  }

  /** Writes a number of two bytes, high and low byte in a band each. */
  void putPair(int band, int value) {
    put(band, value >> Byte.SIZE);
    put(band + 1, value);
  }

  int getPair(int band) throws IOException {
    return (get(band) << Byte.SIZE) | get(band + 1);
  }

  /** Writes a number that is small as a rule, seven bits a byte. */
  void putSmall(int band, int value) {
    int rest = value;
    while ((rest & ~SEVEN_BITS) != 0) {
      put(band, (rest & SEVEN_BITS) | MORE);
      rest >>>= 7;
    }
    put(band, rest);
  }

  int getSmall(int band) throws IOException {
    int value = 0;
    for (int shift = 0; shift < Integer.SIZE; shift += 7) {
      int next7 = get(band);
      value |= (next7 & SEVEN_BITS) << shift;
      if ((next7 & MORE) == 0) {
        return value;
      }
    }
    throw new IOException("the packed classes are damaged (band " + band + ")");
  }

  /** Writes a number of either sign that is near zero as a rule. */
  void putSigned(int band, int value) {
    putSmall(band, (value << 1) ^ (value >> (Integer.SIZE - 1)));
  }

  int getSigned(int band) throws IOException {
    int folded = getSmall(band);
    return (folded >>> 1) ^ -(folded & 1);
  }

  /** Returns all bands: for each its number, its length, its deflated length, its bytes. */
  byte[] deflated() {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    for (int band = 0; band < COUNT; band++) {
      if (end[band] > 0) {
        byte[] small = deflated(band);
        writeSmall(out, band);
        writeSmall(out, end[band]);
        writeSmall(out, small.length);
        out.writeBytes(small);
      }
    }
    return out.toByteArray();
  }

  /** Returns a band deflated, or as it is if that takes no more room. */
  private byte[] deflated(int band) {
    Deflater deflater = new Deflater(Deflater.BEST_COMPRESSION, true);
    try {
      deflater.setInput(bytes[band], 0, end[band]);
      deflater.finish();
      byte[] out = new byte[end[band]];
      int length = deflater.deflate(out);
      return deflater.finished() && length < end[band]
          ? Arrays.copyOf(out, length)
          : Arrays.copyOf(bytes[band], end[band]);
    } finally {
      deflater.end();
    }
  }

  private static void writeSmall(ByteArrayOutputStream out, int value) {
    int rest = value;
    while (rest > SEVEN_BITS) {
      out.write((rest & SEVEN_BITS) | MORE);
      rest >>>= 7;
    }
    out.write(rest);
  }

  /**
   * Reads what {@link #deflated} wrote.
   *
   * @throws IOException if it is damaged
   */
  static Bands inflated(byte[] packed) throws IOException {
    Bands directory = new Bands();
    directory.bytes[0] = packed;
    directory.end[0] = packed.length;
    Bands bands = new Bands();
    while (directory.next[0] < packed.length) {
      int band = directory.getSmall(0);
      int length = directory.getSmall(0);
      int small = directory.getSmall(0);
      int at = directory.next[0];
      boolean possible = band < COUNT && length > 0 && length < LARGEST && small >= 0;
      if (!possible || small > packed.length - at) {
        throw new IOException("the packed classes are damaged");
      }
      bands.bytes[band] = inflated(packed, at, small, length);
      bands.end[band] = length;
      directory.next[0] = at + small;
    }
    return bands;
  }

  private static byte[] inflated(byte[] packed, int at, int small, int length) throws IOException {
    if (small == length) {
      return Arrays.copyOfRange(packed, at, at + small);
    }
    Inflater inflater = new Inflater(true);
    try {
      inflater.setInput(packed, at, small);
      byte[] out = new byte[length];
      if (inflater.inflate(out) != length) {
        throw new IOException("the packed classes are damaged");
      }
      return out;
    } catch (DataFormatException e) {
      throw new IOException("the packed classes are damaged", e);
    } finally {
      inflater.end();
    }
  }
}
