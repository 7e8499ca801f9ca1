package org.mechservice.sim.service.run;

import java.util.ArrayList;
import java.util.List;

/**
 * Classes of users that try to reach outside of their run, each in another way: sources of the body
 * of one method, with the members and classes that it needs. In them {@code @MADE@} is a file to
 * make, {@code @SECRET@} one to read, {@code @VICTIM@} one to spoil, {@code @FOLDER@} their folder,
 * {@code @PORT@} a port of the loopback interface, and {@code @PID@} another process.
 */
final class EscapeCorpus {
  private static final String WRITES =
      "java.nio.file.Files.writeString(java.nio.file.Path.of(\"@MADE@\"), \"x\");";

  /** The same where no checked exception may be thrown. */
  private static final String QUIETLY =
      "try { " + WRITES + " } catch (java.io.IOException e) { leaked += \"\"; }";

  private static final String WAITS = " Thread.sleep(300);";

  /**
   * One way.
   *
   * @param kind of what Java offers
   * @param body statements that may throw anything; what they put into {@code leaked} is seen
   * @param members of the class besides
   * @param made name of a class {@code Escape} beside it, of the members {@code beside}; empty if
   *     there is none
   */
  record Way(String kind, String name, String body, String members, String made, String beside) {
    String source() {
      return """
      package car;

      import org.mechservice.solver.api.ForceDeclaration;
      import org.mechservice.solver.api.ForceLoads;
      import org.mechservice.solver.api.ForceState;
      import org.mechservice.solver.api.UserForce;

      public class Push implements UserForce {
        public static volatile String leaked = "";
        private static boolean tried;
        private int slide;

      %s

        public void declare(ForceDeclaration model) {
          slide = model.coordinate("slide", 0);
        }

        static void attempt() throws Throwable {
          %s
        }

        public void apply(ForceState state, ForceLoads loads) {
          if (!tried) {
            tried = true;
            try {
              attempt();
            } catch (Throwable e) {
              slide += 0;
            }
          }
          if (!leaked.isEmpty()) {
            throw new IllegalStateException("leaked " + leaked);
          }
          loads.addJointForce(slide, 3);
        }
      }
      """
          .formatted(members, body);
    }

    /** Returns the source of the class beside it. */
    String besideSource() {
      int dot = made.lastIndexOf('.');
      return "package %s; public class %s { %s }"
          .formatted(made.substring(0, dot), made.substring(dot + 1), beside);
    }
  }

  private final List<Way> ways = new ArrayList<>();

  private EscapeCorpus() {}

  /** Returns all ways. */
  static List<Way> all() {
    EscapeCorpus corpus = new EscapeCorpus();
    corpus.addFiles();
    corpus.addReads();
    corpus.addNetwork();
    corpus.addProcesses();
    corpus.addReflection();
    corpus.addHandles();
    corpus.addSerialisation();
    corpus.addNative();
    corpus.addThreads();
    corpus.addEnds();
    corpus.addInitialisers();
    corpus.addLoaders();
    corpus.addShadows();
    corpus.addSystem();
    return List.copyOf(corpus.ways);
  }

  private void add(String kind, String name, String body) {
    add(kind, name, body, "");
  }

  private void add(String kind, String name, String body, String members) {
    ways.add(new Way(kind, name, body, members, "", ""));
  }

  private void addBeside(String kind, String name, String made) {
    ways.add(
        new Way(
            kind,
            name,
            made + ".go();",
            "",
            made,
            "public static void go() throws Exception { " + WRITES + " }"));
  }

