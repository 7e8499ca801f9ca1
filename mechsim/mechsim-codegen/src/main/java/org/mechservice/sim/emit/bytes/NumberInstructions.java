package org.mechservice.sim.emit.bytes;

import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** Pushes numbers by the shortest possible instruction. */
public final class NumberInstructions {
  private final MethodVisitor code;

  public NumberInstructions(MethodVisitor code) {
    this.code = code;
  }

  public void push(int value) {
    if (value >= -1 && value <= 5) {
      code.visitInsn(Opcodes.ICONST_0 + value);
    } else if (value >= Byte.MIN_VALUE && value <= Byte.MAX_VALUE) {
      code.visitIntInsn(Opcodes.BIPUSH, value);
    } else if (value >= Short.MIN_VALUE && value <= Short.MAX_VALUE) {
      code.visitIntInsn(Opcodes.SIPUSH, value);
    } else {
      code.visitLdcInsn(value);
    }
  }

  /**
   * Pushes a number; a negative one as its magnitude, which is more often a constant already, and a
   * negation.
   */
  public void push(double value) {
    if (value < 0) {
      push(-value);
      code.visitInsn(Opcodes.DNEG);
    } else if (Double.doubleToRawLongBits(value) == 0) {
      code.visitInsn(Opcodes.DCONST_0);
    } else if (value == 1) {
      code.visitInsn(Opcodes.DCONST_1);
    } else {
      code.visitLdcInsn(value);
    }
  }
}
