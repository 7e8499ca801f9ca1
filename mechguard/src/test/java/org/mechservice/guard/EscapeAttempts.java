package org.mechservice.guard;

import java.io.File;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.StandardProtocolFamily;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * A program that tries many ways out of its process and prints which of them work. None of them
 * changes anything outside.
 */
final class EscapeAttempts {
  private interface Attempt {
    void run() throws Throwable;
  }

  /** Begins the line of a way that works, or does not. */
  static final String WORKED = "+ ";

  static final String FAILED = "- ";

  private EscapeAttempts() {}

  /**
   * Tries.
   *
   * @param arguments a port of the machine that listens, a file and a folder of the machine, and
   *     how Java is to start processes
   */
  public static void main(String[] arguments) {
    int port = Integer.parseInt(arguments[0]);
    System.setProperty("jdk.lang.Process.launchMechanism", arguments[3]);
    attempt("reads the users", () -> Files.readAllBytes(Path.of("/etc/passwd")));
    attempt("reads a file of the host", () -> Files.readAllBytes(Path.of(arguments[1])));
    attempt("lists a folder of the host", () -> require(new File(arguments[2]).list() != null));
    attempt(
        "opens the memory of the first process", () -> new FileInputStream("/proc/1/mem").read());
    attempt(
        "reads the environment of the first process",
        () -> require(new FileInputStream("/proc/1/environ").readAllBytes().length > 0));
    attempt("sees an environment", () -> require(System.getenv().size() > 2));
    attempt("sees other processes", () -> require(ProcessHandle.allProcesses().count() > 2));
    attempt("writes a file", () -> writes(Path.of("/tmp")));
    attempt("writes where it is", () -> writes(Path.of("")));
    attempt("writes among its classes", () -> writes(Path.of("/classes")));
    attempt("writes into Java", () -> writes(Path.of("/java/lib")));
    attempt("deletes a file of Java", () -> Files.delete(Path.of("/java/lib/modules")));
    attempt(
        "names the host in the kernel",
        () -> new FileOutputStream("/proc/sys/kernel/hostname", true).close());
    attempt(
        "sets what the kernel runs at a crash",
        () -> new FileOutputStream("/proc/sys/kernel/core_pattern", true).close());
    attempt(
        "makes itself safe from memory shortage",
        () -> new FileOutputStream("/proc/self/oom_score_adj", true).close());
    attempt(
        "connects to the loopback interface",
        () -> new Socket(InetAddress.getLoopbackAddress(), port).close());
    attempt(
        "connects to the machine by its name",
        () -> new Socket(InetAddress.getLocalHost(), port).close());
    attempt(
        "connects outward",
        () -> new Socket(InetAddress.getByAddress(new byte[] {(byte) 192, 0, 2, 1}), 80).close());
    attempt("sends a datagram", () -> new DatagramSocket().close());
    attempt("listens", () -> new ServerSocket(0).close());
    attempt(
        "opens a socket in the file system",
        () -> SocketChannel.open(StandardProtocolFamily.UNIX).close());
    attempt("opens a channel", () -> SocketChannel.open().close());
    attempt("runs a shell", () -> Runtime.getRuntime().exec("/bin/sh"));
    attempt("runs Java again", () -> new ProcessBuilder("/java/bin/java", "-version").start());
    attempt("loads a library of its own", () -> loadsCopy());
    attempt("finds unsafe memory", () -> Class.forName("sun.misc.Unsafe"));
    attempt(
        "finds the tools of Java",
        () -> require(ModuleLayer.boot().findModule("java.desktop").isPresent()));
    attempt(
        "opens what Java keeps closed",
        () -> Class.forName("jdk.internal.misc.Unsafe").getMethod("getUnsafe").invoke(null));
    attempt(
        "opens private fields of Java",
        () -> String.class.getDeclaredField("value").setAccessible(true));
    attempt("takes the memory beside the heap", () -> ByteBuffer.allocateDirect(1 << 30));
    System.exit(0);
  }

  private static void attempt(String name, Attempt way) {
    try {
      way.run();
      System.out.println(WORKED + name);
    } catch (Throwable e) {
      System.out.println(FAILED + name);
    }
  }

  private static void require(boolean out) {
    if (!out) {
      throw new IllegalStateException();
    }
  }

  private static void writes(Path folder) throws IOException {
    Files.delete(Files.createTempFile(folder, "escape", ".tmp"));
  }

  private static void loadsCopy() throws IOException {
    Path copy = Files.createTempFile("escape", ".so");
    try {
      System.load(copy.toString());
    } catch (UnsatisfiedLinkError e) {
      // The file is empty; it was written, which is enough.
    } finally {
      Files.delete(copy);
    }
  }
}
