package org.mechservice.result;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Reads structures in the compact protocol of Apache Thrift, the reverse of {@link ThriftWriter}. A
 * structure becomes a map of field numbers and values: {@link Long} for integers and truth values,
 * {@link Double}, {@link String}, {@link List}, or again a map.
 */
final class ThriftReader {
  private static final int DEEPEST = 16;

  private final ByteBuffer bytes;

  /**
   * @param bytes read from its position on, which is moved
   */
  ThriftReader(ByteBuffer bytes) {
    this.bytes = bytes;
    bytes.order(ByteOrder.LITTLE_ENDIAN);
  }

  Map<Integer, Object> struct() throws IOException {
    return struct(0);
  }

  private Map<Integer, Object> struct(int depth) throws IOException {
    if (depth > DEEPEST) {
      throw new IOException("its structures are nested too deeply");
    }
    Map<Integer, Object> fields = new LinkedHashMap<>();
    int field = 0;
    for (int head = bytes.get() & 0xFF; head != 0; head = bytes.get() & 0xFF) {
      int delta = head >> 4;
      field = delta == 0 ? (int) integer() : field + delta;
      int type = head & 15;
      fields.put(field, type <= 2 ? Long.valueOf(2 - type) : value(type, depth));
    }
    return fields;
  }

  private Object value(int type, int depth) throws IOException {
    return switch (type) {
      case 1, 2, 3 -> (long) bytes.get();
      case 4, ThriftWriter.I32, ThriftWriter.I64 -> integer();
      case 7 -> bytes.getDouble();
      case ThriftWriter.BINARY -> text();
      case ThriftWriter.LIST, 10 -> list(depth);
      case ThriftWriter.STRUCT -> struct(depth + 1);
      default -> throw new IOException("its footer has a value of unknown type " + type);
    };
  }

  private List<Object> list(int depth) throws IOException {
    if (depth > DEEPEST) {
      throw new IOException("its lists are nested too deeply");
    }
    int head = bytes.get() & 0xFF;
    long size = head >> 4 == 15 ? varint() : head >> 4;
    List<Object> elements = new ArrayList<>();
    for (long i = 0; i < size; i++) {
      elements.add(value(head & 15, depth + 1));
    }
    return elements;
  }

  private String text() throws IOException {
    long length = varint();
    if (length < 0 || length > bytes.remaining()) {
      throw new IOException("its footer is damaged");
    }
    byte[] utf8 = new byte[(int) length];
    bytes.get(utf8);
    return new String(utf8, StandardCharsets.UTF_8);
  }

  private long integer() {
    long value = varint();
    return (value >>> 1) ^ -(value & 1);
  }

  private long varint() {
    long value = 0;
    int shift = 0;
    for (byte next = bytes.get(); ; next = bytes.get()) {
      value |= (long) (next & 0x7F) << shift;
      shift += 7;
      if (next >= 0) {
        return value;
      }
    }
  }
}
