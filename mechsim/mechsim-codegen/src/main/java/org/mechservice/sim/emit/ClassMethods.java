package org.mechservice.sim.emit;

import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** Begins and ends methods of a class file. */
final class ClassMethods {
  private ClassMethods() {}

  static MethodVisitor begin(ClassVisitor file, int access, String name, String descriptor) {
    MethodVisitor code = file.visitMethod(access, name, descriptor, null, null);
    code.visitCode();
    return code;
  }

  static MethodVisitor beginPublic(ClassVisitor file, String name, String descriptor) {
    return begin(file, Opcodes.ACC_PUBLIC, name, descriptor);
  }

  static void end(MethodVisitor code, int returnInstruction) {
    code.visitInsn(returnInstruction);
    code.visitMaxs(0, 0);
    code.visitEnd();
  }
}
