package org.mechservice.guard;

import java.io.File;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * The sandbox that the operating system puts around a worker: bubblewrap with a filter of system
 * calls. A worker behind it has no network, sees no files but those of Java and its class path, can
 * write nowhere, starts no processes and has no rights; its address space and processor time are
 * bounded by the kernel. Behind it, Java's {@link JavaFiles} are all there is.
 *
 * <p>A wall counts only if it holds: before its first use {@link ConfinementProbe} tries to get out
 * of it. Does not support systems other than Linux on x86-64 and AArch64.
 */
public final class Confinement {
  /** Most that Java takes beside its heap: code, classes, stacks, the collector, B. */
  private static final long BESIDE_HEAP = 1L << 30;

  private static final long PROBE_SECONDS = 60;
  private static final int PROBE_OUTPUT = 10_000;
  private static final long ENDING_SECONDS = 10;

  /** What a wall says before the name of its machine, which no other wall has. */
  private static final String NAME = "--hostname";

  private static final Path PROCESSES = Path.of("/proc");
  private static final String WALL_SHELL = "/bin/sh";

  /**
   * Sets the bounds of the kernel and opens the filter, then becomes what its arguments say, with
   * no environment: the shell has put the working folder into its own, which a worker can read of
   * its parent.
   */
  private static final String SHELL =
      "ulimit -c 0 && ulimit -v \"$1\" && ulimit -t \"$2\" && exec 3<\"$3\" && rm -f -- \"$3\""
          + " && shift 3 && exec /usr/bin/env -i \"$@\"";

  private static final List<String> ISOLATION =
      List.of(
          "--unshare-user",
          "--unshare-ipc",
          "--unshare-pid",
          "--unshare-net",
          "--unshare-uts",
          "--unshare-cgroup-try",
          "--cap-drop",
          "ALL",
          "--uid",
          "65534",
          "--gid",
          "65534",
          "--die-with-parent",
          "--new-session",
          "--clearenv",
          // Else each thread reserves address space of its own for small blocks.
          "--setenv",
          "MALLOC_ARENA_MAX",
          "2",
          "--proc",
          "/proc",
          // Else a worker of root could set parameters of the kernel below /proc/sys.
          "--remount-ro",
          "/proc",
          "--dev-bind",
          "/dev/null",
          "/dev/null",
          "--dev-bind",
          "/dev/random",
          "/dev/random",
          "--dev-bind",
          "/dev/urandom",
          "/dev/urandom");

  /** One probe per process. */
  private static final class OfThisMachine {
    static final Confinement PROBED = probe(System.getProperty("java.class.path"));
  }

  /** A tool that stands on this machine. */
  private record Wall(Path tool, SystemCallFilter filter, JavaFiles files) {}

  /** A process behind the wall ends with the thread that starts it; this one stays. */
  private static final ExecutorService STARTER =
      Executors.newSingleThreadExecutor(
          task -> {
            Thread thread = new Thread(task, "starts confined processes");
            thread.setDaemon(true);
            return thread;
          });

  /** Processes with a wall that have not ended, each with the name of its machine. */
  private static final Map<Process, String> WALLED = new ConcurrentHashMap<>();

  static {
    try {
      Runtime.getRuntime().addShutdownHook(new Thread(Confinement::endAll, "ends walls"));
    } catch (IllegalStateException e) {
      // The program is ending already.
    }
  }

  private final Optional<Wall> wall;
  private final String text;

  private Confinement(Optional<Wall> wall, String text) {
    this.wall = wall;
    this.text = text;
  }

  /** Returns the wall of this machine; the first call probes it, which takes about a second. */
  public static Confinement ofThisMachine() {
    return OfThisMachine.PROBED;
  }

  /** Begins to probe the wall of this machine, for a program that will soon need it. */
  public static void probeAhead() {
    Thread probing = new Thread(Confinement::ofThisMachine, "mechservice-probe");
    probing.setDaemon(true);
    probing.start();
  }

  /** Returns no wall: an ordinary process. */
  public static Confinement none(String reason) {
    return new Confinement(Optional.empty(), reason);
  }

  /** Returns whether there is a wall. */
  public boolean stands() {
    return wall.isPresent();
  }

  /** Returns what the wall is, or why there is none. */
  public String text() {
    return text;
  }

