package org.mechservice.sim.service.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.guard.Confinement;
import org.mechservice.guard.WorkerBounds;
import org.mechservice.guard.worker.WorkerLostException;
import org.mechservice.guard.worker.WorkerModel;
import org.mechservice.guard.worker.WorkerOrder;
import org.mechservice.guard.worker.WorkerProcess;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.sim.service.library.LoadedModel;
import org.mechservice.sim.service.run.EscapeCorpus.Way;
import org.mechservice.sim.user.PushedCart;
import org.mechservice.sim.user.UserFile;
import org.mechservice.solver.api.UserForce;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.ConstantDynamic;
import org.objectweb.asm.Handle;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/**
 * Each wall holds alone: every class of the corpus is refused by the first, and reaches nothing
 * from behind the second, whose worker gets it without a check.
 */
@Tag("soak")
class EscapeCorpusTest {
  private static final Path PAGE = Path.of("../../docs/reports/escape-corpus.md");
  private static final String SECRET = "SECRET";
  private static final WorkerBounds BOUNDS = new WorkerBounds(1 << 28, 60);
  private static final String REFUSAL = "S-156";
  private static final String RESERVED = "S-124";

  @TempDir Path folder;

  private final AtomicInteger connections = new AtomicInteger();
  private final List<String> lines = new ArrayList<>();

  /** What a class could do. */
  private record Reached(boolean something, String how) {}

  @Test
  void everyClassIsRefusedByTheFirstWallAndHarmlessBehindTheSecond() throws Exception {
    Confinement wall = Confinement.ofThisMachine();
    assumeTrue(wall.stands(), () -> "no confinement on this machine: " + wall.text());
    Confinement none = Confinement.none("for comparison");
    Map<Way, Map<String, byte[]>> corpus = compiled();
    assertThat(corpus).hasSizeGreaterThanOrEqualTo(60);
    WorkerOrder base = HarmlessRun.order();
    List<String> passed = new ArrayList<>();
    List<String> escaped = new ArrayList<>();
    int working = 0;
    try (ServerSocket port = new ServerSocket(0, 50, InetAddress.getLoopbackAddress())) {
      Thread counting = new Thread(() -> count(port));
      counting.setDaemon(true);
      counting.start();
      for (Map.Entry<Way, Map<String, byte[]>> way : corpus.entrySet()) {
        String name = way.getKey().kind() + ": " + way.getKey().name();
        String refusal = refusal(way.getValue());
        Reached outside = reached(way.getKey(), way.getValue(), none, base, port.getLocalPort());
        Reached inside = reached(way.getKey(), way.getValue(), wall, base, port.getLocalPort());
        working += outside.something() ? 1 : 0;
        if (refusal.isEmpty()) {
          passed.add(name);
        }
        if (inside.something()) {
          escaped.add(name + ": " + inside.how());
        }
        lines.add(
            "| %s | %s | %s | %s | %s |"
                .formatted(
                    way.getKey().kind(),
                    way.getKey().name(),
                    refusal,
                    outside.something() ? outside.how() : "-",
                    inside.something() ? inside.how() : "-"));
      }
    }
    assertThat(passed).as("let through by the first wall").isEmpty();
    assertThat(escaped).as("got out from behind the second wall").isEmpty();
    write(wall, corpus.size(), working);
  }

  private void write(Confinement wall, int size, int working) throws IOException {
    String head =
        String.format(
            Locale.ROOT,
            "# The corpus of escapes%n%n%d classes of users (`EscapeCorpus`) try to reach outside"
                + " of their run, each in another way: to make, spoil or read a file, to connect,"
                + " to start or end a process, to see what is not theirs. The first wall, the"
                + " allow-list of bytecode, refuses each of them; the table has the code. To try"
                + " the second wall alone, a worker gets each class without a check: in an ordinary"
                + " process, where %d of them reach what they try, and behind the confinement,"
                + " where none does. The other %d stay without effect in any process that has only"
                + " `java.base`.%n%nMeasured on %s by `mvn verify -Psoak`, without random choices:"
                + " %s; JDK %s, %s %s, %d processors.%n%n| kind | way | first wall | ordinary"
                + " process | second wall |%n|---|---|---|---|---|%n",
            size,
            working,
            size - working,
            LocalDate.now(ZoneOffset.UTC),
            wall.text(),
            Runtime.version(),
            System.getProperty("os.name"),
            System.getProperty("os.version"),
            Runtime.getRuntime().availableProcessors());
    Files.writeString(PAGE, head + String.join("\n", lines) + "\n");
  }

