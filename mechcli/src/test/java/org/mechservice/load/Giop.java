package org.mechservice.load;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HexFormat;

/**
 * Messages of the ORBs' protocol, byte by byte, for those who do not keep to it (OMG, CORBA 3.0,
 * sections 13.6 and 15.4).
 */
final class Giop {
  static final int HEADER_BYTES = 12;
  private static final byte[] MAGIC = {'G', 'I', 'O', 'P'};

  private Giop() {}

  /** Returns a header of version 1.2, big-endian. */
  static byte[] header(int type, int length) {
    return header(1, 2, type, length);
  }

  /** Returns a header. */
  static byte[] header(int major, int minor, int type, int length) {
    return ByteBuffer.allocate(HEADER_BYTES)
        .put(MAGIC)
        .put((byte) major)
        .put((byte) minor)
        .put((byte) 0)
        .put((byte) type)
        .putInt(length)
        .array();
  }

  /**
   * Returns a request of version 1.0.
   *
   * @param objectKey whom it is for
   * @param arguments encoded, to begin at a multiple of 4 bytes
   */
  static byte[] request(byte[] objectKey, String operation, int id, byte[] arguments) {
    Encoding body = new Encoding();
    body.number(0); // no service contexts
    body.number(id);
    body.octet(1); // an answer is expected
    body.octets(objectKey);
    body.octets((operation + '\0').getBytes(StandardCharsets.US_ASCII));
    body.octets(new byte[0]); // no principal
    if (arguments.length > 0) {
      body.align(4);
    }
    body.raw(arguments);
    byte[] bytes = body.bytes();
    byte[] message = Arrays.copyOf(header(1, 0, 0, bytes.length), 12 + bytes.length);
    System.arraycopy(bytes, 0, message, HEADER_BYTES, bytes.length);
    return message;
  }

  /**
   * Returns a request of version 1.2.
   *
   * @param objectKey whom it is for
   * @param arguments encoded, to begin at a multiple of 8 bytes
   */
  static byte[] requestNow(byte[] objectKey, String operation, int id, byte[] arguments) {
    Encoding body = new Encoding();
    body.number(id);
    body.raw(new byte[] {3, 0, 0, 0}); // an answer is expected
    body.number(0); // the object is named by its key, after two bytes of nothing
    body.octets(objectKey);
    body.octets((operation + '\0').getBytes(StandardCharsets.US_ASCII));
    body.number(0); // no service contexts
    if (arguments.length > 0) {
      body.align(8);
    }
    body.raw(arguments);
    byte[] bytes = body.bytes();
    byte[] message = Arrays.copyOf(header(0, bytes.length), HEADER_BYTES + bytes.length);
    System.arraycopy(bytes, 0, message, HEADER_BYTES, bytes.length);
    return message;
  }

  /** Returns numbers as arguments of a request. */
  static byte[] numbers(int... values) {
    ByteBuffer bytes = ByteBuffer.allocate(4 * values.length);
    for (int value : values) {
      bytes.putInt(value);
    }
    return bytes.array();
  }

  /** Returns a text as the first argument of a request. */
  static byte[] text(String ascii) {
    byte[] bytes = (ascii + '\0').getBytes(StandardCharsets.US_ASCII);
    return ByteBuffer.allocate(4 + (bytes.length + 3) / 4 * 4)
        .putInt(bytes.length)
        .put(bytes)
        .array();
  }

  /** Reads a whole message; returns an empty array at the end of the stream. */
  static byte[] read(InputStream stream) throws IOException {
    DataInputStream in = new DataInputStream(stream);
    byte[] header = in.readNBytes(HEADER_BYTES);
    if (header.length < HEADER_BYTES) {
      return new byte[0];
    }
    ByteOrder order = (header[6] & 1) == 0 ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
    int length = ByteBuffer.wrap(header, 8, 4).order(order).getInt();
    byte[] message = Arrays.copyOf(header, HEADER_BYTES + length);
    in.readFully(message, HEADER_BYTES, length);
    return message;
  }

  /** Returns the object key in a reference's text, {@code IOR:...}. */
  static byte[] objectKey(String ior) {
    ByteBuffer all = encapsulation(HexFormat.of().parseHex(ior.substring("IOR:".length())));
    all.position(4);
    octets(all); // type
    all.position((all.position() + 3) / 4 * 4);
    if (all.getInt() < 1 || all.getInt() != 0) {
      throw new IllegalArgumentException("no IIOP profile first");
    }
    ByteBuffer profile = encapsulation(octets(all));
    profile.get();
    profile.get();
    profile.position((profile.position() + 3) / 4 * 4);
    octets(profile); // host
    profile.position((profile.position() + 1) / 2 * 2);
    profile.getShort(); // port
    profile.position((profile.position() + 3) / 4 * 4);
    return octets(profile);
  }

  private static ByteBuffer encapsulation(byte[] bytes) {
    ByteBuffer buffer = ByteBuffer.wrap(bytes);
    buffer.order(buffer.get() == 0 ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN);
    return buffer;
  }

  private static byte[] octets(ByteBuffer from) {
    byte[] bytes = new byte[from.getInt()];
    from.get(bytes);
    return bytes;
  }

  /** Writes numbers at multiples of their size from the start of a message. */
  private static final class Encoding {
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

    void align(int size) {
      while ((HEADER_BYTES + bytes.size()) % size != 0) {
        bytes.write(0);
      }
    }

    void octet(int value) {
      bytes.write(value);
    }

    void number(int value) {
      align(4);
      bytes.writeBytes(ByteBuffer.allocate(4).putInt(value).array());
    }

    void octets(byte[] values) {
      number(values.length);
      bytes.writeBytes(values);
    }

    void raw(byte[] values) {
      bytes.writeBytes(values);
    }

    byte[] bytes() {
      return bytes.toByteArray();
    }
  }
}
