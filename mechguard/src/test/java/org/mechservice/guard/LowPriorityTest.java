package org.mechservice.guard;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class LowPriorityTest {
  private static final int NICE = 10;

  /** The thread that computes is not the one whose id is that of its process. */
  @Test
  void allThreadsOfAProcessAndOfThoseBelowItComeLast() throws Exception {
    assumeTrue(Files.isDirectory(Path.of("/proc/self/task")), "it needs Linux");
    assumeTrue(
        Stream.of("/usr/bin/renice", "/bin/renice").map(Path::of).anyMatch(Files::isExecutable),
        "it needs renice");
    Process shell = new ProcessBuilder("sh", "-c", "sleep 60; true").start();
    Process java =
        new ProcessBuilder(
                System.getProperty("java.home") + "/bin/java",
                "-cp",
                System.getProperty("java.class.path"),
                Sleeping.class.getName())
            .start();
    try {
      assertThat(java.getInputStream().read()).isEqualTo('a'); // all its threads are there
      while (shell.descendants().findAny().isEmpty()) {
        Thread.sleep(10);
      }
      LowPriority.lower(java.toHandle());
      LowPriority.lower(shell.toHandle());
      for (Process each : List.of(java, shell)) {
        while (!priorities(each).stream().allMatch(nice -> nice == NICE)) {
          Thread.sleep(10); // renice is a process, too
        }
      }
      assertThat(priorities(java)).hasSizeGreaterThan(2);
    } finally {
      shell.descendants().forEach(ProcessHandle::destroyForcibly);
      shell.destroyForcibly();
      java.destroyForcibly();
    }
  }

  /** A program that waits. */
  static final class Sleeping {
    @SuppressWarnings("SystemOut") // how the test learns that it runs
    public static void main(String[] arguments) throws InterruptedException {
      System.out.print('a');
      System.out.flush();
      Thread.sleep(60_000);
    }
  }

  private static List<Integer> priorities(Process process) throws IOException {
    List<Integer> found = new ArrayList<>();
    for (ProcessHandle each :
        Stream.concat(Stream.of(process.toHandle()), process.descendants()).toList()) {
      try (Stream<Path> threads = Files.list(Path.of("/proc/" + each.pid() + "/task"))) {
        for (Path thread : threads.toList()) {
          // pid (name) state ppid ...: the nineteenth is the nice value
          String stat = Files.readString(thread.resolve("stat"));
          String[] fields = stat.substring(stat.lastIndexOf(')') + 2).split(" ", -1);
          found.add(Integer.parseInt(fields[16]));
        }
      } catch (NoSuchFileException e) {
        // has ended
      }
    }
    return found;
  }
}
