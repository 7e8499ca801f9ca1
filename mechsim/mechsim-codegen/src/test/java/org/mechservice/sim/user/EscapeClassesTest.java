package org.mechservice.sim.user;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.guard.BytecodeVerifier;
import org.mechservice.guard.UserClassLoader;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.objectweb.asm.AnnotationVisitor;
import org.objectweb.asm.Attribute;
import org.objectweb.asm.ByteVector;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.ConstantDynamic;
import org.objectweb.asm.Handle;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/**
 * Classes that try to get out of a model, each by another part of the class-file format: all are
 * refused before they are loaded.
 */
class EscapeClassesTest {
  private static final String OBJECT = "java/lang/Object";
  private static final String DESCRIPTION = "(Ljava/lang/invoke/MethodHandles$Lookup;";

  private static Arguments escape(String name, Consumer<ClassWriter> how) {
    return Arguments.of(name, how);
  }

  private static Arguments inCode(String name, Consumer<MethodVisitor> how) {
    return escape(
        name,
        writer -> {
          MethodVisitor code = writer.visitMethod(Opcodes.ACC_PUBLIC, "apply", "()V", null, null);
          code.visitCode();
          how.accept(code);
          code.visitInsn(Opcodes.RETURN);
          code.visitMaxs(9, 9);
          code.visitEnd();
        });
  }

  private static Handle method(String owner, String name, String descriptor) {
    return new Handle(Opcodes.H_INVOKESTATIC, owner, name, descriptor, false);
  }

  /** Runs a method of Java's choice while a constant is computed. */
  private static final Handle INVOKE =
      method(
          "java/lang/invoke/ConstantBootstraps",
          "invoke",
          DESCRIPTION
              + "Ljava/lang/String;Ljava/lang/Class;Ljava/lang/invoke/MethodHandle;"
              + "[Ljava/lang/Object;)Ljava/lang/Object;");

  private static final Handle GET_RUNTIME =
      method("java/lang/Runtime", "getRuntime", "()Ljava/lang/Runtime;");
  private static final Handle EXEC =
      new Handle(
          Opcodes.H_INVOKEVIRTUAL,
          "java/lang/Runtime",
          "exec",
          "(Ljava/lang/String;)Ljava/lang/Process;",
          false);

  /** {@code Runtime.getRuntime().exec("id")} as a constant within a constant. */
  private static final ConstantDynamic PROCESS =
      new ConstantDynamic(
          "p",
          "Ljava/lang/Object;",
          INVOKE,
          EXEC,
          new ConstantDynamic("r", "Ljava/lang/Runtime;", INVOKE, GET_RUNTIME),
          "id");

  private static final Handle LAMBDA =
      method(
          "java/lang/invoke/LambdaMetafactory",
          "metafactory",
          DESCRIPTION
              + "Ljava/lang/String;Ljava/lang/invoke/MethodType;Ljava/lang/invoke/MethodType;"
              + "Ljava/lang/invoke/MethodHandle;Ljava/lang/invoke/MethodType;)"
              + "Ljava/lang/invoke/CallSite;");
  private static final Handle CONCATENATION =
      method(
          "java/lang/invoke/StringConcatFactory",
          "makeConcatWithConstants",
          DESCRIPTION
              + "Ljava/lang/String;Ljava/lang/invoke/MethodType;Ljava/lang/String;"
              + "[Ljava/lang/Object;)Ljava/lang/invoke/CallSite;");

  private static final Handle RECORD =
      method(
          "java/lang/runtime/ObjectMethods",
          "bootstrap",
          DESCRIPTION
              + "Ljava/lang/String;Ljava/lang/invoke/TypeDescriptor;Ljava/lang/Class;"
              + "Ljava/lang/String;[Ljava/lang/invoke/MethodHandle;)Ljava/lang/Object;");

  private static final Type GETS = Type.getMethodType("()Ljava/lang/Object;");
  private static final Type PUSH = Type.getObjectType("car/Push");
  private static final Handle OWN = method("car/Push", "own", "()Ljava/lang/Object;");

  /** A call that links something, as the compiler would but for one thing. */
  private static Arguments linking(
      String name, String at, String descriptor, Handle bootstrap, Object... arguments) {
    return inCode(name, code -> code.visitInvokeDynamicInsn(at, descriptor, bootstrap, arguments));
  }

