package org.mechservice.solver.pack;

/**
 * What a symbol means: symbols of one band are predicted from each other. Numbers of two bytes take
 * the next band too.
 */
final class BandNumbers {
  static final int CLASS_COUNT = 0;
  static final int VERSION = 1;
  static final int ACCESS = 2;
  static final int FIELD_ACCESS = 4;
  static final int METHOD_ACCESS = 6;
  static final int COUNTS = 8;
  static final int ATTRIBUTE_COUNT = 9;
  static final int STACK = 10;
  static final int LOCALS = 11;
  static final int HANDLER_COUNT = 13;
  static final int HANDLER_RANGE = 14;
  static final int OPCODE = 15;
  static final int BYTE_CONSTANT = 16;
  static final int SHORT_CONSTANT = 17;
  static final int VARIABLE = 19;
  static final int INCREMENT = 20;
  static final int BRANCH = 21;
  static final int SWITCH = 22;
  static final int ARRAY_TYPE = 23;
  static final int ARGUMENT_SLOTS = 24;
  static final int FRAME_COUNT = 25;
  static final int FRAME_KIND = 26;
  static final int FRAME_OFFSET = 27;
  static final int FRAME_TYPES = 28;
  static final int FRAME_TYPE = 29;
  static final int FRAME_NEW = 30;
  static final int INNER_ACCESS = 31;
  static final int LOADABLE_KIND = 33;
  static final int LIST_LENGTH = 34;

  /** References that are not operands of instructions: three bands each. */
  static final int THIS = 40;

  static final int SUPER = 43;
  static final int INTERFACE = 46;
  static final int OWN_FIELD = 49;
  static final int OWN_METHOD = 50;
  static final int ATTRIBUTE = 61;
  static final int HANDLER_TYPE = 64;
  static final int FRAME_CLASS = 67;
  static final int LISTED_CLASS = 70;
  static final int INNER_CLASS = 73;
  static final int OUTER_CLASS = 76;
  static final int INNER_NAME = 79;
  static final int COMPONENT_NAME = 82;
  static final int COMPONENT_TYPE = 85;
  static final int BOOTSTRAP = 88;
  static final int ENCLOSING = 91;

  static final int MEMBER_KIND = 94;
  static final int TEXT = 95;
  static final int CODE_END = 96;
  static final int TYPE_CLASS = 97;

  /** Values of fields and arguments of bootstrap methods: three bands for every kind. */
  static final int VALUE = 100;

  static final int ARGUMENT = 160;

  /** New constants: six bands for every kind. */
  static final int TABLE = 220;

  /** Operands of instructions: three bands for every opcode that has a constant. */
  static final int OPERAND = 340;

  /** Loaded constants: three bands for every kind. */
  static final int LOADED = 960;

  /** All. */
  static final int COUNT = 1024;

  private BandNumbers() {}
}
