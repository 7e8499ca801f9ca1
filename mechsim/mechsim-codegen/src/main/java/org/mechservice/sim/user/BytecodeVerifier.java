package org.mechservice.sim.user;

import java.util.Set;
import java.util.SortedMap;
import org.jspecify.annotations.Nullable;
import org.mechservice.solver.api.UserForce;
import org.mechservice.solver.catalogue.MessageCode;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ConstantDynamic;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.Handle;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/**
 * Verifies, without loading them, that user classes use nothing but each other, the force interface
 * and {@link AllowedJava}: no files, network, reflection, threads or processes.
 */
final class BytecodeVerifier extends ClassVisitor {
  private static final String INTERFACE = UserForce.class.getPackageName().replace('.', '/') + "/";

  private final Set<String> own;
  private final UserCodeFindings findings;
  private String className = "";

  private BytecodeVerifier(Set<String> own, UserCodeFindings findings) {
    super(Opcodes.ASM9);
    this.own = own;
    this.findings = findings;
  }

  /** Adds to the findings each use of something not allowed, with method and line. */
  static void check(SortedMap<String, byte[]> classFiles, UserCodeFindings findings) {
    for (byte[] file : classFiles.values()) {
      new ClassReader(file)
          .accept(new BytecodeVerifier(classFiles.keySet(), findings), ClassReader.SKIP_FRAMES);
    }
  }

  @Override
  public void visit(
      int version,
      int access,
      String name,
      @Nullable String signature,
      @Nullable String superName,
      String @Nullable [] interfaces) {
    className = name.replace('/', '.');
    requireClass(superName, "it extends", "", 0);
    if (interfaces != null) {
      for (String parent : interfaces) {
        requireClass(parent, "it implements", "", 0);
      }
    }
  }

  @Override
  public @Nullable FieldVisitor visitField(
      int access,
      String name,
      String descriptor,
      @Nullable String signature,
      @Nullable Object value) {
    requireType(Type.getType(descriptor), "field " + name + " is a", "", 0);
    return null;
  }

  @Override
  public MethodVisitor visitMethod(
      int access,
      String name,
      String descriptor,
      @Nullable String signature,
      String @Nullable [] exceptions) {
    if ((access & Opcodes.ACC_NATIVE) != 0) {
      refuse("it is native", name, 0);
    } else if (name.equals("finalize")) {
      refuse("it would run in a thread of Java's own", name, 0);
    }
    return new Code(name);
  }

  private boolean allowed(String internalName) {
    return own.contains(internalName.replace('/', '.'))
        || internalName.startsWith(INTERFACE)
        || AllowedJava.isClass(internalName);
  }

  private void requireClass(@Nullable String internalName, String how, String method, int line) {
    if (internalName != null) {
      requireType(Type.getObjectType(internalName), how, method, line);
    }
  }

  private void requireType(Type type, String how, String method, int line) {
    Type element = type.getSort() == Type.ARRAY ? type.getElementType() : type;
    if (element.getSort() == Type.OBJECT && !allowed(element.getInternalName())) {
      refuse(how + " " + element.getClassName(), method, line);
    }
  }

  private void refuse(String what, String method, int line) {
    findings.add(
        MessageCode.USER_CLASS_NOT_PERMITTED,
        className,
        line,
        0,
        "class "
            + className
            + (method.isEmpty() ? "" : ", method " + method)
            + (line == 0 ? "" : ", line " + line)
            + ": "
            + what
            + "; a class of a model may use numbers, texts and collections, and nothing of files,"
            + " network, threads, processes or reflection");
  }

  /** What one method uses. */
  private final class Code extends MethodVisitor {
    private final String method;
    private int line;

    Code(String method) {
      super(Opcodes.ASM9);
      this.method = method;
    }

    @Override
    public void visitLineNumber(int number, Label start) {
      line = number;
    }

    @Override
    public void visitMethodInsn(
        int opcode, String owner, String name, String descriptor, boolean isInterface) {
      requireMember(owner, name, "it calls");
    }

    @Override
    public void visitFieldInsn(int opcode, String owner, String name, String descriptor) {
      requireMember(owner, name, "it uses");
    }

    private void requireMember(String owner, String name, String how) {
      boolean arrays = owner.startsWith("["); // clone()
      boolean foreign = !own.contains(owner.replace('/', '.')) && !owner.startsWith(INTERFACE);
      boolean inherited = !foreign && !AllowedJava.isMember("java/lang/Object", name);
      if (!arrays && (foreign ? !AllowedJava.isMember(owner, name) : inherited)) {
        refuse(how + " " + owner.replace('/', '.') + "." + name, method, line);
      }
    }

    @Override
    public void visitTypeInsn(int opcode, String type) {
      requireClass(type, "it uses", method, line);
    }

    @Override
    public void visitMultiANewArrayInsn(String descriptor, int dimensions) {
      requireType(Type.getType(descriptor), "it uses", method, line);
    }

    @Override
    public void visitTryCatchBlock(Label start, Label end, Label handler, @Nullable String type) {
      requireClass(type, "it catches", method, line);
    }

    @Override
    public void visitLdcInsn(Object value) {
      if (value instanceof Handle || value instanceof ConstantDynamic) {
        refuse("it uses a method handle", method, line);
      } else if (value instanceof Type type && type.getSort() != Type.METHOD) {
        requireType(type, "it uses", method, line);
      }
    }

    @Override
    public void visitInvokeDynamicInsn(
        String name, String descriptor, Handle bootstrap, Object... arguments) {
      if (!AllowedJava.isBootstrap(bootstrap.getOwner())) {
        refuse("it links to " + bootstrap.getOwner().replace('/', '.'), method, line);
      }
      requireType(Type.getReturnType(descriptor), "it makes a", method, line);
      for (Object argument : arguments) {
        if (argument instanceof Handle handle) {
          requireMember(handle.getOwner(), handle.getName(), "it refers to");
        }
      }
    }
  }
}
