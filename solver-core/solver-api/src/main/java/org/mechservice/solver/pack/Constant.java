package org.mechservice.solver.pack;

import java.util.List;

/**
 * An entry of a constant pool, whole: what it refers to is part of it (JVMS §4.4).
 *
 * @param tag its kind
 * @param text bytes of a {@link #UTF8}, a character each; empty for others
 * @param bits a number's bits, the kind of a method handle, the bootstrap method of a call site
 * @param parts what it refers to
 */
record Constant(int tag, String text, long bits, List<Constant> parts) {
  static final int UTF8 = 1;
  static final int INTEGER = 3;
  static final int FLOAT = 4;
  static final int LONG = 5;
  static final int DOUBLE = 6;
  static final int CLASS = 7;
  static final int STRING = 8;
  static final int FIELD = 9;
  static final int METHOD = 10;
  static final int INTERFACE_METHOD = 11;
  static final int NAME_AND_TYPE = 12;
  static final int METHOD_HANDLE = 15;
  static final int METHOD_TYPE = 16;
  static final int CALL_SITE = 18;

  /** None where there may be one. */
  static final Constant NONE = new Constant(0, "", 0, List.of());

  private static final int LAST_FIELD_HANDLE = 4;

  /** Largest tag. */
  static final int LAST_TAG = CALL_SITE;

  Constant {
    parts = List.copyOf(parts);
  }

  /** Returns whether it takes two places in a constant pool. */
  boolean isWide() {
    return tag == LONG || tag == DOUBLE;
  }

  /** Returns whether it is a field or method of a class. */
  static boolean isMember(int tag) {
    return tag == FIELD || tag == METHOD || tag == INTERFACE_METHOD;
  }

  /** Returns how many bytes a number of a kind has. */
  static int numberSize(int tag) {
    return switch (tag) {
      case INTEGER, FLOAT -> 4;
      case LONG, DOUBLE -> 8;
      case METHOD_HANDLE -> 1;
      case CALL_SITE -> 2;
      default -> 0;
    };
  }

  /**
   * Returns the kinds of the entries that an entry of a kind refers to.
   *
   * @param bits the entry's number: a method handle's kind says what it is a handle of
   */
  static List<Integer> partsOf(int tag, long bits) {
    return switch (tag) {
      case CLASS, STRING, METHOD_TYPE -> List.of(UTF8);
      case NAME_AND_TYPE -> List.of(UTF8, UTF8);
      case METHOD_HANDLE -> List.of(bits <= LAST_FIELD_HANDLE ? FIELD : METHOD);
      case CALL_SITE -> List.of(NAME_AND_TYPE);
      default -> List.of();
    };
  }
}