  private static Stream<Arguments> unusualLinks() {
    String supplier = "()Ljava/util/function/Supplier;";
    String text = "()Ljava/lang/String;";
    Handle own = new Handle(Opcodes.H_GETFIELD, "car/Push", "x", "D", false);
    return Stream.of(
        linking("a lambda without its type at the place", "get", supplier, LAMBDA, GETS, OWN),
        linking("a lambda with one argument more", "get", supplier, LAMBDA, GETS, OWN, GETS, 1),
        linking("a lambda in another order", "get", supplier, LAMBDA, OWN, GETS, GETS),
        linking("a lambda of a text", "get", supplier, LAMBDA, GETS, "own", GETS),
        linking("a lambda of nothing", "get", supplier, LAMBDA),
        linking("a concatenation without a recipe", "c", text, CONCATENATION),
        linking("a concatenation with a number as its recipe", "c", text, CONCATENATION, 1),
        linking("a concatenation of a class", "c", text, CONCATENATION, "\2", PUSH),
        linking("a concatenation of a method", "c", text, CONCATENATION, "\2", OWN),
        linking("a record without names", "toString", text, RECORD, PUSH),
        linking("a record whose names are a class", "toString", text, RECORD, PUSH, PUSH),
        linking("a record without a class", "toString", text, RECORD, "x", "x", own),
        linking("a record of a method", "toString", text, RECORD, PUSH, "x", OWN),
        linking(
            "a record of another's field",
            "toString",
            text,
            RECORD,
            PUSH,
            "x",
            new Handle(Opcodes.H_GETFIELD, "car/Other", "x", "D", false)),
        linking(
            "the lambda factory with another type",
            "get",
            supplier,
            method("java/lang/invoke/LambdaMetafactory", "metafactory", "()V"),
            GETS,
            OWN,
            GETS),
        linking(
            "the lambda factory of an interface",
            "get",
            supplier,
            new Handle(
                LAMBDA.getTag(), LAMBDA.getOwner(), LAMBDA.getName(), LAMBDA.getDesc(), true),
            GETS,
            OWN,
            GETS));
  }

  private static Stream<Arguments> escapes() {
    return Stream.concat(unusualLinks(), forbiddenUses());
  }

