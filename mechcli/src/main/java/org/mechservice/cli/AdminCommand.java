package org.mechservice.cli;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.Callable;
import org.mechservice.admin.ServerReading;
import org.mechservice.admin.ServerWatch;
import org.mechservice.admin.StatusJson;
import org.mechservice.admin.StatusText;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;

/** {@code mech admin}: what an operator sees. */
@Command(
    name = "admin",
    description = "Shows servers, their hosts and what runs on them.",
    mixinStandardHelpOptions = true,
    versionProvider = Mech.Version.class)
final class AdminCommand implements Callable<Integer> {
  private static final Duration PATIENCE = Duration.ofSeconds(5);

  @Option(
      names = "--server",
      paramLabel = "URL",
      scope = ScopeType.INHERIT,
      description =
          "Server as host:port or URL; may be given several times (default: localhost:15000).")
  private List<String> servers = List.of();

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws InterruptedException {
    return status(false);
  }

  /** Prints the state of every server. */
  @Command(name = "status", description = "Lists servers, hosts and running simulations.")
  int status(@Option(names = "--json", description = "Print one JSON object.") boolean json)
      throws InterruptedException {
    List<String> asked = servers.isEmpty() ? List.of("localhost:15000") : servers;
    try (ServerWatch watch = new ServerWatch()) {
      List<ServerReading> readings = watch.read(asked, PATIENCE);
      if (json) {
        spec.commandLine().getOut().println(StatusJson.write(readings));
      } else if (readings.stream().anyMatch(ServerReading.Answering.class::isInstance)) {
        spec.commandLine().getOut().print(new StatusText(Instant.now()).format(readings));
      }
      return tellSilent(readings);
    }
  }

  private int tellSilent(List<ServerReading> readings) {
    int status = ExitStatus.DONE;
    for (ServerReading reading : readings) {
      if (reading instanceof ServerReading.Silent silent) {
        spec.commandLine().getErr().println(silent.why());
        status = ExitStatus.SERVER;
      }
    }
    return status;
  }
}