  private void addFiles() {
    String kind = "files";
    add(kind, "Files.writeString", WRITES);
    add(kind, "FileOutputStream", "new java.io.FileOutputStream(\"@MADE@\").close();");
    add(kind, "RandomAccessFile", "new java.io.RandomAccessFile(\"@MADE@\", \"rw\").close();");
    add(kind, "File.createNewFile", "new java.io.File(\"@MADE@\").createNewFile();");
    add(kind, "FileWriter", "new java.io.FileWriter(\"@MADE@\").close();");
    add(kind, "PrintStream", "new java.io.PrintStream(\"@MADE@\").close();");
    add(
        kind,
        "FileChannel.open",
        "java.nio.channels.FileChannel.open(java.nio.file.Path.of(\"@MADE@\"),"
            + " java.nio.file.StandardOpenOption.CREATE,"
            + " java.nio.file.StandardOpenOption.WRITE).close();");
    add(
        kind,
        "a symbolic link",
        "java.nio.file.Files.createSymbolicLink(java.nio.file.Path.of(\"@MADE@\"),"
            + " java.nio.file.Path.of(\"@SECRET@\"));");
    add(
        kind,
        "a copy of another file",
        "java.nio.file.Files.copy(java.nio.file.Path.of(\"@SECRET@\"),"
            + " java.nio.file.Path.of(\"@MADE@\"));");
    add(kind, "deletion", "java.nio.file.Files.delete(java.nio.file.Path.of(\"@VICTIM@\"));");
    add(kind, "renaming", "new java.io.File(\"@VICTIM@\").renameTo(new java.io.File(\"@MADE@\"));");
    add(kind, "cutting short", "new java.io.FileOutputStream(\"@VICTIM@\").close();");
  }

  private void addReads() {
    String kind = "reading";
    add(
        kind,
        "Files.readString",
        "leaked = java.nio.file.Files.readString(java.nio.file.Path.of(\"@SECRET@\"));");
    add(
        kind,
        "FileInputStream",
        "leaked = new String(new java.io.FileInputStream(\"@SECRET@\").readAllBytes());");
    add(kind, "Scanner", "leaked = new java.util.Scanner(new java.io.File(\"@SECRET@\")).next();");
    add(
        kind,
        "a file as URL",
        "leaked = new String(new java.net.URL(\"file:@SECRET@\").openStream().readAllBytes());");
    add(
        kind,
        "a mapped file",
        "var c = java.nio.channels.FileChannel.open(java.nio.file.Path.of(\"@SECRET@\"));"
            + " leaked = java.nio.charset.StandardCharsets.UTF_8.decode("
            + "c.map(java.nio.channels.FileChannel.MapMode.READ_ONLY, 0, c.size())).toString();");
    add(
        kind,
        "names in a folder",
        "leaked = java.util.List.of(new java.io.File(\"@FOLDER@\").list())"
            + ".contains(\"secret.txt\") ? \"SECRET\" : \"\";");
    add(
        kind,
        "a tree of folders",
        "leaked = java.nio.file.Files.walk(java.nio.file.Path.of(\"@FOLDER@\"))"
            + ".anyMatch(p -> p.endsWith(\"secret.txt\")) ? \"SECRET\" : \"\";");
    add(
        kind,
        "Properties of a file",
        "var p = new java.util.Properties(); p.load(new java.io.FileReader(\"@SECRET@\"));"
            + " leaked = p.toString();");
  }

  private void addNetwork() {
    String kind = "network";
    add(kind, "Socket", "new java.net.Socket(\"127.0.0.1\", @PORT@).close();");
    add(
        kind,
        "SocketChannel",
        "java.nio.channels.SocketChannel.open(new java.net.InetSocketAddress(\"127.0.0.1\","
            + " @PORT@)).close();");
    add(
        kind,
        "AsynchronousSocketChannel",
        "java.nio.channels.AsynchronousSocketChannel.open().connect("
            + "new java.net.InetSocketAddress(\"127.0.0.1\", @PORT@)).get();");
    add(
        kind,
        "a page of the web",
        "var u = new java.net.URL(\"http://127.0.0.1:@PORT@/\").openConnection();"
            + " u.setReadTimeout(100); u.getInputStream();");
    add(
        kind,
        "a proxy",
        "new java.net.Socket(new java.net.Proxy(java.net.Proxy.Type.SOCKS,"
            + " new java.net.InetSocketAddress(\"127.0.0.1\", @PORT@))).connect("
            + "new java.net.InetSocketAddress(\"192.0.2.1\", 80), 200);");
  }

