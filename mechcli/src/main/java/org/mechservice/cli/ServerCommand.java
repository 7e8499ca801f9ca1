package org.mechservice.cli;

import java.util.concurrent.Callable;
import org.mechservice.server.MechServerProcess;
import org.mechservice.server.ServerSettings;
import org.mechservice.sim.host.HostOptions;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code mech server}: serves until it is told to end. */
@Command(
    name = "server",
    description = "Serves simulations; prints its URL when it is ready.",
    mixinStandardHelpOptions = true,
    versionProvider = Mech.Version.class)
final class ServerCommand implements Callable<Integer> {
  private static final int DEFAULT_PORT = 15000;

  @Mixin private ListenOptions listen = new ListenOptions();

  @Option(names = "--name", paramLabel = "N", description = "The server's name.")
  private String name = "mech";

  @Option(
      names = "--capacity",
      paramLabel = "K",
      description =
          "Simulations it runs at once; 0: only its hosts run any (default: number of processors).")
  private int capacity = Runtime.getRuntime().availableProcessors();

  @Mixin private AllowUserCodeOption userCode = new AllowUserCodeOption();

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws InterruptedException {
    if (capacity < 0) {
      throw new UsageException("S-041 --capacity is " + capacity + "; it must be 0 or more");
    }
    HostOptions host = new HostOptions(name, capacity).withUserCode(userCode.isGiven());
    ServerSettings settings = new ServerSettings(listen.address(), listen.port(DEFAULT_PORT), host);
    try (MechServerProcess server = MechServerProcess.start(settings)) {
      spec.commandLine().getOut().println(server.url());
      Serving.untilEnded(server, server::awaitShutdown);
    }
    return ExitStatus.DONE;
  }
}
