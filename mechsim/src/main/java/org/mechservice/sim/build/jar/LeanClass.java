package org.mechservice.sim.build.jar;

import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.RecordComponentNode;

/**
 * Takes out of class files what only compilers and debuggers read: line numbers, names of local
 * variables and parameters, generic signatures. The code is the same, instruction by instruction.
 */
public final class LeanClass {
  private LeanClass() {}

  /** Returns a class file without what running it does not need. */
  public static byte[] of(byte[] classFile) {
    ClassNode node = new ClassNode();
    new ClassReader(classFile).accept(node, ClassReader.SKIP_DEBUG);
    node.signature = null;
    for (FieldNode field : node.fields) {
      field.signature = null;
    }
    for (MethodNode method : node.methods) {
      method.signature = null;
    }
    if (node.recordComponents != null) {
      for (RecordComponentNode component : node.recordComponents) {
        component.signature = null;
      }
    }
    ClassWriter writer = new ClassWriter(0);
    node.accept(writer);
    return writer.toByteArray();
  }
}
