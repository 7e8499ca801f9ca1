package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The guide to three machines with TLS in docs/service.md, command by command, and with the command
 * lines of its units. Loopback addresses stand for the machines, and folders for their disks.
 */
class ThreeMachinesIT {
  private static final Map<String, String> MACHINES =
      Map.of(
          "sim.example.org", "127.0.0.31",
          "a.example.org", "127.0.0.32",
          "b.example.org", "127.0.0.33");

  @TempDir Path directory;

  private final Deque<Terminal.Running> processes = new ArrayDeque<>();

  @AfterEach
  void stop() throws IOException {
    while (!processes.isEmpty()) {
      processes.pop().close();
    }
    WorkingTree.unmirror(directory);
  }

  private static String here(String line) {
    String written = line;
    for (Map.Entry<String, String> machine : MACHINES.entrySet()) {
      written = written.replace(machine.getKey(), machine.getValue());
    }
    return written;
  }

  /** Returns the command line of a unit as the machine of an address would run it. */
  private String commandOf(String unit, String address) {
    String disk = directory.resolve(address).toString();
    return here(unit)
        .replace("ExecStart=/opt/mechservice/bin/mech", "exec ./mech")
        .replace("/etc/mech/keys", disk + "/keys")
        .replace("/var/log/mech", disk)
        .replace("/var/lib/mech", disk)
        .replace("--metrics-port 9464", "--metrics-port " + Service.freePort());
  }

  private void start(String command, String ready) {
    Terminal.Running process = new Terminal(directory).start("sh", "-c", command);
    processes.push(process);
    process.awaitThat(ready, () -> process.stdout().contains(ready));
  }

  @Test
  void guideWorksAsItIsWritten() throws IOException {
    WorkingTree.mirrorIn(directory);
    Terminal terminal = new Terminal(directory);
    List<String> guide =
        Documentation.section(
            WorkingTree.TOP.resolve("docs/service.md"), "Three machines with TLS");
    List<String> commands = Documentation.commandsIn(guide);
    List<String> units = guide.stream().filter(line -> line.startsWith("ExecStart=")).toList();
    assertThat(commands).hasSize(5);
    assertThat(units).hasSize(2);

    terminal.shell(here(commands.get(0))).orFail();
    for (String address : MACHINES.values()) {
      Files.createDirectory(directory.resolve(address));
      terminal.shell("cp -r keys/" + address + " " + address + "/keys").orFail();
    }
    start(commandOf(units.get(0), "127.0.0.31"), "corbaloc:ssliop:1.2@127.0.0.31:15000");
    start(commandOf(units.get(1), "127.0.0.32"), "127.0.0.32:15001");
    String unitOfB =
        units.get(1).replace("a.example.org", "b.example.org").replace("--name a", "--name b");
    start(commandOf(unitOfB, "127.0.0.33"), "127.0.0.33:15001");

    // The user's home is this folder.
    String home = "HOME='" + directory + "' && ";
    String identity = home + commands.get(1) + " && ";
    for (String command : commands.subList(2, commands.size())) {
      terminal.shell(identity + here(command)).orFail();
    }
    assertThat(directory.resolve("r.csv")).isNotEmptyFile();
    String status = home + "MECH_TLS=$HOME/keys/root ./mech admin --server sim.example.org status";
    assertThat(String.join("\n", guide)).contains(status.substring(home.length()));
    assertThat(terminal.shell(here(status)).orFail().stdout())
        .contains("127.0.0.32:15001", "127.0.0.33:15001");
    assertThat(directory.resolve("127.0.0.31/audit.jsonl")).content().contains("\"ann\"");
  }
}