  private static Stream<Arguments> forbiddenUses() {
    return Stream.of(
        escape(
            "a class as the default of an annotation's value",
            w -> {
              MethodVisitor value = w.visitMethod(1024, "value", "()Ljava/lang/Class;", null, null);
              AnnotationVisitor standard = value.visitAnnotationDefault();
              standard.visit("", Type.getObjectType("java/lang/Runtime"));
              standard.visitEnd();
            }),
        escape(
            "an annotation as the default of an annotation's value",
            w -> {
              MethodVisitor value = w.visitMethod(1024, "value", "()[I", null, null);
              AnnotationVisitor list = value.visitAnnotationDefault().visitArray("");
              list.visitAnnotation("", "Ljava/lang/Runnable;").visitEnd();
              list.visitEnd();
            }),
        inCode(
            "a dynamic constant among the arguments of a concatenation",
            code ->
                code.visitInvokeDynamicInsn(
                    "c", "()Ljava/lang/String;", CONCATENATION, "\2", PROCESS)),
        inCode(
            "a dynamic constant among the arguments of a lambda",
            code ->
                code.visitInvokeDynamicInsn(
                    "get", "()Ljava/util/function/Supplier;", LAMBDA, GETS, PROCESS, GETS)),
        inCode("a dynamic constant loaded", code -> code.visitLdcInsn(PROCESS)),
        inCode("a method handle loaded", code -> code.visitLdcInsn(GET_RUNTIME)),
        inCode("a method type loaded", code -> code.visitLdcInsn(Type.getMethodType("()V"))),
        inCode(
            "a class loaded as a constant",
            code -> code.visitLdcInsn(Type.getObjectType("java/lang/Runtime"))),
        inCode(
            "an array class loaded as a constant",
            code -> code.visitLdcInsn(Type.getType("[[Ljava/lang/Thread;"))),
        inCode(
            "a bootstrap method of its own",
            code ->
                code.visitInvokeDynamicInsn(
                    "x", "()Ljava/lang/String;", method("car/Push", "boot", "()V"))),
        inCode(
            "a bootstrap method that runs what it is given",
            code -> code.visitInvokeDynamicInsn("x", "()Ljava/lang/Object;", INVOKE, GET_RUNTIME)),
        inCode(
            "the lambda factory that also makes serialisable ones",
            code ->
                code.visitInvokeDynamicInsn(
                    "get",
                    "()Ljava/util/function/Supplier;",
                    method("java/lang/invoke/LambdaMetafactory", "altMetafactory", "()V"))),
        inCode(
            "a lambda factory called in another way",
            code ->
                code.visitInvokeDynamicInsn(
                    "get",
                    "()Ljava/util/function/Supplier;",
                    new Handle(
                        Opcodes.H_INVOKEVIRTUAL,
                        "java/lang/invoke/LambdaMetafactory",
                        "metafactory",
                        "()V",
                        false))),
        inCode(
            "a lambda of a forbidden method",
            code ->
                code.visitInvokeDynamicInsn(
                    "get",
                    "()Ljava/util/function/Supplier;",
                    LAMBDA,
                    Type.getMethodType("()Ljava/lang/Object;"),
                    GET_RUNTIME,
                    Type.getMethodType("()Ljava/lang/Object;"))),
        inCode(
            "a lambda of a forbidden constructor",
            code ->
                code.visitInvokeDynamicInsn(
                    "get",
                    "()Ljava/util/function/Supplier;",
                    LAMBDA,
                    GETS,
                    new Handle(
                        Opcodes.H_NEWINVOKESPECIAL, "java/lang/Thread", "<init>", "()V", false),
                    GETS)),
        inCode(
            "a lambda that is a task of a thread",
            code ->
                code.visitInvokeDynamicInsn(
                    "run", "()Ljava/lang/Runnable;", LAMBDA, GETS, OWN, GETS)),
        inCode(
            "a lambda that holds a stream",
            code ->
                code.visitInvokeDynamicInsn(
                    "get",
                    "(Ljava/io/InputStream;)Ljava/util/function/Supplier;",
                    LAMBDA,
                    GETS,
                    OWN,
                    GETS)),
        inCode(
            "the type of a lambda's method",
            code ->
                code.visitInvokeDynamicInsn(
                    "get",
                    "()Ljava/util/function/Supplier;",
                    LAMBDA,
                    Type.getMethodType("(Ljava/lang/Process;)V"),
                    OWN,
                    GETS)),
        inCode(
            "a class as a lambda's argument",
            code ->
                code.visitInvokeDynamicInsn(
                    "get",
                    "()Ljava/util/function/Supplier;",
                    LAMBDA,
                    Type.getObjectType("java/lang/Process"))),
        inCode("a cast", code -> code.visitTypeInsn(Opcodes.CHECKCAST, "java/lang/Thread")),
        inCode("a test", code -> code.visitTypeInsn(Opcodes.INSTANCEOF, "java/lang/Thread")),
        inCode("an array", code -> code.visitTypeInsn(Opcodes.ANEWARRAY, "java/lang/Thread")),
        inCode(
            "an array of arrays", code -> code.visitMultiANewArrayInsn("[[Ljava/lang/Thread;", 2)),
        inCode(
            "a call whose argument opens classes",
            code ->
                code.visitMethodInsn(
                    Opcodes.INVOKEVIRTUAL,
                    "java/lang/String",
                    "resolveConstantDesc",
                    "(Ljava/lang/invoke/MethodHandles$Lookup;)Ljava/lang/String;",
                    false)),
        inCode(
            "a call whose result is a description of a class",
            code ->
                code.visitMethodInsn(
                    Opcodes.INVOKEVIRTUAL,
                    "java/lang/Enum",
                    "x",
                    "()Ljava/lang/Enum$EnumDesc;",
                    false)),
        inCode(
            "a field of a foreign type",
            code ->
                code.visitFieldInsn(
                    Opcodes.GETFIELD, "car/Push", "x", "Ljava/lang/ProcessHandle;")),
        escape(
            "a native method",
            w -> w.visitMethod(Opcodes.ACC_NATIVE, "x", "()V", null, null).visitEnd()),
        escape(
            "a finalizer", w -> w.visitMethod(Opcodes.ACC_ABSTRACT, "finalize", "()V", null, null)),
        escape("a parameter", w -> w.visitMethod(1024, "x", "(Ljava/lang/Thread;)V", null, null)),
        escape("a result", w -> w.visitMethod(1024, "x", "()Ljava/net/URL;", null, null)),
        escape(
            "a declared exception",
            w -> w.visitMethod(1024, "x", "()V", null, new String[] {"java/io/IOException"})),
        escape("a field", w -> w.visitField(0, "x", "Ljava/lang/Thread;", null, null)),
        escape("a nest host", w -> w.visitNestHost("java/util/ArrayList")),
        escape("a nest member", w -> w.visitNestMember("java/util/ArrayList$Itr")),
        escape("a permitted subclass", w -> w.visitPermittedSubclass("java/lang/Thread")),
        escape("an enclosing method", w -> w.visitOuterClass("java/lang/System", "x", "()V")),
        escape("a record component", w -> w.visitRecordComponent("x", "Ljava/io/File;", null)),
        escape("a module", w -> w.visitModule("m", 0, null).visitEnd()),
        escape("an unknown attribute", w -> w.visitAttribute(new Unknown())),
        escape(
            "an unknown attribute of a field",
            w -> w.visitField(0, "x", "I", null, null).visitAttribute(new Unknown())),
        inCode("an unknown attribute of a method", code -> code.visitAttribute(new Unknown())),
        escape("an annotation", w -> w.visitAnnotation("Ljava/lang/Thread;", true)),
        escape(
            "a class named by an annotation",
            w -> {
              AnnotationVisitor a = w.visitAnnotation("Ljava/lang/Deprecated;", true);
              a.visit("since", Type.getObjectType("java/lang/Runtime"));
              a.visitEnd();
            }),
        escape(
            "an enumeration named by an annotation",
            w -> {
              AnnotationVisitor a = w.visitAnnotation("Ljava/lang/Deprecated;", true);
              a.visitEnum("x", "Ljava/lang/ProcessBuilder$Redirect$Type;", "READ");
              a.visitEnd();
            }),
        escape(
            "an annotation within an annotation",
            w -> {
              AnnotationVisitor a = w.visitAnnotation("Ljava/lang/Deprecated;", true);
              AnnotationVisitor list = a.visitArray("x");
              list.visitAnnotation("", "Ljava/lang/Runnable;").visitEnd();
              list.visitEnd();
              a.visitEnd();
            }));
  }

