package org.mechservice.sim.user;

import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.solver.api.ForceDeclaration;
import org.mechservice.solver.api.ForceLoads;
import org.mechservice.solver.api.ForceState;
import org.mechservice.solver.api.UserForce;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/**
 * Substitutes for user classes, with the same names: forces that read nothing and exert nothing.
 * With them a model can describe itself and its columns in a process that must not load user
 * classes.
 */
public final class IdleForces {
  private static final String OBJECT = "java/lang/Object";
  private static final String CONSTRUCTOR = "<init>";

  private IdleForces() {}

  /** Returns class files by binary class name, one for each class that the forces name. */
  public static SortedMap<String, byte[]> of(Mechanism mechanism) {
    SortedMap<String, byte[]> classFiles = new TreeMap<>();
    mechanism.forces().stream()
        .filter(UserForceElement.class::isInstance)
        .map(force -> ((UserForceElement) force).className())
        .forEach(name -> classFiles.put(name, classFile(name)));
    return classFiles;
  }

  private static byte[] classFile(String name) {
    ClassWriter file = new ClassWriter(ClassWriter.COMPUTE_MAXS);
    int access = Opcodes.ACC_PUBLIC | Opcodes.ACC_FINAL | Opcodes.ACC_SUPER;
    String[] force = {Type.getInternalName(UserForce.class)};
    file.visit(Opcodes.V17, access, name.replace('.', '/'), null, OBJECT, force);
    MethodVisitor constructor = method(file, CONSTRUCTOR);
    constructor.visitVarInsn(Opcodes.ALOAD, 0);
    constructor.visitMethodInsn(Opcodes.INVOKESPECIAL, OBJECT, CONSTRUCTOR, "()V", false);
    end(constructor);
    end(method(file, "declare", ForceDeclaration.class));
    end(method(file, "apply", ForceState.class, ForceLoads.class));
    file.visitEnd();
    return file.toByteArray();
  }

  private static MethodVisitor method(ClassWriter file, String name, Class<?>... given) {
    StringBuilder types = new StringBuilder("(");
    for (Class<?> type : given) {
      types.append(Type.getDescriptor(type));
    }
    MethodVisitor code =
        file.visitMethod(Opcodes.ACC_PUBLIC, name, types.append(")V").toString(), null, null);
    code.visitCode();
    return code;
  }

  private static void end(MethodVisitor code) {
    code.visitInsn(Opcodes.RETURN);
    code.visitMaxs(0, 0);
    code.visitEnd();
  }
}
