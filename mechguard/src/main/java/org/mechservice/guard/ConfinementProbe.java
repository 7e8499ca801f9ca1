package org.mechservice.guard;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Main class of a process that tries to get out of its confinement, and says on standard output
 * what it could do.
 */
final class ConfinementProbe {
  /** Output of a process that could not get out. */
  static final String HELD = "held";

  private static final int CONNECT_MILLIS = 2000;

  private ConfinementProbe() {}

  /**
   * Tries.
   *
   * @param arguments a port that listens on the loopback interface of the machine, and files of the
   *     machine that exist
   */
  public static void main(String[] arguments) {
    List<String> breaches = new ArrayList<>();
    for (int i = 1; i < arguments.length; i++) {
      if (Files.exists(Path.of(arguments[i]))) {
        breaches.add("see " + arguments[i]);
      }
    }
    if (connects(Integer.parseInt(arguments[0]))) {
      breaches.add("open a connection");
    }
    if (writes(Path.of("/tmp")) || writes(Path.of("/"))) {
      breaches.add("write a file");
    }
    if (Files.isWritable(Path.of("/proc/sys/kernel/core_pattern"))) {
      breaches.add("set parameters of the kernel");
    }
    if (starts()) {
      breaches.add("start a process");
    }
    System.out.println(breaches.isEmpty() ? HELD : "it could " + String.join(", ", breaches));
  }

  private static boolean connects(int port) {
    try (Socket socket = new Socket()) {
      socket.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), CONNECT_MILLIS);
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  private static boolean writes(Path folder) {
    try {
      Files.delete(Files.createTempFile(folder, "probe", ".tmp"));
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  private static boolean starts() {
    Path launcher = Path.of(System.getProperty("java.home"), "bin", "java");
    try {
      new ProcessBuilder(launcher.toString(), "-version").start().destroyForcibly();
      return true;
    } catch (IOException e) {
      return false;
    }
  }
}