  /** An attribute that no Java knows. */
  private static final class Unknown extends Attribute {
    Unknown() {
      super("Escape");
    }

    @Override
    protected ByteVector write(ClassWriter w, byte[] code, int length, int stack, int locals) {
      return new ByteVector(0);
    }
  }

  private static byte[] classFile(String name, String parent, Consumer<ClassWriter> how) {
    ClassWriter writer = new ClassWriter(0);
    writer.visit(Opcodes.V17, Opcodes.ACC_PUBLIC, name, null, parent, null);
    how.accept(writer);
    writer.visitEnd();
    return writer.toByteArray();
  }

  private static List<String> refusals(byte[] file) {
    String name = new ClassReader(file).getClassName().replace('/', '.');
    return BytecodeVerifier.check(new TreeMap<>(Map.of(name, file))).stream()
        .map(BytecodeVerifier.Refusal::text)
        .distinct()
        .toList();
  }

  private static List<String> said(UserCodeFindings findings) {
    try {
      findings.throwIfAny();
      return List.of();
    } catch (MechmlException e) {
      return e.diagnostics().stream().map(Object::toString).toList();
    }
  }

  @MethodSource("escapes")
  @ParameterizedTest(name = "{0}")
  void everyWayOutIsRefused(String name, Consumer<ClassWriter> how) {
    assertThat(refusals(classFile("car/Push", OBJECT, how)))
        .as(name)
        .isNotEmpty()
        .allMatch(refusal -> refusal.contains("class car.Push"));
  }

