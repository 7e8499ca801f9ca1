package org.mechservice.guard;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Handle;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/** What a class file of a user may call, one member of Java after the other. */
class BytecodeVerifierTest {
  private static final String OBJECT = "java/lang/Object";

  /** Writes the code of a method that uses something. */
  private interface Use {
    void in(MethodVisitor code);
  }

  private static List<String> refusals(String superName, Use use) {
    ClassWriter writer = new ClassWriter(0);
    writer.visit(Opcodes.V17, Opcodes.ACC_PUBLIC, "car/Push", null, superName, null);
    MethodVisitor code = writer.visitMethod(Opcodes.ACC_PUBLIC, "apply", "()V", null, null);
    code.visitCode();
    use.in(code);
    code.visitInsn(Opcodes.RETURN);
    code.visitMaxs(9, 9);
    code.visitEnd();
    return refusalsOf(writer);
  }

  private static List<String> refusalsOfCall(String owner, String name) {
    return refusals(
        OBJECT, code -> code.visitMethodInsn(Opcodes.INVOKEVIRTUAL, owner, name, "()V", false));
  }

  /** A method reference, as in {@code Runnable r = this::name}. */
  private static List<String> refusalsOfReference(String owner, String name) {
    Handle lambda =
        new Handle(
            Opcodes.H_INVOKESTATIC,
            "java/lang/invoke/LambdaMetafactory",
            "metafactory",
            "(Ljava/lang/invoke/MethodHandles$Lookup;Ljava/lang/String;"
                + "Ljava/lang/invoke/MethodType;Ljava/lang/invoke/MethodType;"
                + "Ljava/lang/invoke/MethodHandle;Ljava/lang/invoke/MethodType;)"
                + "Ljava/lang/invoke/CallSite;",
            false);
    return refusals(
        OBJECT,
        code ->
            code.visitInvokeDynamicInsn(
                "get",
                "()Ljava/util/function/Supplier;",
                lambda,
                Type.getMethodType("()Ljava/lang/Object;"),
                new Handle(Opcodes.H_INVOKEVIRTUAL, owner, name, "()V", false),
                Type.getMethodType("()Ljava/lang/Object;")));
  }

  private static Set<String> forbidden() {
    return AllowedJava.forbiddenMembers();
  }

  private static String owner(String member) {
    return member.substring(0, member.indexOf('.'));
  }

  private static String name(String member) {
    return member.substring(member.indexOf('.') + 1);
  }

  /** A name that is misspelt would protect from nothing. */
  @MethodSource("forbidden")
  @ParameterizedTest
  void forbiddenMemberIsOneOfJava(String member) throws Exception {
    Class<?> owner = Class.forName(owner(member).replace('/', '.'));
    assertThat(
            Stream.of(owner.getMethods(), owner.getDeclaredMethods())
                .flatMap(Arrays::stream)
                .map(Method::getName))
        .contains(name(member));
    assertThat(AllowedJava.isClass(owner(member))).isTrue();
  }

  @MethodSource("forbidden")
  @ParameterizedTest
  void forbiddenMemberIsNotCalled(String member) {
    assertThat(refusalsOfCall(owner(member), name(member)))
        .singleElement()
        .asString()
        .contains("method apply: it calls " + member.replace('/', '.'));
  }

  @MethodSource("forbidden")
  @ParameterizedTest
  void forbiddenMemberIsNotReferredTo(String member) {
    assertThat(refusalsOfReference(owner(member), name(member)))
        .singleElement()
        .asString()
        .contains("it refers to " + member.replace('/', '.'));
  }

  @MethodSource("forbidden")
  @ParameterizedTest
  void forbiddenMemberIsNotCalledThroughAClassThatInheritsIt(String member) {
    assertThat(refusalsOfCall("java/util/ArrayList", name(member))).hasSize(1);
    assertThat(refusalsOfCall("car/Push", name(member))).hasSize(1);
  }

  @ValueSource(
      strings = {
        "java/lang/System.exit",
        "java/lang/System.getProperty",
        "java/lang/System.getenv",
        "java/lang/System.load",
        "java/lang/System.setOut",
        "java/lang/System.gc",
        "java/lang/Runtime.getRuntime",
        "java/lang/Runtime.exec",
        "java/lang/ProcessBuilder.start",
        "java/lang/ProcessHandle.current",
        "java/lang/Thread.start",
        "java/lang/Thread.sleep",
        "java/lang/ThreadLocal.get",
        "java/lang/Class.forName",
        "java/lang/Class.getMethods",
        "java/lang/Class.getClassLoader",
        "java/lang/ClassLoader.getSystemClassLoader",
        "java/lang/Module.addOpens",
        "java/lang/StackWalker.getInstance",
        "java/lang/reflect/Method.invoke",
        "java/lang/reflect/Proxy.newProxyInstance",
        "java/lang/invoke/MethodHandles.lookup",
        "java/lang/ref/Cleaner.create",
        "java/io/File.delete",
        "java/io/FileInputStream.read",
        "java/io/PrintStream.println",
        "java/io/ObjectInputStream.readObject",
        "java/nio/file/Files.readAllBytes",
        "java/nio/ByteBuffer.allocateDirect",
        "java/net/Socket.connect",
        "java/net/URL.openStream",
        "java/net/InetAddress.getByName",
        "java/util/ServiceLoader.load",
        "java/util/Scanner.next",
        "java/util/Formatter.close",
        "java/util/Timer.schedule",
        "java/util/ResourceBundle.getBundle",
        "java/util/Properties.load",
        "java/util/Locale.setDefault",
        "java/util/TimeZone.setDefault",
        "java/util/concurrent/ForkJoinPool.commonPool",
        "java/util/concurrent/CompletableFuture.runAsync",
        "java/util/logging/Logger.getLogger",
        "java/util/zip/ZipFile.entries",
        "java/security/Security.getProviders",
        "javax/script/ScriptEngineManager.getEngineByName",
        "sun/misc/Unsafe.allocateMemory",
        "jdk/internal/misc/Unsafe.allocateMemory",
        "org/mechservice/orb/ServiceOrb.client",
      })
  @ParameterizedTest
  void whatReachesOutOfTheModelIsNotCalled(String member) {
    assertThat(refusalsOfCall(owner(member), name(member))).isNotEmpty();
    assertThat(refusalsOfReference(owner(member), name(member))).isNotEmpty();
  }