  private void addProcesses() {
    String kind = "processes";
    add(kind, "Runtime.exec", "Runtime.getRuntime().exec(\"touch @MADE@\").waitFor();");
    add(kind, "ProcessBuilder", "new ProcessBuilder(\"touch\", \"@MADE@\").start().waitFor();");
    add(
        kind,
        "output of a process to a file",
        "new ProcessBuilder(\"echo\").redirectOutput(new java.io.File(\"@MADE@\")).start();");
    add(
        kind,
        "a pipeline",
        "ProcessBuilder.startPipeline(java.util.List.of(new ProcessBuilder(\"echo\"),"
            + " new ProcessBuilder(\"tee\", \"@MADE@\"))).get(1).waitFor();");
    add(
        kind,
        "the end of another process",
        "ProcessHandle.of(@PID@L).ifPresent(ProcessHandle::destroyForcibly);" + WAITS);
  }

  private void addReflection() {
    String kind = "reflection";
    String runtime = "Class.forName(\"java.lang.Runtime\")";
    add(
        kind,
        "Method.invoke",
        "var r = "
            + runtime
            + "; var o = r.getMethod(\"getRuntime\").invoke(null);"
            + " ((Process) r.getMethod(\"exec\", String.class).invoke(o, \"touch @MADE@\"))"
            + ".waitFor();");
    add(
        kind,
        "Constructor.newInstance",
        "Class.forName(\"java.io.FileOutputStream\").getConstructor(String.class)"
            + ".newInstance(\"@MADE@\");");
    add(
        kind,
        "getClass of an object",
        "leaked = (String) \"\".getClass().getClassLoader().getClass().getMethod(\"x\")"
            + ".invoke(null);");
    add(
        kind,
        "a dynamic proxy",
        "((Runnable) java.lang.reflect.Proxy.newProxyInstance(Push.class.getClassLoader(),"
            + " new Class<?>[] {Runnable.class}, (p, m, a) -> { "
            + WRITES
            + " return null; })).run();");
    add(
        kind,
        "fields that Java keeps closed",
        "var f = ProcessBuilder.class.getDeclaredField(\"command\"); f.setAccessible(true);"
            + " var b = new ProcessBuilder(); f.set(b, java.util.List.of(\"touch\", \"@MADE@\"));"
            + " b.start();");
    add(
        kind,
        "memory without bounds",
        "var f = Class.forName(\"sun.misc.Unsafe\").getDeclaredField(\"theUnsafe\");"
            + " f.setAccessible(true); f.get(null).hashCode(); "
            + WRITES);
  }

  private void addHandles() {
    String kind = "method handles";
    add(
        kind,
        "findStatic",
        "java.lang.invoke.MethodHandles.lookup().findStatic(java.nio.file.Files.class,"
            + " \"writeString\", java.lang.invoke.MethodType.methodType(java.nio.file.Path.class,"
            + " java.nio.file.Path.class, CharSequence.class, java.nio.file.OpenOption[].class))"
            + ".invoke(java.nio.file.Path.of(\"@MADE@\"), \"x\");");
    add(
        kind,
        "findConstructor",
        "java.lang.invoke.MethodHandles.lookup().findConstructor(java.io.FileOutputStream.class,"
            + " java.lang.invoke.MethodType.methodType(void.class, String.class))"
            + ".invoke(\"@MADE@\");");
    add(
        kind,
        "unreflect",
        "java.lang.invoke.MethodHandles.lookup().unreflect("
            + "java.io.File.class.getMethod(\"createNewFile\"))"
            + ".invoke(new java.io.File(\"@MADE@\"));");
    add(
        kind,
        "a method reference",
        "java.util.concurrent.Callable<Boolean> c = new java.io.File(\"@MADE@\")::createNewFile;"
            + " c.call();");
    add(
        kind,
        "a constructor reference",
        "java.util.function.Function<String, java.io.File> f = java.io.File::new;"
            + " f.apply(\"@MADE@\").createNewFile();");
    add(
        kind,
        "a lambda factory called by hand",
        "var l = java.lang.invoke.MethodHandles.lookup(); var t ="
            + " java.lang.invoke.MethodType.methodType(boolean.class); ((java.util.function"
            + ".BooleanSupplier) java.lang.invoke.LambdaMetafactory.metafactory(l,"
            + " \"getAsBoolean\", java.lang.invoke.MethodType.methodType("
            + "java.util.function.BooleanSupplier.class, java.io.File.class), t,"
            + " l.findVirtual(java.io.File.class, \"createNewFile\", t), t).getTarget()"
            + ".invoke(new java.io.File(\"@MADE@\"))).getAsBoolean();");
  }

