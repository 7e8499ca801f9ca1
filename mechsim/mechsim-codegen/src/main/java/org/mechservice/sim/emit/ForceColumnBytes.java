package org.mechservice.sim.emit;

import org.mechservice.sim.emit.bytes.ClassMethods;
import org.mechservice.sim.emit.bytes.NumberInstructions;
import org.mechservice.sim.emit.bytes.TextInstructions;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.Variable;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/** Writes the methods that output the values of forces. */
final class ForceColumnBytes {
  private static final String GROUP = Type.getInternalName(ColumnGroup.class);
  private static final String VARIABLE = Type.getInternalName(Variable.class);
  private static final String LIST = "java/util/List";
  private static final String ARRAY_LIST = "java/util/ArrayList";
  private static final String STRINGS = "[Ljava/lang/String;";
  private static final String STATE_TO_ARRAY = "(D[D[D)V";
  private static final Object[] NO_STACK = {};

  private final ClassVisitor classFile;
  private final String className;

  /**
   * @param className internal name of the class
   */
  ForceColumnBytes(ClassVisitor classFile, String className) {
    this.classFile = classFile;
    this.className = className;
  }

  /** Calls the private method that fills a field of the same name. */
  private void fill(MethodVisitor code, String method, String field, int t, int y) {
    code.visitVarInsn(Opcodes.ALOAD, 0);
    code.visitVarInsn(Opcodes.DLOAD, t);
    code.visitVarInsn(Opcodes.ALOAD, y);
    code.visitVarInsn(Opcodes.ALOAD, 0);
    code.visitFieldInsn(Opcodes.GETFIELD, className, field, "[D");
    code.visitMethodInsn(Opcodes.INVOKESPECIAL, className, method, STATE_TO_ARRAY, false);
  }

  private static void jumpUnlessForces(MethodVisitor code, Label elsewhere) {
    code.visitVarInsn(Opcodes.ALOAD, 1);
    code.visitFieldInsn(Opcodes.GETSTATIC, GROUP, "FORCES", "L" + GROUP + ";");
    code.visitJumpInsn(Opcodes.IF_ACMPNE, elsewhere);
  }

  /** Writes the method that returns names and units if the group is that of forces. */
  void columns(String names, String units) {
    MethodVisitor code =
        ClassMethods.beginPublic(classFile, "columns", "(L" + GROUP + ";)L" + LIST + ";");
    Label done = new Label();
    code.visitTypeInsn(Opcodes.NEW, ARRAY_LIST);
    code.visitInsn(Opcodes.DUP);
    code.visitMethodInsn(Opcodes.INVOKESPECIAL, ARRAY_LIST, "<init>", "()V", false);
    code.visitVarInsn(Opcodes.ASTORE, 2);
    jumpUnlessForces(code, done);
    split(code, names, 3);
    split(code, units, 4);
    code.visitInsn(Opcodes.ICONST_0);
    code.visitVarInsn(Opcodes.ISTORE, 5);
    Object[] inLoop = {className, GROUP, ARRAY_LIST, STRINGS, STRINGS, Opcodes.INTEGER};
    Label body = new Label();
    code.visitLabel(body);
    code.visitFrame(Opcodes.F_NEW, inLoop.length, inLoop, 0, NO_STACK);
    addVariable(code);
    code.visitIincInsn(5, 1);
    code.visitVarInsn(Opcodes.ILOAD, 5);
    code.visitVarInsn(Opcodes.ALOAD, 3);
    code.visitInsn(Opcodes.ARRAYLENGTH);
    code.visitJumpInsn(Opcodes.IF_ICMPLT, body);
    code.visitLabel(done);
    Object[] after = {className, GROUP, ARRAY_LIST};
    code.visitFrame(Opcodes.F_NEW, after.length, after, 0, NO_STACK);
    code.visitVarInsn(Opcodes.ALOAD, 2);
    ClassMethods.end(code, Opcodes.ARETURN);
  }

  private static void split(MethodVisitor code, String text, int slot) {
    TextInstructions.push(code, text);
    code.visitLdcInsn("\n");
    code.visitInsn(Opcodes.ICONST_M1);
    code.visitMethodInsn(
        Opcodes.INVOKEVIRTUAL,
        "java/lang/String",
        "split",
        "(Ljava/lang/String;I)" + STRINGS,
        false);
    code.visitVarInsn(Opcodes.ASTORE, slot);
  }

  private static void addVariable(MethodVisitor code) {
    code.visitVarInsn(Opcodes.ALOAD, 2);
    code.visitTypeInsn(Opcodes.NEW, VARIABLE);
    code.visitInsn(Opcodes.DUP);
    for (int array = 3; array <= 4; array++) {
      code.visitVarInsn(Opcodes.ALOAD, array);
      code.visitVarInsn(Opcodes.ILOAD, 5);
      code.visitInsn(Opcodes.AALOAD);
    }
    code.visitMethodInsn(
        Opcodes.INVOKESPECIAL,
        VARIABLE,
        "<init>",
        "(Ljava/lang/String;Ljava/lang/String;)V",
        false);
    code.visitMethodInsn(Opcodes.INVOKEVIRTUAL, ARRAY_LIST, "add", "(Ljava/lang/Object;)Z", false);
    code.visitInsn(Opcodes.POP);
  }

  /** Writes the method that fills the field and copies it if the group is that of forces. */
  void values(int count) {
    MethodVisitor code = ClassMethods.beginPublic(classFile, "values", "(L" + GROUP + ";D[D[DI)V");
    Label done = new Label();
    jumpUnlessForces(code, done);
    fill(code, "forces", "forces", 2, 4);
    code.visitVarInsn(Opcodes.ALOAD, 0);
    code.visitFieldInsn(Opcodes.GETFIELD, className, "forces", "[D");
    code.visitInsn(Opcodes.ICONST_0);
    code.visitVarInsn(Opcodes.ALOAD, 5);
    code.visitVarInsn(Opcodes.ILOAD, 6);
    new NumberInstructions(code).push(count);
    code.visitMethodInsn(
        Opcodes.INVOKESTATIC,
        "java/lang/System",
        "arraycopy",
        "(Ljava/lang/Object;ILjava/lang/Object;II)V",
        false);
    code.visitLabel(done);
    Object[] types = {className, GROUP, Opcodes.DOUBLE, "[D", "[D", Opcodes.INTEGER};
    code.visitFrame(Opcodes.F_NEW, types.length, types, 0, NO_STACK);
    ClassMethods.end(code, Opcodes.RETURN);
  }
}
