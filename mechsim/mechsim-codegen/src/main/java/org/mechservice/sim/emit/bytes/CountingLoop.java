package org.mechservice.sim.emit.bytes;

import java.util.ArrayList;
import java.util.List;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** A loop {@code for (int i = first; i < end; i += step)} in byte code; the end is tested below. */
final class CountingLoop {
  private final MethodVisitor code;
  private final NumberInstructions numbers;
  private final List<Object> types;
  private final int counter;
  private final Label body = new Label();
  private final int limit;

  private CountingLoop(MethodVisitor code, List<Object> types, int counter, int limit) {
    this.code = code;
    this.numbers = new NumberInstructions(code);
    this.types = new ArrayList<>(types);
    this.types.add(Opcodes.INTEGER);
    this.counter = counter;
    this.limit = limit;
  }

  /**
   * Begins a loop that runs at least once.
   *
   * @param types types of the slots below the counter's, in the form of stack map frames; not
   *     modified
   * @param counter slot of the counter
   */
  static CountingLoop begin(
      MethodVisitor code, List<Object> types, int counter, int first, int limit) {
    CountingLoop loop = new CountingLoop(code, types, counter, limit);
    loop.numbers.push(first);
    code.visitVarInsn(Opcodes.ISTORE, counter);
    code.visitLabel(loop.body);
    code.visitFrame(Opcodes.F_NEW, loop.types.size(), loop.types.toArray(), 0, new Object[0]);
    return loop;
  }

  /** Pushes factor · i + offset. */
  void pushCounter(int factor, int offset) {
    if (factor == 0) {
      numbers.push(offset);
      return;
    }
    if (factor == 1) {
      code.visitVarInsn(Opcodes.ILOAD, counter);
    } else {
      numbers.push(factor);
      code.visitVarInsn(Opcodes.ILOAD, counter);
      code.visitInsn(Opcodes.IMUL);
    }
    if (offset != 0) {
      numbers.push(offset);
      code.visitInsn(Opcodes.IADD);
    }
  }

  /** Returns the types of the slots up to the counter's. */
  List<Object> types() {
    return types;
  }

  /** Ends the loop. */
  void end(int step) {
    code.visitIincInsn(counter, step);
    code.visitVarInsn(Opcodes.ILOAD, counter);
    numbers.push(limit);
    code.visitJumpInsn(Opcodes.IF_ICMPLT, body);
  }
}
