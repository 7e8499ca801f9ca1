package org.mechservice.solver.pack;

import java.io.IOException;

/** Walks through a class file behind its constant pool (JVMS §4.1, §4.5 to §4.7). */
final class ClassWalk {
  private static final int INTERFACE = 0x200;
  private static final int SAME = 64;
  private static final int SAME_WITH_STACK = 128;
  private static final int SAME_WITH_STACK_FAR = 247;
  private static final int SAME_FAR = 251;
  private static final int FULL = 255;
  private static final int OBJECT_TYPE = 7;
  private static final int NEW_TYPE = 8;

  private final Transfer transfer;
  private final Surroundings surroundings;
  private final CodeWalk code;

  ClassWalk(Transfer transfer, Surroundings surroundings) {
    this.transfer = transfer;
    this.surroundings = surroundings;
    this.code = new CodeWalk(transfer);
  }

  /**
   * Walks from the access flags to the end.
   *
   * @throws IOException if the packed classes are damaged
   * @throws IllegalArgumentException if the class has an attribute that is not known here
   */
  void walk() throws IOException {
    surroundings.nextClass();
    boolean isInterface = (transfer.pair(BandNumbers.ACCESS) & INTERFACE) != 0;
    transfer.reference(BandNumbers.THIS, Constant.CLASS);
    transfer.reference(BandNumbers.SUPER, Constant.CLASS);
    int interfaces = transfer.small(BandNumbers.COUNTS);
    for (int i = 0; i < interfaces; i++) {
      transfer.reference(BandNumbers.INTERFACE, Constant.CLASS);
    }
    members(BandNumbers.FIELD_ACCESS, BandNumbers.OWN_FIELD, Constant.FIELD);
    members(
        BandNumbers.METHOD_ACCESS,
        BandNumbers.OWN_METHOD,
        isInterface ? Constant.INTERFACE_METHOD : Constant.METHOD);
    attributes();
  }

  private void members(int access, int band, int tag) throws IOException {
    int count = transfer.small(BandNumbers.COUNTS);
    for (int i = 0; i < count; i++) {
      surroundings.nextMethod();
      transfer.pair(access);
      transfer.member(band, tag);
      attributes();
    }
  }

  private void attributes() throws IOException {
    int count = transfer.small(BandNumbers.ATTRIBUTE_COUNT);
    for (int i = 0; i < count; i++) {
      String name = transfer.reference(BandNumbers.ATTRIBUTE, Constant.UTF8);
      int begin = transfer.beginLength();
      attribute(name);
      transfer.endLength(begin);
    }
  }

  private void attribute(String name) throws IOException {
    switch (name) {
      case "Code" -> codeAttribute();
      case "StackMapTable" -> frames();
      case "ConstantValue" -> transfer.loadable(BandNumbers.VALUE, 2);
      case "Exceptions", "NestMembers", "PermittedSubclasses" -> classes();
      case "NestHost" -> transfer.reference(BandNumbers.LISTED_CLASS, Constant.CLASS);
      case "InnerClasses" -> innerClasses();
      case "EnclosingMethod" -> {
        transfer.reference(BandNumbers.LISTED_CLASS, Constant.CLASS);
        transfer.reference(BandNumbers.ENCLOSING, Constant.NAME_AND_TYPE);
      }
      case "Record" -> components();
      case "BootstrapMethods" -> bootstrapMethods();
      case "Synthetic", "Deprecated" -> {
        // has no content
      }
      default ->
          throw new IllegalArgumentException("a class to be packed has the attribute " + name);
    }
  }

  private void codeAttribute() throws IOException {
    transfer.small(BandNumbers.STACK);
    transfer.small(BandNumbers.LOCALS);
    code.walk();
    int handlers = transfer.small(BandNumbers.HANDLER_COUNT);
    for (int i = 0; i < handlers; i++) {
      transfer.small(BandNumbers.HANDLER_RANGE);
      transfer.small(BandNumbers.HANDLER_RANGE);
      transfer.small(BandNumbers.HANDLER_RANGE);
      transfer.reference(BandNumbers.HANDLER_TYPE, Constant.CLASS);
    }
    attributes();
  }

  private void frames() throws IOException {
    int count = transfer.small(BandNumbers.FRAME_COUNT);
    int place = -1;
    for (int i = 0; i < count; i++) {
      int offset = Math.max(0, code.targetAfter(place) - place - 1);
      surroundings.expect(offset + 1);
      int kind = transfer.byteOf(BandNumbers.FRAME_KIND);
      if (kind >= SAME_WITH_STACK) {
        surroundings.expect(offset + 1);
        offset = transfer.small(BandNumbers.FRAME_OFFSET);
      } else {
        offset = kind % SAME;
      }
      place += offset + 1;
      if ((kind >= SAME && kind < SAME_WITH_STACK) || kind == SAME_WITH_STACK_FAR) {
        types(1);
      } else if (kind == FULL) {
        types(transfer.small(BandNumbers.FRAME_TYPES));
        types(transfer.small(BandNumbers.FRAME_TYPES));
      } else if (kind > SAME_FAR) {
        types(kind - SAME_FAR);
      }
    }
  }

  private void types(int count) throws IOException {
    for (int i = 0; i < count; i++) {
      int type = transfer.byteOf(BandNumbers.FRAME_TYPE);
      if (type == OBJECT_TYPE) {
        transfer.reference(BandNumbers.FRAME_CLASS, Constant.CLASS);
      } else if (type == NEW_TYPE) {
        transfer.small(BandNumbers.FRAME_NEW);
      }
    }
  }

  private void classes() throws IOException {
    int count = transfer.small(BandNumbers.LIST_LENGTH);
    for (int i = 0; i < count; i++) {
      transfer.reference(BandNumbers.LISTED_CLASS, Constant.CLASS);
    }
  }

  private void innerClasses() throws IOException {
    int count = transfer.small(BandNumbers.LIST_LENGTH);
    for (int i = 0; i < count; i++) {
      transfer.reference(BandNumbers.INNER_CLASS, Constant.CLASS);
      transfer.reference(BandNumbers.OUTER_CLASS, Constant.CLASS);
      transfer.reference(BandNumbers.INNER_NAME, Constant.UTF8);
      transfer.pair(BandNumbers.INNER_ACCESS);
    }
  }

  private void components() throws IOException {
    int count = transfer.small(BandNumbers.LIST_LENGTH);
    for (int i = 0; i < count; i++) {
      transfer.reference(BandNumbers.COMPONENT_NAME, Constant.UTF8);
      transfer.reference(BandNumbers.COMPONENT_TYPE, Constant.UTF8);
      attributes();
    }
  }

  private void bootstrapMethods() throws IOException {
    int count = transfer.small(BandNumbers.LIST_LENGTH);
    for (int i = 0; i < count; i++) {
      transfer.reference(BandNumbers.BOOTSTRAP, Constant.METHOD_HANDLE);
      int arguments = transfer.small(BandNumbers.LIST_LENGTH);
      for (int k = 0; k < arguments; k++) {
        transfer.loadable(BandNumbers.ARGUMENT, 2);
      }
    }
  }
}