  private void count(ServerSocket port) {
    while (true) {
      try {
        port.accept().close();
        connections.incrementAndGet();
      } catch (IOException e) {
        return; // the test is over
      }
    }
  }

  // ---- the classes

  private Map<Way, Map<String, byte[]>> compiled() throws Exception {
    Map<Way, Map<String, byte[]>> all = new LinkedHashMap<>();
    for (Way way : EscapeCorpus.all()) {
      all.put(way, classFiles(way));
    }
    for (String how : List.of("loaded", "in a concatenation", "in a lambda")) {
      Way way =
          new Way(
              "dynamic constants",
              "a process as a constant " + how,
              "car.Escape.go();",
              "",
              "car.Escape",
              "public static void go() {}");
      Map<String, byte[]> files = classFiles(way);
      files.put("car.Escape", constants(how));
      all.put(way, files);
    }
    return all;
  }

  /** The paths of this test stand in the classes, so that each can be used in both processes. */
  private String filled(String text) {
    return text.replace("@MADE@", made().toString())
        .replace("@SECRET@", secret().toString())
        .replace("@VICTIM@", victim().toString())
        .replace("@FOLDER@", folder.toString());
  }

  private Path made() {
    return folder.resolve("made.txt");
  }

  private Path secret() {
    return folder.resolve("secret.txt");
  }

  private Path victim() {
    return folder.resolve("victim.txt");
  }

  /** Port and process are other ones each time; they are read from the class's own text. */
  private Map<String, byte[]> classFiles(Way way) throws IOException {
    return compile(way, 1, 1);
  }

  private Map<String, byte[]> compile(Way way, int port, long pid) throws IOException {
    Path sources = Files.createTempDirectory(folder, "src");
    Path classes = Files.createTempDirectory(folder, "classes");
    List<String> command =
        new ArrayList<>(
            List.of(
                "-proc:none",
                "-nowarn",
                "-Xlint:none",
                "--limit-modules",
                "java.base",
                "-cp",
                interfaceOfForces(),
                "-d",
                classes.toString()));
    Path push = Files.createDirectories(sources.resolve("car")).resolve("Push.java");
    Files.writeString(push, numbered(filled(way.source()), port, pid));
    command.add(push.toString());
    if (!way.made().isEmpty()) {
      Path beside = sources.resolve(way.made().replace('.', '/') + ".java");
      Files.createDirectories(beside.getParent());
      Files.writeString(beside, filled(way.besideSource()));
      command.add(beside.toString());
    }
    int status =
        ToolProvider.getSystemJavaCompiler()
            .run(null, null, System.err, command.toArray(String[]::new));
    assertThat(status).as(way.name()).isZero();
    try (Stream<Path> found = Files.walk(classes)) {
      Map<String, byte[]> files = new TreeMap<>();
      for (Path file : found.filter(Files::isRegularFile).toList()) {
        String name = classes.relativize(file).toString().replace(File.separatorChar, '.');
        files.put(name.substring(0, name.length() - ".class".length()), Files.readAllBytes(file));
      }
      return files;
    }
  }

  private static String numbered(String text, int port, long pid) {
    return text.replace("@PORT@", Integer.toString(port)).replace("@PID@", Long.toString(pid));
  }

