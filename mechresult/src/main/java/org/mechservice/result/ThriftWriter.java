package org.mechservice.result;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;

/**
 * Writes structures in the compact protocol of Apache Thrift, in which Parquet defines its headers
 * ("Thrift compact protocol encoding"; parquet-format, {@code parquet.thrift}). The fields of a
 * structure are written in rising order of their numbers, and {@link #end} closes it.
 */
final class ThriftWriter {
  static final int I32 = 5;
  static final int I64 = 6;
  static final int BINARY = 8;
  static final int LIST = 9;
  static final int STRUCT = 12;

  private static final int SHORT_LIST = 15;

  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
  private final Deque<Integer> outer = new ArrayDeque<>();
  private int last;

  ThriftWriter i32(int field, int value) {
    return header(field, I32).varint(zigzag(value));
  }

  ThriftWriter i64(int field, long value) {
    return header(field, I64).varint(zigzag(value));
  }

  ThriftWriter text(int field, String value) {
    return header(field, BINARY).text(value);
  }

  /** Begins a structure that is a field. */
  ThriftWriter struct(int field) {
    return header(field, STRUCT).element();
  }

  /** Begins a structure that is an element of a list. */
  ThriftWriter element() {
    outer.push(last);
    last = 0;
    return this;
  }

  /** Closes the innermost structure, or the whole. */
  ThriftWriter end() {
    bytes.write(0);
    last = outer.isEmpty() ? 0 : outer.pop();
    return this;
  }

  /** Begins a list; its elements follow. */
  ThriftWriter list(int field, int type, int size) {
    header(field, LIST);
    bytes.write((Math.min(size, SHORT_LIST) << 4) | type);
    return size < SHORT_LIST ? this : varint(size);
  }

  /** Writes an element of a list of numbers. */
  ThriftWriter i32(int value) {
    return varint(zigzag(value));
  }

  /** Writes an element of a list of texts. */
  ThriftWriter text(String value) {
    byte[] utf8 = value.getBytes(StandardCharsets.UTF_8);
    varint(utf8.length);
    bytes.writeBytes(utf8);
    return this;
  }

  private ThriftWriter header(int field, int type) {
    bytes.write(((field - last) << 4) | type);
    last = field;
    return this;
  }

  private static long zigzag(long value) {
    return (value << 1) ^ (value >> 63);
  }

  private ThriftWriter varint(long value) {
    long rest = value;
    while ((rest & ~0x7FL) != 0) {
      bytes.write((int) ((rest & 0x7F) | 0x80));
      rest >>>= 7;
    }
    bytes.write((int) rest);
    return this;
  }

  /** Returns what was written since the last call. */
  byte[] take() {
    byte[] taken = bytes.toByteArray();
    bytes.reset();
    return taken;
  }
}