  /**
   * Returns why classes of users do not run and what to do about it.
   *
   * @param where the machine without a wall, in words
   */
  public String remedy(String where) {
    return where
        + " cannot confine classes of users, so it does not run them: "
        + text
        + "; make bubblewrap work there, or let them run unconfined if you trust them: with"
        + " --unconfined of the command, UserCode.unconfined of a program, or"
        + " --allow-user-code=unconfined of a server or host";
  }

  private static Confinement probe(String classPath) {
    if (!System.getProperty("os.name").equals("Linux")) {
      return none("only Linux can confine processes as MechService needs it");
    }
    Optional<SystemCallFilter> filter = SystemCallFilter.of(System.getProperty("os.arch"));
    if (filter.isEmpty()) {
      return none("there is no filter of system calls for " + System.getProperty("os.arch"));
    }
    Optional<Path> tool = tool();
    if (tool.isEmpty()) {
      return none("bubblewrap (bwrap) is not installed");
    }
    try {
      JavaFiles files = new JavaFiles(classPath);
      Confinement found =
          new Confinement(
              Optional.of(new Wall(tool.get(), filter.get(), files)),
              "bubblewrap with a filter of system calls");
      String answer = found.tryToGetOut();
      return answer.equals(ConfinementProbe.HELD)
          ? found
          : none("bubblewrap (" + tool.get() + ") does not work here: " + answer);
    } catch (IOException e) {
      return none("bubblewrap (" + tool.get() + ") does not work here: " + e.getMessage());
    }
  }

  private static Optional<Path> tool() {
    String searched = System.getenv().getOrDefault("PATH", "") + File.pathSeparator + "/usr/bin";
    return Stream.of(searched.split(File.pathSeparator, -1))
        .filter(folder -> folder.startsWith("/"))
        .map(folder -> Path.of(folder, "bwrap"))
        .filter(Files::isExecutable)
        .findFirst();
  }

  /**
   * Runs a probe that tries to leave the sandbox.
   *
   * @return what it says, {@link ConfinementProbe#HELD} if it could not
   */
  String tryToGetOut() throws IOException {
    Path ownFile = Files.createTempFile("mechservice-probe", ".txt");
    try (ServerSocket listening = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
      ProcessBuilder command =
          command(
              new WorkerBounds(1 << 26, PROBE_SECONDS),
              ConfinementProbe.class,
              List.of(
                  Integer.toString(listening.getLocalPort()), "/etc/passwd", ownFile.toString()));
      Process probe = start(command.redirectErrorStream(true));
      try {
        probe.getOutputStream().close();
        if (!probe.waitFor(PROBE_SECONDS, TimeUnit.SECONDS)) {
          return "a small program did not end behind it within " + PROBE_SECONDS + " s";
        }
        byte[] said = probe.getInputStream().readNBytes(PROBE_OUTPUT);
        String answer = new String(said, StandardCharsets.UTF_8).strip().split("\\R", 2)[0];
        return answer.isEmpty() ? "it ended with status " + probe.exitValue() : answer;
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return "the probe was interrupted";
      } finally {
        probe.destroyForcibly();
      }
    } finally {
      Files.delete(ownFile);
    }
  }

  /**
   * Returns what starts a Java program of this product that runs no code of users, in an ordinary
   * process with bounded memory, without environment. Without a choice of modules Java starts from
   * its archive of classes, and with one compiler sooner.
   *
   * @param optimising whether it runs long enough to be compiled a second time
   */
  static ProcessBuilder ordinary(WorkerBounds bounds, Class<?> main, boolean optimising) {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.add("-Xmx" + bounds.heapBytes());
    if (!optimising) {
      command.add("-XX:TieredStopAtLevel=1");
    }
    command.addAll(
        List.of(
            "-XX:+UseSerialGC",
            "-XX:+ExitOnOutOfMemoryError",
            "-XX:+SuppressFatalErrorMessage",
            "-Xshare:auto",
            "-cp",
            System.getProperty("java.class.path"),
            main.getName()));
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.environment().clear();
    return builder;
  }

