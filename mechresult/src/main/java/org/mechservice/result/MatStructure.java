package org.mechservice.result;

import java.io.BufferedInputStream;
import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.InflaterInputStream;
import java.util.zip.ZipException;

/**
 * Makes sure that a MAT file has what its tags claim, before a reader reserves memory for it: each
 * element lies within the one around it, and no array has more elements than bytes (MathWorks,
 * MAT-File Format, 2021, chapter 1).
 */
final class MatStructure {
  private static final int HEADER = 128;
  private static final int TAG = 8;
  private static final int INT32 = 5;
  private static final int MATRIX = 14;
  private static final int COMPRESSED = 15;

  /** Cells in cells. */
  private static final int DEEPEST = 16;

  /** A compressed part does not tell its size. */
  private static final long UNKNOWN = Long.MAX_VALUE;

  private final InputStream in;
  private final ByteOrder order;

  private MatStructure(InputStream in, ByteOrder order) {
    this.in = in;
    this.order = order;
  }

  /**
   * @throws IOException if it is damaged; says how
   */
  static void require(Path file) throws IOException {
    try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
      byte[] header = in.readNBytes(HEADER);
      boolean little = header.length == HEADER && header[126] == 'I' && header[127] == 'M';
      boolean big = header.length == HEADER && header[126] == 'M' && header[127] == 'I';
      if (!little && !big) {
        throw new IOException("it has no header of a MAT file of level 5");
      }
      ByteOrder order = little ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
      new MatStructure(in, order).elements(Files.size(file) - HEADER, 0);
    } catch (ZipException e) {
      throw new IOException("a compressed part of it is damaged", e);
    }
  }

  /** Passes over elements that fill some bytes. */
  private void elements(long size, int depth) throws IOException {
    if (depth > DEEPEST) {
      throw new IOException("its cells are more than " + DEEPEST + " deep in each other");
    }
    long left = size;
    for (int index = 0; left >= TAG; index++) {
      byte[] bytes = in.readNBytes(TAG);
      if (size == UNKNOWN && bytes.length == 0) {
        return;
      }
      ByteBuffer tag = tag(bytes);
      left -= TAG;
      int type = tag.getInt(0);
      if (type >>> 16 != 0) {
        requireWithin(type >>> 16, 4);
        continue; // its bytes are in the tag
      }
      long length = Integer.toUnsignedLong(tag.getInt(4));
      requireWithin(length, left);
      boolean dimensions = depth > 0 && index == 1 && type == INT32;
      if (type == MATRIX) {
        elements(length, depth + 1);
      } else if (type == COMPRESSED) {
        compressed(length);
      } else if (dimensions) {
        requireFilled(length, size);
      } else {
        in.skipNBytes(length);
      }
      long padding = type == COMPRESSED ? 0 : Math.min(-length & 7, left - length);
      in.skipNBytes(padding);
      left -= length + padding;
    }
    in.skipNBytes(size == UNKNOWN ? 0 : left);
  }

  private ByteBuffer tag(byte[] bytes) throws EOFException {
    if (bytes.length < TAG) {
      throw new EOFException("it ends too early");
    }
    return ByteBuffer.wrap(bytes).order(order);
  }

  private static void requireWithin(long length, long left) throws IOException {
    if (length > left) {
      throw new IOException(
          "a part of it claims " + length + " bytes where there are " + left + "; it is damaged");
    }
  }

  private void compressed(long length) throws IOException {
    byte[] part = in.readNBytes((int) Math.min(length, Integer.MAX_VALUE - 8));
    if (part.length < length) {
      throw new EOFException("it ends too early");
    }
    InputStream inflated =
        new BufferedInputStream(new InflaterInputStream(new ByteArrayInputStream(part)));
    new MatStructure(inflated, order).elements(UNKNOWN, 0);
  }

  /** An array holds at least a byte for each of its elements. */
  private void requireFilled(long length, long size) throws IOException {
    if (length > size || length > 4 * 64) {
      throw new IOException("an array of it has " + length / 4 + " dimensions; it is damaged");
    }
    byte[] bytes = in.readNBytes((int) length);
    if (bytes.length < length) {
      throw new EOFException("it ends too early");
    }
    ByteBuffer dimensions = ByteBuffer.wrap(bytes).order(order);
    double elements = 1;
    while (dimensions.remaining() >= 4) {
      int one = dimensions.getInt();
      elements *= one;
      if (one < 0 || elements > size) {
        throw new IOException("an array of it claims more elements than it has; it is damaged");
      }
    }
  }
}
