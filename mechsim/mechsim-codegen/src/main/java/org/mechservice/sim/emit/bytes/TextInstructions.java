package org.mechservice.sim.emit.bytes;

import org.mechservice.sim.emit.method.TextPieces;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** Pushes texts of any length. */
public final class TextInstructions {
  private static final String STRING = "Ljava/lang/String;";

  private TextInstructions() {}

  /** Pushes a text; one that is longer than a constant in pieces, which are joined when it runs. */
  public static void push(MethodVisitor code, String text) {
    boolean first = true;
    for (String piece : TextPieces.of(text)) {
      code.visitLdcInsn(piece);
      if (!first) {
        code.visitMethodInsn(
            Opcodes.INVOKEVIRTUAL,
            "java/lang/String",
            "concat",
            "(" + STRING + ")" + STRING,
            false);
      }
      first = false;
    }
  }
}
