package org.mechservice.solver.pack;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** The constant pool of one class file (JVMS §4.4). */
final class ConstantPool {
  /** Magic number, minor and major version stand before the pool. */
  static final int START = 8;

  private final ByteBuffer file;
  private final int[] offsets;
  private final Constant[] constants;
  private final int end;

  private ConstantPool(byte[] bytes) {
    file = ByteBuffer.wrap(bytes);
    int count = file.getShort(START) & 0xffff;
    offsets = new int[count];
    constants = new Constant[count];
    int at = START + 2;
    for (int i = 1; i < count; i++) {
      int tag = file.get(at);
      offsets[i] = at;
      at += 1 + sizeAt(tag, at + 1);
      if (tag == Constant.LONG || tag == Constant.DOUBLE) {
        i++;
      }
    }
    end = at;
  }

  static ConstantPool of(byte[] classFile) {
    return new ConstantPool(classFile);
  }

  private int sizeAt(int tag, int at) {
    return switch (tag) {
      case Constant.UTF8 -> 2 + unsigned(at);
      case Constant.CLASS, Constant.STRING, Constant.METHOD_TYPE -> 2;
      case Constant.METHOD_HANDLE -> 3;
      case Constant.LONG, Constant.DOUBLE -> 8;
      case Constant.INTEGER,
          Constant.FLOAT,
          Constant.NAME_AND_TYPE,
          Constant.FIELD,
          Constant.METHOD,
          Constant.INTERFACE_METHOD,
          Constant.CALL_SITE ->
          4;
      default -> throw new IllegalArgumentException("a class has a constant of kind " + tag);
    };
  }

  private int unsigned(int at) {
    return file.getShort(at) & 0xffff;
  }

  /** Returns where the pool ends in the file. */
  int end() {
    return end;
  }

  /** Returns a constant. */
  Constant at(int index) {
    Constant known = constants[index];
    if (known == null) {
      known = read(file.get(offsets[index]), offsets[index] + 1);
      constants[index] = known;
    }
    return known;
  }

  private Constant read(int tag, int at) {
    return switch (tag) {
      case Constant.UTF8 -> {
        byte[] text = new byte[unsigned(at)];
        file.get(at + 2, text);
        yield new Constant(tag, new String(text, StandardCharsets.ISO_8859_1), 0, List.of());
      }
      case Constant.INTEGER, Constant.FLOAT ->
          new Constant(tag, "", Integer.toUnsignedLong(file.getInt(at)), List.of());
      case Constant.LONG, Constant.DOUBLE -> new Constant(tag, "", file.getLong(at), List.of());
      case Constant.CLASS, Constant.STRING, Constant.METHOD_TYPE ->
          new Constant(tag, "", 0, List.of(at(unsigned(at))));
      case Constant.METHOD_HANDLE ->
          new Constant(tag, "", file.get(at), List.of(at(unsigned(at + 1))));
      case Constant.CALL_SITE -> new Constant(tag, "", unsigned(at), List.of(at(unsigned(at + 2))));
      default -> new Constant(tag, "", 0, List.of(at(unsigned(at)), at(unsigned(at + 2))));
    };
  }
}