  /**
   * Returns what starts a Java program behind the wall, or in an ordinary process if there is none.
   * It has no environment.
   *
   * @throws IOException if the filter cannot be handed over
   */
  public ProcessBuilder command(WorkerBounds bounds, Class<?> main, List<String> arguments)
      throws IOException {
    List<String> command = new ArrayList<>();
    String launcher = Path.of(System.getProperty("java.home"), "bin", "java").toString();
    String classPath = System.getProperty("java.class.path");
    if (wall.isPresent()) {
      addWall(command, wall.get(), bounds);
      launcher = JavaFiles.LAUNCHER;
      classPath = wall.get().files().classPath();
    }
    command.add(launcher);
    if (bounds.heapBytes() > 0) {
      command.add("-Xmx" + bounds.heapBytes());
    }
    command.addAll(
        List.of(
            "-XX:+UseSerialGC",
            "-XX:+ExitOnOutOfMemoryError",
            "-XX:CompressedClassSpaceSize=128m",
            "-XX:ReservedCodeCacheSize=128m",
            "-XX:MaxDirectMemorySize=16m",
            "-XX:-UsePerfData",
            "-XX:+DisableAttachMechanism",
            "-XX:+SuppressFatalErrorMessage",
            "-Xshare:auto",
            "--limit-modules",
            "java.base",
            "-cp",
            classPath,
            main.getName()));
    command.addAll(arguments);
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.environment().clear();
    return builder;
  }

  /**
   * Starts a process that lives as long as this one, whatever becomes of the calling thread. If it
   * is killed, from here or from outside, all that belongs to its wall ends and its streams close,
   * however little of the wall stood.
   *
   * @param command of {@link #command}
   * @throws IOException if it cannot be started
   */
  public static Process start(ProcessBuilder command) throws IOException {
    try {
      Process started = STARTER.submit(command::start).get();
      List<String> words = command.command();
      if (words.get(0).equals(WALL_SHELL)) {
        String name = words.get(words.indexOf(NAME) + 1);
        WALLED.put(started, name);
        CompletableFuture<Void> unused = started.onExit().thenAccept(Confinement::endRemains);
      }
      return started;
    } catch (ExecutionException e) {
      throw new IOException(e.getCause());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new InterruptedIOException("the start of a confined process was not awaited");
    }
  }

  /** A program that ends leaves no half of a wall. */
  private static void endAll() {
    List<Process> all = List.copyOf(WALLED.keySet());
    all.forEach(Process::destroyForcibly);
    try {
      for (Process process : all) {
        if (process.waitFor(ENDING_SECONDS, TimeUnit.SECONDS)) {
          endRemains(process);
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /**
   * Ends what the end of a wall has left. Bubblewrap divides itself before anything binds one half
   * to the other: if the outer one is killed then, the inner one waits for it for ever and holds
   * the streams of the worker. It still has the words of the command, and is the first process of
   * its machine, with which all others there end.
   *
   * @param ended the outer half, which does not divide itself any more
   */
  private static synchronized void endRemains(Process ended) {
    String name = WALLED.remove(ended);
    if (name == null || ended.exitValue() == 0) {
      return;
    }
    try (DirectoryStream<Path> processes = Files.newDirectoryStream(PROCESSES, "[0-9]*")) {
      for (Path process : processes) {
        if (hasWord(process, name)) {
          ProcessHandle.of(Long.parseLong(process.getFileName().toString()))
              .ifPresent(ProcessHandle::destroyForcibly);
        }
      }
    } catch (IOException | DirectoryIteratorException e) {
      throw new IllegalStateException("no wall has held where processes cannot be seen", e);
    }
  }

  private static boolean hasWord(Path process, String word) {
    try {
      byte[] words = Files.readAllBytes(process.resolve("cmdline"));
      return new String(words, StandardCharsets.ISO_8859_1).contains("\0" + word + "\0");
    } catch (IOException e) {
      return false; // it has just ended
    }
  }

  private static void addWall(List<String> command, Wall wall, WorkerBounds bounds)
      throws IOException {
    Path filter = Files.createTempFile("mechservice-filter", ".bpf");
    Files.write(filter, wall.filter().program());
    String space =
        bounds.heapBytes() > 0
            ? Long.toString((bounds.heapBytes() + BESIDE_HEAP) >> 10)
            : "unlimited";
    String time = bounds.cpuSeconds() > 0 ? Long.toString(bounds.cpuSeconds()) : "unlimited";
    command.addAll(List.of(WALL_SHELL, "-c", SHELL, "worker", space, time, filter.toString()));
    command.add(wall.tool().toString());
    command.addAll(List.of("--seccomp", "3"));
    command.addAll(List.of(NAME, "worker-" + UUID.randomUUID()));
    command.addAll(ISOLATION);
    command.addAll(wall.files().arguments());
    command.addAll(List.of("--dir", "/tmp", "--remount-ro", "/", "--chdir", "/", "--"));
  }
}
