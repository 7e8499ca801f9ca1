package org.mechservice.sim.emit.bytes;

import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** Begins and ends methods of a class file. */
public final class ClassMethods {
  private ClassMethods() {}

  public static MethodVisitor begin(ClassVisitor file, int access, String name, String descriptor) {
    MethodVisitor code = file.visitMethod(access, name, descriptor, null, null);
    code.visitCode();
    return code;
  }

  public static MethodVisitor beginPublic(ClassVisitor file, String name, String descriptor) {
    return begin(file, Opcodes.ACC_PUBLIC, name, descriptor);
  }

  public static void end(MethodVisitor code, int returnInstruction) {
    code.visitInsn(returnInstruction);
    code.visitMaxs(0, 0);
    code.visitEnd();
  }
}
