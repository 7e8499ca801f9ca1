package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Every operation of the contract works from C++ with omniORB: examples/cpp-client/every-operation
 * calls each, and what it says it has called is compared with the IDL.
 */
class CppContractIT {
  private static final Path IDL = WorkingTree.TOP.resolve("idl/src/main/idl/mechservice.idl");
  private static final Pattern INTERFACE =
      Pattern.compile("interface\\s+(\\w+)\\s*(?::\\s*\\w+\\s*)?\\{([^}]*)\\}");
  private static final Pattern MEMBER =
      Pattern.compile("(?:attribute\\s+\\w+\\s+(\\w+)\\s*;|\\b(\\w+)\\s*\\()");

  @TempDir static Path directory;

  private final Terminal terminal = new Terminal(directory);

  @AfterEach
  void tidyUp() throws IOException {
    WorkingTree.unmirror(directory);
  }

  /** Returns the operations of the contract, as INTERFACE.OPERATION. */
  private static Set<String> operations() throws IOException {
    String text = Files.readString(IDL).replaceAll("//.*", "");
    Set<String> operations = new TreeSet<>();
    Matcher found = INTERFACE.matcher(text);
    while (found.find()) {
      Matcher member = MEMBER.matcher(found.group(2).replaceAll("raises\\s*\\([^)]*\\)", ""));
      while (member.find()) {
        String name = member.group(1) == null ? member.group(2) : member.group(1);
        operations.add(found.group(1) + "." + name);
      }
    }
    return operations;
  }

  @Test
  void everyOperationIsCalled() throws IOException {
    assumeTrue(
        Set.of("omniidl", "g++", "make").stream()
            .allMatch(tool -> terminal.shell("command -v " + tool).exitStatus() == 0),
        "the contract is not tried from C++: that needs omniidl, g++, make and libomniorb4-dev");
    WorkingTree.mirrorIn(directory);
    terminal.shell("make -C examples/cpp-client").orFail();
    int port = Service.freePort();
    int registryPort = Service.freePort();
    String run =
        "echo %s | examples/cpp-client/target/every-operation %d %s %s"
            .formatted(
                Service.url(port),
                registryPort,
                "examples/pendulum/pendulum.xml",
                "examples/robot/arm.urdf");
    try (var server = Service.startServer(directory, port);
        var client = terminal.start("sh", "-c", run)) {
      client.awaitThat("the registry", () -> client.stdout().contains("ready"));
      String servers = "127.0.0.1:" + registryPort;
      try (var host =
          terminal.startMech(
              "simhost", "--server", servers, "--listen", "127.0.0.1:0", "--name", "far")) {
        Terminal.Ended ended = client.awaitEnd().orFail();
        assertThat(host.stdout()).contains("127.0.0.1:");
        assertThat(ended.stdout().lines().filter(line -> line.contains(".")))
            .containsAll(operations());
        assertThat(ended.stdout())
            .contains("importModel is refused: S-105", "loadModel is refused: S-105");
      }
      server.awaitEnd().orFail();
    }
  }

  @Test
  void contractIsReadFromItsText() throws IOException {
    assertThat(operations())
        .contains("MechServer.getInfo", "IMechSimRemote.simId", "Leased.destroy")
        .noneMatch(name -> name.endsWith(".raises"))
        .hasSizeGreaterThan(60);
    assertThat(
            operations().stream()
                .map(name -> name.substring(0, name.indexOf('.')))
                .collect(Collectors.toSet()))
        .contains("MechAdmin", "HostRegistry", "MechSimHost", "IMechClient", "ResultCursor");
  }
}