  private void addSerialisation() {
    String kind = "deserialisation";
    String through =
        "var b = new java.io.ByteArrayOutputStream(); var o = new java.io.ObjectOutputStream(b);"
            + " o.writeObject(new Own()); o.flush(); new java.io.ObjectInputStream("
            + "new java.io.ByteArrayInputStream(b.toByteArray())).readObject();";
    add(
        kind,
        "readObject",
        through,
        "static class Own implements java.io.Serializable { private void"
            + " readObject(java.io.ObjectInputStream in) throws java.io.IOException { "
            + WRITES
            + " } }");
    add(
        kind,
        "readResolve",
        through,
        "static class Own implements java.io.Serializable { private Object readResolve() { "
            + QUIETLY
            + " return this; } }");
    add(
        kind,
        "Externalizable",
        through,
        "public static class Own implements java.io.Externalizable { public Own() {} public void"
            + " writeExternal(java.io.ObjectOutput out) {} public void"
            + " readExternal(java.io.ObjectInput in) throws java.io.IOException { "
            + WRITES
            + " } }");
  }

  private void addNative() {
    String kind = "native code";
    add(kind, "a native method", "own();", "static native void own();");
    add(
        kind,
        "a library",
        "java.nio.file.Files.copy(java.nio.file.Path.of(\"@SECRET@\"),"
            + " java.nio.file.Path.of(\"@MADE@\")); System.load(\"@MADE@\");");
    add(kind, "a library of Java", "System.loadLibrary(\"net\"); " + WRITES);
  }

  private void addThreads() {
    String kind = "threads";
    add(kind, "Thread", "new Thread(() -> { " + QUIETLY + " }).start();" + WAITS);
    add(
        kind,
        "a subclass of Thread",
        "new Own().start();" + WAITS,
        "static class Own extends Thread { public void run() { " + QUIETLY + " } }");
    add(
        kind,
        "a pool",
        "java.util.concurrent.Executors.newSingleThreadExecutor().submit(() -> "
            + WRITES.replace(";", "")
            + ").get();");
    add(
        kind,
        "the common pool",
        "java.util.concurrent.CompletableFuture.runAsync(() -> { " + QUIETLY + " }).get();");
    add(
        kind,
        "a parallel stream",
        "java.util.stream.IntStream.range(0, 2).parallel().forEach(i -> { " + QUIETLY + " });");
    add(
        kind,
        "a timer",
        "new java.util.Timer(true).schedule(new java.util.TimerTask() { public void run() { "
            + QUIETLY
            + " } }, 1);"
            + WAITS);
    add(
        kind,
        "a handler of uncaught exceptions",
        "var t = new Thread(() -> { throw new IllegalStateException(); });"
            + " t.setUncaughtExceptionHandler((a, b) -> { "
            + QUIETLY
            + " }); t.start();"
            + WAITS);
  }

  private void addEnds() {
    String kind = "ends of objects and processes";
    add(
        kind,
        "a finalizer",
        "new Own(); for (int i = 0; i < 5; i++) { System.gc(); Thread.sleep(60); }",
        "static class Own { @Override protected void finalize() { " + QUIETLY + " } }");
    add(
        kind,
        "a cleaner",
        "java.lang.ref.Cleaner.create().register(new Object(), () -> { "
            + QUIETLY
            + " }); for (int i = 0; i < 5; i++) { System.gc(); Thread.sleep(60); }");
    add(
        kind,
        "a hook at the end",
        "Runtime.getRuntime().addShutdownHook(new Thread(() -> { "
            + QUIETLY
            + " })); System.exit(0);");
    add(
        kind,
        "deletion at the end",
        "new java.io.File(\"@VICTIM@\").deleteOnExit(); System.exit(0);");
  }