  private static String interfaceOfForces() {
    try {
      return Path.of(UserForce.class.getProtectionDomain().getCodeSource().getLocation().toURI())
          .toString();
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }

  /** {@code Runtime.getRuntime().exec("touch ...")} as a constant within a constant. */
  private byte[] constants(String how) {
    String lookup = "(Ljava/lang/invoke/MethodHandles$Lookup;Ljava/lang/String;";
    Handle invoke =
        new Handle(
            Opcodes.H_INVOKESTATIC,
            "java/lang/invoke/ConstantBootstraps",
            "invoke",
            lookup
                + "Ljava/lang/Class;Ljava/lang/invoke/MethodHandle;[Ljava/lang/Object;)"
                + "Ljava/lang/Object;",
            false);
    Handle runtime =
        new Handle(
            Opcodes.H_INVOKESTATIC,
            "java/lang/Runtime",
            "getRuntime",
            "()Ljava/lang/Runtime;",
            false);
    Handle exec =
        new Handle(
            Opcodes.H_INVOKEVIRTUAL,
            "java/lang/Runtime",
            "exec",
            "(Ljava/lang/String;)Ljava/lang/Process;",
            false);
    ConstantDynamic process =
        new ConstantDynamic(
            "p",
            "Ljava/lang/Object;",
            invoke,
            exec,
            new ConstantDynamic("r", "Ljava/lang/Runtime;", invoke, runtime),
            "touch " + made());
    ClassWriter writer = new ClassWriter(0);
    writer.visit(Opcodes.V17, Opcodes.ACC_PUBLIC, "car/Escape", null, "java/lang/Object", null);
    MethodVisitor code =
        writer.visitMethod(Opcodes.ACC_PUBLIC | Opcodes.ACC_STATIC, "go", "()V", null, null);
    code.visitCode();
    if (how.equals("loaded")) {
      code.visitLdcInsn(process);
    } else if (how.equals("in a concatenation")) {
      code.visitInvokeDynamicInsn(
          "c",
          "()Ljava/lang/String;",
          new Handle(
              Opcodes.H_INVOKESTATIC,
              "java/lang/invoke/StringConcatFactory",
              "makeConcatWithConstants",
              lookup
                  + "Ljava/lang/invoke/MethodType;Ljava/lang/String;[Ljava/lang/Object;)"
                  + "Ljava/lang/invoke/CallSite;",
              false),
          "\2",
          process);
    } else {
      code.visitInvokeDynamicInsn(
          "get",
          "()Ljava/util/function/Supplier;",
          new Handle(
              Opcodes.H_INVOKESTATIC,
              "java/lang/invoke/LambdaMetafactory",
              "altMetafactory",
              lookup
                  + "Ljava/lang/invoke/MethodType;[Ljava/lang/Object;)"
                  + "Ljava/lang/invoke/CallSite;",
              false),
          process);
    }
    code.visitInsn(Opcodes.POP);
    code.visitInsn(Opcodes.RETURN);
    code.visitMaxs(1, 0);
    code.visitEnd();
    writer.visitEnd();
    return writer.toByteArray();
  }

  // ---- the first wall

  /** Returns the codes with which the first wall refuses the classes; empty if it does not. */
  private static String refusal(Map<String, byte[]> files) throws IOException {
    List<UserFile> sent =
        files.entrySet().stream()
            .map(file -> new UserFile(file.getKey().replace('.', '/') + ".class", file.getValue()))
            .toList();
    try {
      LoadedModel.read("pushed.xml", PushedCart.file(), sent, true).userClasses().requireHarmless();
      return "";
    } catch (MechmlException e) {
      return e.diagnostics().stream()
          .map(Object::toString)
          .flatMap(text -> Stream.of(REFUSAL, RESERVED).filter(text::contains))
          .collect(Collectors.toCollection(TreeSet::new))
          .stream()
          .collect(Collectors.joining(", "));
    }
  }

  // ---- the second wall

  private Reached reached(
      Way way, Map<String, byte[]> files, Confinement confinement, WorkerOrder base, int port)
      throws Exception {
    Files.deleteIfExists(made());
    Files.writeString(secret(), SECRET);
    Files.deleteIfExists(victim());
    Files.writeString(victim(), "whole");
    connections.set(0);
    Process other = new ProcessBuilder("sleep", "600").start();
    try {
      Map<String, byte[]> used = new TreeMap<>(files);
      if (way.source().matches("(?s).*@(PORT|PID)@.*")) {
        used.putAll(compile(way, port, other.pid()));
      }
      String said = run(with(base, used), confinement);
      Thread.sleep(50);
      List<String> done = new ArrayList<>();
      if (Files.exists(made(), LinkOption.NOFOLLOW_LINKS)) {
        done.add("makes a file");
      }
      if (!Files.exists(victim()) || !Files.readString(victim()).equals("whole")) {
        done.add("spoils a file");
      }
      if (said.contains(SECRET) || said.contains("secret.txt")) {
        done.add("sees what is not its own");
      }
      if (connections.get() > 0) {
        done.add("connects");
      }
      if (!other.isAlive()) {
        done.add("ends a process");
      }
      return new Reached(!done.isEmpty(), String.join(", ", done));
    } finally {
      other.destroyForcibly();
    }
  }

  private static WorkerOrder with(WorkerOrder base, Map<String, byte[]> classes) {
    return new WorkerOrder(
        new WorkerModel(
            base.model().className(), base.model().classFiles(), new TreeMap<>(classes)),
        base.values(),
        base.request());
  }

  /** Returns the outcome, in words. */
  private static String run(WorkerOrder order, Confinement confinement) throws IOException {
    try {
      return HarmlessRun.report(order, new WorkerProcess(confinement, BOUNDS)).outcome().toString();
    } catch (WorkerLostException | IllegalArgumentException e) {
      return String.valueOf(e.getMessage());
    }
  }
}
