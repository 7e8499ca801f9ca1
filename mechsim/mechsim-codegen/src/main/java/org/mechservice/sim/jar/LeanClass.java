package org.mechservice.sim.jar;

import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.RecordComponentNode;

/**
 * Takes out of class files what only compilers and debuggers read: line numbers, names of local
 * variables and parameters, generic signatures, annotations, exceptions declared, which classes are
 * written within which. The code is the same, instruction by instruction.
 */
public final class LeanClass {
  private LeanClass() {}

  /** Returns a class file without what running it does not need. */
  public static byte[] of(byte[] classFile) {
    ClassNode node = new ClassNode();
    new ClassReader(classFile).accept(node, ClassReader.SKIP_DEBUG);
    node.signature = null;
    node.visibleAnnotations = null;
    node.invisibleAnnotations = null;
    node.visibleTypeAnnotations = null;
    node.invisibleTypeAnnotations = null;
    node.innerClasses.clear();
    node.fields.forEach(LeanClass::strip);
    node.methods.forEach(LeanClass::strip);
    if (node.recordComponents != null) {
      node.recordComponents.forEach(LeanClass::strip);
    }
    ClassWriter writer = new ClassWriter(0);
    node.accept(writer);
    return writer.toByteArray();
  }

  /**
   * Returns a class file that does not list the components of its record either, for where nobody
   * asks for them: the record's fields and methods are all that its code uses.
   */
  public static byte[] withoutComponents(byte[] classFile) {
    ClassNode node = new ClassNode();
    new ClassReader(classFile).accept(node, 0);
    if (node.recordComponents == null) {
      return classFile;
    }
    node.recordComponents = null;
    ClassWriter writer = new ClassWriter(0);
    node.accept(writer);
    return writer.toByteArray();
  }

  private static void strip(FieldNode field) {
    field.signature = null;
    field.visibleAnnotations = null;
    field.invisibleAnnotations = null;
    field.visibleTypeAnnotations = null;
    field.invisibleTypeAnnotations = null;
  }

  private static void strip(MethodNode method) {
    method.signature = null;
    method.exceptions = null;
    method.visibleAnnotations = null;
    method.invisibleAnnotations = null;
    method.visibleTypeAnnotations = null;
    method.invisibleTypeAnnotations = null;
    method.visibleParameterAnnotations = null;
    method.invisibleParameterAnnotations = null;
    method.visibleLocalVariableAnnotations = null;
    method.invisibleLocalVariableAnnotations = null;
  }

  private static void strip(RecordComponentNode component) {
    component.signature = null;
    component.visibleAnnotations = null;
    component.invisibleAnnotations = null;
    component.visibleTypeAnnotations = null;
    component.invisibleTypeAnnotations = null;
  }
}