  private void addInitialisers() {
    String kind = "initialisers";
    add(kind, "a static initialiser", "", "static { " + QUIETLY + " }");
    add(
        kind,
        "a static initialiser of a nested class",
        "Own.touch();",
        "static class Own { static { " + QUIETLY + " } static void touch() {} }");
    add(kind, "an instance initialiser", "", "{ " + QUIETLY + " }");
    add(
        kind,
        "a constant of an enumeration",
        "Own.ONE.name();",
        "enum Own { ONE; Own() { " + QUIETLY + " } }");
    add(
        kind,
        "a field of an interface",
        "Own.MADE.hashCode();",
        "interface Own { Object MADE = make(); static Object make() { "
            + QUIETLY
            + " return 1; } }");
    add(
        kind,
        "the constructor of a record",
        "new Own(1);",
        "record Own(int x) { Own { " + QUIETLY + " } }");
  }

  private void addLoaders() {
    String kind = "class loaders and services";
    add(
        kind,
        "a service loader",
        "java.util.ServiceLoader.load(java.nio.file.spi.FileSystemProvider.class).findFirst(); "
            + WRITES);
    add(
        kind,
        "an installed provider",
        "java.nio.file.spi.FileSystemProvider.installedProviders().get(0).newOutputStream("
            + "java.nio.file.Path.of(\"@MADE@\")).close();");
    add(
        kind,
        "a class loader of its own",
        "new Own().find().getMethod(\"getRuntime\").invoke(null); " + WRITES,
        "static class Own extends ClassLoader { Class<?> find() throws Exception { return"
            + " findSystemClass(\"java.lang.Runtime\"); } }");
    add(
        kind,
        "resources of a folder",
        "leaked = new String(new java.net.URLClassLoader(new java.net.URL[] {"
            + "new java.net.URL(\"file:@FOLDER@/\")}).getResourceAsStream(\"secret.txt\")"
            + ".readAllBytes());");
    add(
        kind,
        "the loader of the system",
        "ClassLoader.getSystemClassLoader().loadClass(\"java.io.File\")"
            + ".getConstructor(String.class).newInstance(\"@MADE@\").getClass()"
            + ".getMethod(\"createNewFile\").invoke(new java.io.File(\"@MADE@\"));");
    add(
        kind,
        "a hidden class",
        "var l = java.lang.invoke.MethodHandles.lookup();"
            + " l.defineHiddenClass(Push.class.getResourceAsStream(\"Push.class\").readAllBytes(),"
            + " true); "
            + WRITES);
  }

  private void addShadows() {
    String kind = "shadowed names";
    for (String made :
        List.of(
            "org.xml.sax.Escape",
            "org.w3c.dom.Escape",
            "org.ietf.jgss.Escape",
            "netscape.javascript.Escape",
            "javax.sql.Escape",
            "com.sun.net.httpserver.Escape",
            "org.mechservice.solver.simulation.Escape")) {
      addBeside(kind, made, made);
    }
  }

  private void addSystem() {
    String kind = "the system";
    add(
        kind,
        "the environment of the host",
        "leaked = new java.io.FileInputStream(\"/proc/\" +"
            + " ProcessHandle.current().parent().get().pid() + \"/environ\").readAllBytes().length"
            + " > 0 ? \"SECRET\" : \"\";");
    add(
        kind,
        "rights of a file",
        "if (new java.io.File(\"@VICTIM@\").setWritable(false) && new"
            + " java.io.File(\"@VICTIM@\").setLastModified(0)) { leaked = \"SECRET\"; }");
    add(
        kind,
        "all processes",
        "leaked = ProcessHandle.allProcesses().anyMatch(p -> p.pid() == @PID@L) ? \"SECRET\" :"
            + " \"\";");
    add(
        kind,
        "space on the disk",
        "leaked = new java.io.File(\"@FOLDER@\").getTotalSpace() > 0 ? \"SECRET\" : \"\";");
  }
}
