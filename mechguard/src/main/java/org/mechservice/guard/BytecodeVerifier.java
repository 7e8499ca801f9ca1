package org.mechservice.guard;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.mechservice.solver.api.UserForce;
import org.objectweb.asm.AnnotationVisitor;
import org.objectweb.asm.Attribute;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.Handle;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.ModuleVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.RecordComponentVisitor;
import org.objectweb.asm.Type;
import org.objectweb.asm.TypePath;

/**
 * Verifies, without loading them, that user classes use nothing but each other, the force interface
 * and {@link AllowedJava}: no files, network, reflection, threads or processes.
 *
 * <p>Every part of a class file that can name a class, a member or a constant is visited, and
 * everything not known to be harmless is refused, including attributes, kinds of constants and ways
 * of linking of later Java versions. Two parts are skipped, because only reflection reads them:
 * generic signatures and the list of inner classes.
 */
public final class BytecodeVerifier extends ClassVisitor {
  private static final String INTERFACE = UserForce.class.getPackageName().replace('.', '/') + "/";

  /**
   * Tags of known constants: texts, numbers, classes, members, method handles, method types and
   * invokedynamic. JVMS 17, Table 4.4-A.
   */
  private static final Set<Integer> CONSTANTS =
      Set.of(1, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 15, 16, 18);

  private final Set<String> own;
  private final Predicate<String> product;
  private final List<Refusal> findings;
  private String className = "";

  /**
   * @param own binary names of the classes that came together
   * @param product whether a class of the product, by internal name, may be used
   */
  private BytecodeVerifier(Set<String> own, Predicate<String> product, List<Refusal> findings) {
    super(Opcodes.ASM9);
    this.own = own;
    this.product = product;
    this.findings = findings;
  }

  /**
   * A use of something that is not allowed.
   *
   * @param className binary name of the class
   * @param line of its source, from 1; 0 if unknown
   * @param text what it uses, where, and what classes may use
   */
  public record Refusal(String className, int line, String text) {}

  /**
   * Returns each use of something that is not allowed, with method and line.
   *
   * @param classFiles class files by binary name, which may use each other; not modified
   */
  public static List<Refusal> check(SortedMap<String, byte[]> classFiles) {
    return check(classFiles, classFiles.keySet(), name -> name.startsWith(INTERFACE));
  }

  /**
   * Returns each use of something that generated classes of a model may not use, which came from
   * elsewhere: they may use parts of the solver, too.
   *
   * @param classFiles class files by binary name; not modified
   * @param ofUsers binary names of the classes of users that came with them
   */
  public static List<Refusal> checkModel(
      SortedMap<String, byte[]> classFiles, Set<String> ofUsers) {
    Set<String> own = new HashSet<>(classFiles.keySet());
    own.addAll(ofUsers);
    return check(classFiles, own, AllowedSolver::isClass);
  }

  private static List<Refusal> check(
      SortedMap<String, byte[]> classFiles, Set<String> own, Predicate<String> product) {
    List<Refusal> findings = new ArrayList<>();
    classFiles.forEach(
        (name, file) -> {
          BytecodeVerifier verifier = new BytecodeVerifier(own, product, findings);
          try {
            ClassReader reader = new ClassReader(file);
            reader.accept(verifier, ClassReader.SKIP_FRAMES);
            verifier.requireKnownConstants(reader);
          } catch (IllegalArgumentException | IndexOutOfBoundsException e) {
            verifier.className = name;
            verifier.refuse("it is no class file that can be read", "", 0);
          }
        });
    return findings;
  }

