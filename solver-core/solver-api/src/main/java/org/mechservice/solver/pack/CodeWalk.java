package org.mechservice.solver.pack;

import java.io.IOException;
import java.util.Arrays;
import java.util.BitSet;

/** Walks through the instructions of a method (JVMS §6.5). */
final class CodeWalk {
  /**
   * What follows each opcode: b a byte constant, s a short one, v a variable, j a branch, w a wide
   * branch, l a constant that is loaded, f m i c a field, method, interface method or class, y a
   * call site, a an array type, n a count, z a zero, - nothing, ? something of its own.
   */
  private static final String[] OPERANDS = new String[256];

  private static final int BYTE_PUSH = 16;
  private static final int SHORT_PUSH = 17;
  private static final int LOAD_SHORT = 18;
  private static final int TABLE_SWITCH = 170;
  private static final int LOOKUP_SWITCH = 171;
  private static final int WIDE = 196;
  private static final int INCREMENT = 132;

  /** What the next instruction is not reached from: goto, switches, returns, throw. */
  private static final BitSet LEAVES = new BitSet();

  private static final int LONGEST = 0xffff;

  static {
    LEAVES.set(167);
    LEAVES.set(TABLE_SWITCH, 178);
    LEAVES.set(191);
    LEAVES.set(200);
    Arrays.fill(OPERANDS, "");
    OPERANDS[BYTE_PUSH] = "b";
    OPERANDS[SHORT_PUSH] = "s";
    OPERANDS[LOAD_SHORT] = "L";
    range(19, 20, "l");
    range(21, 25, "v");
    range(54, 58, "v");
    OPERANDS[INCREMENT] = "vd";
    range(153, 168, "j");
    OPERANDS[169] = "v";
    range(178, 181, "f");
    range(182, 184, "m");
    OPERANDS[185] = "inz";
    OPERANDS[186] = "yzz";
    range(187, 187, "c");
    OPERANDS[188] = "a";
    OPERANDS[189] = "c";
    range(192, 193, "c");
    OPERANDS[197] = "cn";
    range(198, 199, "j");
    range(200, 201, "w");
  }

  private final Transfer transfer;
  private final BitSet targets = new BitSet();
  private int at;
  private int furthest;

  CodeWalk(Transfer transfer) {
    this.transfer = transfer;
  }

  private static void range(int first, int last, String operands) {
    for (int opcode = first; opcode <= last; opcode++) {
      OPERANDS[opcode] = operands;
    }
  }

  /** Walks through the code of a method, which ends where none of its jumps goes on. */
  void walk() throws IOException {
    int start = transfer.beginLength();
    furthest = 0;
    targets.clear();
    int opcode;
    do {
      at = transfer.position() - start;
      opcode = transfer.byteOf(BandNumbers.OPCODE);
      switch (opcode) {
        case TABLE_SWITCH, LOOKUP_SWITCH -> switchTable(opcode, start);
        case WIDE -> wide();
        default -> {
          for (int i = 0; i < OPERANDS[opcode].length(); i++) {
            operand(opcode, OPERANDS[opcode].charAt(i));
          }
        }
      }
    } while (!LEAVES.get(opcode)
        || furthest >= transfer.position() - start
        || !transfer.codeEnds());
    transfer.endLength(start);
  }

  /** Returns where the next jump after a place goes to, -1 if none does. */
  int targetAfter(int place) {
    return targets.nextSetBit(place + 1);
  }

  private void target(int offset) throws IOException {
    int target = at + offset;
    if (target < 0 || target > LONGEST) {
      throw new IOException("a packed class jumps out of its code");
    }
    targets.set(target);
    furthest = Math.max(furthest, target);
  }

  private void operand(int opcode, char kind) throws IOException {
    int band = BandNumbers.OPERAND + 3 * opcode;
    switch (kind) {
      case 'b' -> transfer.byteOf(BandNumbers.BYTE_CONSTANT);
      case 's' -> transfer.pair(BandNumbers.SHORT_CONSTANT);
      case 'v' -> transfer.byteOf(BandNumbers.VARIABLE);
      case 'd' -> transfer.byteOf(BandNumbers.INCREMENT);
      case 'j' -> target(transfer.signed(BandNumbers.BRANCH));
      case 'w' -> target(transfer.wide(BandNumbers.SWITCH));
      case 'L' -> transfer.loadable(BandNumbers.LOADED, 1);
      case 'l' -> transfer.loadable(BandNumbers.LOADED, 2);
      case 'f' -> transfer.reference(band, Constant.FIELD);
      case 'm' -> transfer.reference(band, Constant.METHOD);
      case 'i' -> transfer.reference(band, Constant.INTERFACE_METHOD);
      case 'c' -> transfer.reference(band, Constant.CLASS);
      case 'y' -> transfer.reference(band, Constant.CALL_SITE);
      case 'a' -> transfer.byteOf(BandNumbers.ARRAY_TYPE);
      case 'n' -> transfer.byteOf(BandNumbers.ARGUMENT_SLOTS);
      default -> transfer.byteOf(BandNumbers.ARGUMENT_SLOTS);
    }
  }

  private void wide() throws IOException {
    int opcode = transfer.byteOf(BandNumbers.OPCODE);
    transfer.pair(BandNumbers.SHORT_CONSTANT);
    if (opcode == INCREMENT) {
      transfer.pair(BandNumbers.SHORT_CONSTANT);
    }
  }

  private void switchTable(int opcode, int start) throws IOException {
    transfer.align(start);
    target(transfer.wide(BandNumbers.SWITCH));
    if (opcode == TABLE_SWITCH) {
      int low = transfer.wide(BandNumbers.SWITCH);
      int high = transfer.wide(BandNumbers.SWITCH);
      for (int i = low; i <= high; i++) {
        target(transfer.wide(BandNumbers.SWITCH));
      }
      return;
    }
    int pairs = transfer.wide(BandNumbers.SWITCH);
    for (int i = 0; i < pairs; i++) {
      transfer.wide(BandNumbers.SWITCH);
      target(transfer.wide(BandNumbers.SWITCH));
    }
  }
}
