package org.mechservice.load;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** A server or host in a process of its own, whose inside can be counted. */
final class ServiceJvm implements AutoCloseable {
  private static final Path JAVA_HOME = Path.of(System.getProperty("java.home"));
  private static final long PATIENCE_SECONDS = 60;
  private static final long SETTLING_MINUTES = 2;
  private static final Pattern TOTAL = Pattern.compile("Total\\s+\\d+\\s+(\\d+)");
  private static final Pattern SERVANTS =
      Pattern.compile("\\s(\\d+)\\s+\\d+\\s+org\\.mechservice\\.idl\\.\\w+POATie\\s");

  private final Process process;
  private final String firstLine;
  private final Path messages;

  private ServiceJvm(List<String> command) throws IOException {
    messages = Files.createTempFile("service", ".err");
    process = new ProcessBuilder(command).redirectError(messages.toFile()).start();
    BufferedReader out =
        new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    String line = out.readLine();
    if (line == null) {
      throw new IOException("did not start: " + Files.readString(messages));
    }
    firstLine = line;
  }

  /**
   * Starts a command of {@code mech} and waits until it prints its address.
   *
   * @param prefix words before the command, such as those that put it into a network of its own
   * @param heapMegabytes most heap
   */
  static ServiceJvm start(List<String> prefix, int heapMegabytes, String... arguments)
      throws IOException {
    return start(prefix, heapMegabytes, List.of(), arguments);
  }

  /**
   * Starts a command of {@code mech} and waits until it prints its address.
   *
   * @param settings system properties, as Java's command line has them
   */
  static ServiceJvm start(
      List<String> prefix, int heapMegabytes, List<String> settings, String... arguments)
      throws IOException {
    List<String> command = new ArrayList<>(prefix);
    command.addAll(
        List.of(
            JAVA_HOME.resolve("bin/java").toString(),
            "-Xmx" + heapMegabytes + "m",
            "-XX:+UseSerialGC",
            "-XX:TieredStopAtLevel=1",
            "-XX:+ExitOnOutOfMemoryError"));
    command.addAll(settings);
    command.addAll(
        List.of("-cp", System.getProperty("java.class.path"), "org.mechservice.cli.Mech"));
    command.addAll(List.of(arguments));
    return new ServiceJvm(command);
  }

  /** Starts a server on a free port, with options besides. */
  static ServiceJvm server(int heapMegabytes, String... options) throws IOException {
    List<String> words = new ArrayList<>(List.of("server", "--port", "0"));
    words.addAll(List.of(options));
    return start(List.of(), heapMegabytes, words.toArray(String[]::new));
  }

  /** Starts a host on a free port, with options besides. */
  static ServiceJvm host(String serverUrl, String name, String... options) throws IOException {
    List<String> words =
        new ArrayList<>(
            List.of("simhost", "--server", serverUrl, "--listen", "127.0.0.1:0", "--name", name));
    words.addAll(List.of(options));
    return start(List.of(), 256, words.toArray(String[]::new));
  }

  /** Returns what it printed when it was ready: a server its URL, a host its address. */
  String address() {
    return firstLine;
  }

  /** Returns the port it listens on. */
  int port() {
    return Integer.parseInt(firstLine.replaceAll(".*:(\\d+)(/.*)?$", "$1"));
  }

  long pid() {
    return process.pid();
  }

  boolean alive() {
    return process.isAlive();
  }

  /** Returns the processes of runs that it has started; models are read in others. */
  List<ProcessHandle> workers() {
    return process.descendants().filter(ServiceJvm::isWorker).toList();
  }

  /** Returns whether a process computes a run with classes of users, or is the wall around it. */
  static boolean isWorker(ProcessHandle child) {
    // the handle knows no arguments of a command as long as this
    Path words = Path.of("/proc", Long.toString(child.pid()), "cmdline");
    try {
      return Files.readString(words).contains("org.mechservice.guard.worker");
    } catch (IOException e) {
      return false; // it has ended
    }
  }

  /** Ends it without a word, like {@code kill -9}. */
  void kill() throws InterruptedException {
    process.destroyForcibly().waitFor();
  }

  /** Sends it a termination signal, like {@code kill}; returns its exit status. */
  int terminate() throws InterruptedException {
    process.destroy();
    return process.waitFor();
  }

  /** Returns what it said on standard error. */
  String messages() throws IOException {
    return Files.readString(messages);
  }

  /**
   * What is left in the process after a full collection.
   *
   * @param heapBytes bytes of objects in use
   * @param objects CORBA objects that can be called
   * @param threads threads of the process
   * @param files open file descriptors
   */
  record Inside(long heapBytes, long objects, long threads, long files) {}

  /** Collects garbage and counts. */
  Inside inside() throws IOException, InterruptedException {
    String histogram = jcmd("GC.class_histogram");
    long heap = 0;
    long objects = 0;
    Matcher total = TOTAL.matcher(histogram);
    while (total.find()) {
      heap = Long.parseLong(total.group(1));
    }
    Matcher servants = SERVANTS.matcher(histogram);
    while (servants.find()) {
      objects += Long.parseLong(servants.group(1));
    }
    if (heap == 0) {
      throw new IOException("no histogram: " + histogram);
    }
    return new Inside(heap, objects, entries("task"), entries("fd"));
  }

  /**
   * Counts until what is counted is as it is to be, for two minutes at most: connections that are
   * late are closed after ten seconds, and on a busy machine that takes its time.
   */
  Inside insideOnce(Predicate<Inside> settled) throws IOException, InterruptedException {
    long start = System.nanoTime();
    while (true) {
      Inside now = inside();
      if (settled.test(now)
          || System.nanoTime() - start > TimeUnit.MINUTES.toNanos(SETTLING_MINUTES)) {
        return now;
      }
      Thread.sleep(1000);
    }
  }

  /** Returns the classes whose objects take most of the heap after a full collection. */
  String largest() throws IOException, InterruptedException {
    return jcmd("GC.class_histogram").lines().limit(20).collect(Collectors.joining("\n"));
  }

  private long entries(String kind) throws IOException {
    try (Stream<Path> all = Files.list(Path.of("/proc/" + pid() + "/" + kind))) {
      return all.count();
    }
  }

  private String jcmd(String what) throws IOException, InterruptedException {
    Process asked =
        new ProcessBuilder(JAVA_HOME.resolve("bin/jcmd").toString(), Long.toString(pid()), what)
            .redirectErrorStream(true)
            .start();
    String answer = new String(asked.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    asked.waitFor();
    return answer;
  }

  @Override
  public void close() {
    process.destroy();
    try {
      if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
        process.destroyForcibly().waitFor();
      }
      Files.deleteIfExists(messages);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }
}