  private static Stream<String> membersThatRunInParallel() throws ClassNotFoundException {
    Stream.Builder<String> members = Stream.builder();
    for (String owner : AllowedJava.classes()) {
      for (Method method : classNamed(owner).getMethods()) {
        if (method.getName().startsWith("parallel")) {
          members.add(owner + "." + method.getName());
        }
      }
    }
    return members.build().distinct();
  }

  private static Class<?> classNamed(String internalName) throws ClassNotFoundException {
    String name = internalName.replace('/', '.');
    // Java 21 brought it; files compiled for 17 do not name it.
    return name.equals("java.lang.MatchException") ? Object.class : Class.forName(name);
  }

  /** The list of forbidden members is complete in this. */
  @MethodSource("membersThatRunInParallel")
  @ParameterizedTest
  void nothingOfTheAllowedClassesStartsThreads(String member) {
    assertThat(refusalsOfCall(owner(member), name(member))).hasSize(1);
  }

  /** A member that hands out what is not allowed is useless: what it hands out cannot be called. */
  @Test
  void classObjectIsHandedOutButOpensNothing() {
    assertThat(refusalsOfCall(OBJECT, "getClass")).isEmpty();
    assertThat(refusalsOfCall("java/lang/Class", "getSimpleName")).isEmpty();
    assertThat(refusalsOfCall("java/lang/Class", "getConstructors")).hasSize(1);
  }

  @Test
  void numbersTextsAndCollectionsAreCalledFreely() {
    for (String member :
        List.of(
            "java/lang/Math.sin",
            "java/lang/StringBuilder.append",
            "java/util/ArrayList.add",
            "java/util/stream/DoubleStream.sum",
            "java/lang/System.arraycopy")) {
      assertThat(refusalsOfCall(owner(member), name(member))).as(member).isEmpty();
    }
  }

  @Test
  void parentsFieldsAndConstantsAreLookedAtToo() {
    assertThat(refusals("java/lang/Thread", code -> {})).hasSize(1);
    assertThat(
            refusals(
                OBJECT,
                code ->
                    code.visitFieldInsn(
                        Opcodes.GETSTATIC, "java/lang/System", "out", "Ljava/io/PrintStream;")))
        .hasSize(1);
    assertThat(
            refusals(
                OBJECT, code -> code.visitLdcInsn(Type.getObjectType("java/lang/ProcessBuilder"))))
        .hasSize(1);
    assertThat(refusals(OBJECT, code -> code.visitTypeInsn(Opcodes.NEW, "java/io/File")))
        .hasSize(1);
  }

  /** The class file names an array type as the owner, and the member is the one of Object. */
  @Test
  void arrayGivesNoWayToForbiddenMembersOfObject() {
    assertThat(refusalsOfCall("[Ljava/lang/Object;", "wait")).hasSize(1);
    assertThat(refusalsOfCall("[Ljava/lang/Thread;", "clone")).hasSize(1);
    assertThat(refusalsOfCall("[D", "clone")).isEmpty();
    assertThat(refusalsOfCall("[D", "getClass")).isEmpty();
  }

  /**
   * Java computes a constant when something uses it; the pool is checked whether or not it does.
   */
  @Test
  void kindOfConstantThatIsNotListedIsRefusedWithoutAnyUse() {
    ClassWriter writer = new ClassWriter(0);
    writer.visit(Opcodes.V17, Opcodes.ACC_PUBLIC, "car/Push", null, OBJECT, null);
    writer.newConstantDynamic(
        "zero",
        "I",
        new Handle(Opcodes.H_INVOKESTATIC, "java/lang/Runtime", "getRuntime", "()V", false));
    assertThat(refusalsOf(writer))
        .singleElement()
        .asString()
        .contains("it has a constant of the kind 17");
  }

  @Test
  void classFileWithPreviewFeaturesIsRefused() {
    ClassWriter writer = new ClassWriter(0);
    writer.visit(
        Opcodes.V17 | Opcodes.V_PREVIEW, Opcodes.ACC_PUBLIC, "car/Push", null, OBJECT, null);
    assertThat(refusalsOf(writer)).singleElement().asString().contains("preview features");
  }

  private static List<String> refusalsOf(ClassWriter writer) {
    writer.visitEnd();
    return BytecodeVerifier.check(new TreeMap<>(Map.of("car.Push", writer.toByteArray()))).stream()
        .map(BytecodeVerifier.Refusal::text)
        .distinct()
        .toList();
  }
}