  /** Refuses kinds of constants outside the list, whether or not anything uses them. */
  private void requireKnownConstants(ClassReader reader) {
    for (int i = 1; i < reader.getItemCount(); i++) {
      int offset = reader.getItem(i);
      // A long or double number takes two places in the pool; the second is empty.
      if (offset > 0 && !CONSTANTS.contains(reader.readByte(offset - 1))) {
        refuse("it has a constant of the kind " + reader.readByte(offset - 1), "", 0);
      }
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
    if ((version & Opcodes.V_PREVIEW) != 0) {
      refuse("it uses preview features of Java", "", 0);
    }
    requireClass(superName, "it extends", "", 0);
    if (interfaces != null) {
      for (String parent : interfaces) {
        requireClass(parent, "it implements", "", 0);
      }
    }
  }

  @Override
  public void visitNestHost(String host) {
    requireOwn(host, "its nest host is");
  }

  @Override
  public void visitNestMember(String member) {
    requireOwn(member, "its nest has the member");
  }

  @Override
  public void visitPermittedSubclass(String subclass) {
    requireOwn(subclass, "it permits the subclass");
  }

  @Override
  public void visitOuterClass(String owner, @Nullable String name, @Nullable String descriptor) {
    requireOwn(owner, "it is enclosed by");
  }

  private void requireOwn(String internalName, String how) {
    if (!own.contains(internalName.replace('/', '.'))) {
      refuse(how + " " + internalName.replace('/', '.') + ", which did not come with it", "", 0);
    }
  }

  @Override
  public @Nullable ModuleVisitor visitModule(String name, int access, @Nullable String version) {
    refuse("it is a module", "", 0);
    return null;
  }

  @Override
  public void visitAttribute(Attribute attribute) {
    requireKnown(attribute, "", 0);
  }

  @Override
  public AnnotationVisitor visitAnnotation(String descriptor, boolean visible) {
    return annotation(descriptor, "", 0);
  }

  @Override
  public AnnotationVisitor visitTypeAnnotation(
      int typeRef, @Nullable TypePath typePath, String descriptor, boolean visible) {
    return annotation(descriptor, "", 0);
  }

  @Override
  public RecordComponentVisitor visitRecordComponent(
      String name, String descriptor, @Nullable String signature) {
    requireType(Type.getType(descriptor), "component " + name + " is a", "", 0);
    return new RecordComponentVisitor(Opcodes.ASM9) {
      @Override
      public AnnotationVisitor visitAnnotation(String type, boolean visible) {
        return annotation(type, "", 0);
      }

      @Override
      public AnnotationVisitor visitTypeAnnotation(
          int typeRef, @Nullable TypePath typePath, String type, boolean visible) {
        return annotation(type, "", 0);
      }

      @Override
      public void visitAttribute(Attribute attribute) {
        requireKnown(attribute, "", 0);
      }
    };
  }

  @Override
  public FieldVisitor visitField(
      int access,
      String name,
      String descriptor,
      @Nullable String signature,
      @Nullable Object value) {
    requireType(Type.getType(descriptor), "field " + name + " is a", "", 0);
    return new FieldVisitor(Opcodes.ASM9) {
      @Override
      public AnnotationVisitor visitAnnotation(String type, boolean visible) {
        return annotation(type, "", 0);
      }

      @Override
      public AnnotationVisitor visitTypeAnnotation(
          int typeRef, @Nullable TypePath typePath, String type, boolean visible) {
        return annotation(type, "", 0);
      }

      @Override
      public void visitAttribute(Attribute attribute) {
        requireKnown(attribute, "", 0);
      }
    };
  }

  /** Checks an annotation and its values. */
  private AnnotationVisitor annotation(String descriptor, String method, int line) {
    requireType(Type.getType(descriptor), "it is annotated with", method, line);
    return annotationValues(method, line);
  }

  /** Checks the values of an annotation, given or by default. */
  private AnnotationVisitor annotationValues(String method, int line) {
    return new AnnotationVisitor(Opcodes.ASM9) {
      @Override
      public void visit(String name, Object value) {
        if (value instanceof Type type) {
          requireType(type, "an annotation names", method, line);
        }
      }

      @Override
      public void visitEnum(String name, String type, String value) {
        requireType(Type.getType(type), "an annotation names", method, line);
      }

      @Override
      public AnnotationVisitor visitAnnotation(String name, String nested) {
        return annotation(nested, method, line);
      }

      @Override
      public AnnotationVisitor visitArray(String name) {
        return this;
      }
    };
  }

  private void requireKnown(Attribute attribute, String method, int line) {
    refuse("it has the unknown attribute " + attribute.type, method, line);
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
    requireSignature(descriptor, "it takes or returns a", name, 0);
    if (exceptions != null) {
      for (String exception : exceptions) {
        requireClass(exception, "it throws", name, 0);
      }
    }
    return new Code(name);
  }

  private boolean allowed(String internalName) {
    return own.contains(internalName.replace('/', '.'))
        || product.test(internalName)
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

  /**
   * Checks the types of arguments and of the result; their objects must at least be permitted to be
   * passed on.
   */
  private void requireSignature(String descriptor, String how, String method, int line) {
    for (Type argument : Type.getArgumentTypes(descriptor)) {
      requireHandedOn(argument, how, method, line);
    }
    requireHandedOn(Type.getReturnType(descriptor), how, method, line);
  }

  private void requireHandedOn(Type type, String how, String method, int line) {
    Type element = type.getSort() == Type.ARRAY ? type.getElementType() : type;
    if (element.getSort() != Type.OBJECT || !AllowedJava.isHandedOn(element.getInternalName())) {
      requireType(element, how, method, line);
    }
  }

  private void refuse(String what, String method, int line) {
    findings.add(
        new Refusal(
            className,
            line,
            "class "
                + className
                + (method.isEmpty() ? "" : ", method " + method)
                + (line == 0 ? "" : ", line " + line)
                + ": "
                + what
                + "; a class of a model may use numbers, texts and collections, and nothing of"
                + " files, network, threads, processes or reflection"));
  }

  /** Checks the instructions of one method. */
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
      if (requireMember(owner, name, "it calls")) {
        requireSignature(descriptor, "it calls " + name + " with a", method, line);
      }
    }

    @Override
    public void visitFieldInsn(int opcode, String owner, String name, String descriptor) {
      if (requireMember(owner, name, "it uses")) {
        requireHandedOn(Type.getType(descriptor), "it uses a", method, line);
      }
    }

    /** Returns whether the member may be used. */
    private boolean requireMember(String owner, String name, String how) {
      if (owner.startsWith("[")) {
        return requireMemberOfArray(Type.getObjectType(owner), name, how);
      }
      boolean foreign = !own.contains(owner.replace('/', '.')) && !product.test(owner);
      boolean inherited = !foreign && !AllowedJava.isMember("java/lang/Object", name);
      boolean refused = foreign ? !AllowedJava.isMember(owner, name) : inherited;
      if (refused) {
        refuse(how + " " + owner.replace('/', '.') + "." + name, method, line);
      }
      return !refused;
    }

    /** Arrays have the members of Object, clone() among them. */
    private boolean requireMemberOfArray(Type array, String name, String how) {
      requireType(array, how + " " + name + " of an array of", method, line);
      boolean refused = !AllowedJava.isMember("java/lang/Object", name);
      if (refused) {
        refuse(how + " " + name + " of an array", method, line);
      }
      return !refused;
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
      if (value instanceof Type type && type.getSort() != Type.METHOD) {
        requireType(type, "it uses", method, line);
      } else if (!AllowedJava.isPlain(value)) {
        refuse("it uses " + kindOf(value), method, line);
      }
    }

    @Override
    public void visitInvokeDynamicInsn(
        String name, String descriptor, Handle bootstrap, Object... arguments) {
      if (!AllowedJava.isBootstrap(bootstrap)) {
        String linked = bootstrap.getOwner().replace('/', '.') + "." + bootstrap.getName();
        refuse("it links to " + linked, method, line);
      } else if (!AllowedJava.isLinkedAsCompiled(bootstrap, arguments)) {
        refuse(
            "it links to " + bootstrap.getName() + " with other arguments than javac writes",
            method,
            line);
      }
      requireType(Type.getReturnType(descriptor), "it makes a", method, line);
      requireSignature(descriptor, "it makes something of a", method, line);
      for (Object argument : arguments) {
        if (argument instanceof Handle handle) {
          if (requireMember(handle.getOwner(), handle.getName(), "it refers to")) {
            requireLinked(handle);
          }
        } else if (argument instanceof Type type && type.getSort() == Type.METHOD) {
          requireSignature(type.getDescriptor(), "it refers to a", method, line);
        } else if (argument instanceof Type type) {
          requireType(type, "it refers to", method, line);
        } else if (!AllowedJava.isPlain(argument)) {
          refuse("it is linked with " + kindOf(argument), method, line);
        }
      }
    }

    private void requireLinked(Handle handle) {
      if (handle.getDesc().startsWith("(")) {
        requireSignature(handle.getDesc(), "it refers to a method with a", method, line);
      } else {
        requireType(Type.getType(handle.getDesc()), "it refers to a", method, line);
      }
    }

    private String kindOf(Object constant) {
      if (constant instanceof Handle) {
        return "a method handle";
      } else if (constant instanceof Type) {
        return "a method type";
      }
      return "a constant that is computed when it is first used";
    }

    @Override
    public void visitAttribute(Attribute attribute) {
      requireKnown(attribute, method, line);
    }

    @Override
    public AnnotationVisitor visitAnnotation(String descriptor, boolean visible) {
      return annotation(descriptor, method, line);
    }

    @Override
    public AnnotationVisitor visitTypeAnnotation(
        int typeRef, @Nullable TypePath typePath, String descriptor, boolean visible) {
      return annotation(descriptor, method, line);
    }

    @Override
    public AnnotationVisitor visitInsnAnnotation(
        int typeRef, @Nullable TypePath typePath, String descriptor, boolean visible) {
      return annotation(descriptor, method, line);
    }

    @Override
    public AnnotationVisitor visitTryCatchAnnotation(
        int typeRef, @Nullable TypePath typePath, String descriptor, boolean visible) {
      return annotation(descriptor, method, line);
    }

    @Override
    public AnnotationVisitor visitLocalVariableAnnotation(
        int typeRef,
        @Nullable TypePath typePath,
        Label[] start,
        Label[] end,
        int[] index,
        String descriptor,
        boolean visible) {
      return annotation(descriptor, method, line);
    }

    @Override
    public AnnotationVisitor visitParameterAnnotation(
        int parameter, String descriptor, boolean visible) {
      return annotation(descriptor, method, line);
    }

    @Override
    public AnnotationVisitor visitAnnotationDefault() {
      return annotationValues(method, line);
    }
  }
}