  /** So the links above are refused for what is unusual about them. */
  @Test
  void linksAsTheCompilerWritesThemPass() {
    assertThat(
            refusals(
                classFile(
                    "car/Push",
                    OBJECT,
                    writer -> {
                      MethodVisitor code = writer.visitMethod(1, "apply", "()V", null, null);
                      code.visitCode();
                      code.visitInvokeDynamicInsn(
                          "get", "()Ljava/util/function/Supplier;", LAMBDA, GETS, OWN, GETS);
                      code.visitInvokeDynamicInsn(
                          "c", "()Ljava/lang/String;", CONCATENATION, "a\2", "b");
                      code.visitInvokeDynamicInsn(
                          "toString",
                          "(Lcar/Push;)Ljava/lang/String;",
                          RECORD,
                          PUSH,
                          "x",
                          new Handle(Opcodes.H_GETFIELD, "car/Push", "x", "D", false));
                      code.visitInsn(Opcodes.RETURN);
                      code.visitMaxs(9, 9);
                      code.visitEnd();
                    })))
        .isEmpty();
  }

  @ValueSource(
      strings = {
        "java/lang/Thread",
        "java/lang/ClassLoader",
        "java/lang/Process",
        "java/util/TimerTask",
        "java/io/ObjectInputStream",
        "java/security/Permission",
        "java/lang/invoke/MutableCallSite",
        "java/lang/ref/PhantomReference",
        "java/util/concurrent/RecursiveAction",
        "java/util/spi/LocaleServiceProvider",
      })
  @ParameterizedTest
  void noClassOfThePlatformThatReachesOutIsExtended(String parent) {
    assertThat(refusals(classFile("car/Push", parent, writer -> {}))).hasSize(1);
  }

  @ValueSource(
      strings = {
        "org/xml/sax/helpers/XMLReaderFactory",
        "org/w3c/dom/Node",
        "org/ietf/jgss/GSSManager",
        "netscape/javascript/JSObject",
        "org/jcp/xml/dsig/Own",
        "java/lang/Own",
        "javax/script/Own",
        "jdk/internal/Own",
        "sun/misc/Unsafe",
        "com/sun/net/httpserver/HttpServer",
        "org/omg/CORBA/ORB",
        "org/mechservice/solver/api/UserForce",
      })
  @ParameterizedTest
  void noClassHasANameThatJavaOrTheProductMayHave(String name) {
    UserCodeFindings findings = new UserCodeFindings();
    byte[] file = classFile(name, OBJECT, writer -> {});
    assertThat(UserClassFiles.of(List.of(new UserFile(name + ".class", file)), true, findings))
        .isEmpty();
    assertThat(said(findings))
        .singleElement()
        .asString()
        .contains("S-124")
        .contains("is in a package of Java or MechService");
  }

  @ValueSource(ints = {Opcodes.V1_1, Opcodes.V1_4, Opcodes.V1_6, Opcodes.V1_7, Opcodes.V18})
  @ParameterizedTest
  void noOtherVersionOfTheFormatIsTaken(int version) {
    ClassWriter writer = new ClassWriter(0);
    writer.visit(version, Opcodes.ACC_PUBLIC, "car/Push", null, OBJECT, null);
    writer.visitEnd();
    UserCodeFindings findings = new UserCodeFindings();
    UserClassFiles.of(
        List.of(new UserFile("car/Push.class", writer.toByteArray())), true, findings);
    assertThat(said(findings)).singleElement().asString().contains("javac --release 17");
  }

  /** If a name got through all the same, the given bytes would be found, not the platform's. */
  @Test
  void ownClassesAreTheGivenOnesAndOthersAreNowhere() throws Exception {
    String shadow = "org.xml.sax.InputSource";
    byte[] file = classFile(shadow.replace('.', '/'), OBJECT, writer -> {});
    UserClassLoader loader = new UserClassLoader(new TreeMap<>(Map.of(shadow, file)));
    assertThat(loader.loadClass(shadow).getClassLoader()).isSameAs(loader);
    for (String other :
        List.of("org.xml.sax.XMLReader", "javax.sql.DataSource", "sun.misc.Unsafe")) {
      assertThatThrownBy(() -> loader.loadClass(other)).isInstanceOf(ClassNotFoundException.class);
    }
    assertThat(loader.loadClass("java.util.ArrayList")).isSameAs(java.util.ArrayList.class);
  }
}
