package org.mechservice.cli.service;

import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.TlsOption;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.server.MechServerProcess;
import org.mechservice.server.ServerSettings;
import org.mechservice.server.hosts.PlacementPolicy;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code mech server}: serves until a signal ends it. */
@Command(
    name = "server",
    description = "Serves simulations; prints its URL when it is ready.",
    footer = {
      "mech server --port 15000",
      "mech server --listen sim.example.org:15000 --tls /etc/mech/keys --spool /var/lib/mech"
    },
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class ServerCommand implements Callable<Integer> {
  private static final int DEFAULT_PORT = 15000;

  @Mixin private ListenOptions listen = new ListenOptions();

  @Option(names = "--name", paramLabel = "N", description = "The server's name.")
  private String name = "mech";

  @Option(
      names = "--capacity",
      paramLabel = "K",
      description =
          "Simulations it runs at once; 0: its hosts run all (default: number of processors).")
  private int capacity = Runtime.getRuntime().availableProcessors();

  @Mixin private HostingOptions hosting = new HostingOptions();

  @Option(
      names = "--placement",
      paramLabel = "POLICY",
      description =
          "How the host of a session is chosen: order, least-loaded or pinned (default:"
              + " least-loaded).")
  private String placement = PlacementPolicy.LEAST_LOADED.label();

  @Option(
      names = "--ior-file",
      paramLabel = "FILE",
      description =
          "Write the server's reference to this file, which clients can name as --server.")
  private Optional<Path> iorFile = Optional.empty();

  @Option(
      names = "--naming",
      paramLabel = "HOST:PORT",
      description = "Bind the server as MechServer at this CORBA naming service.")
  private Optional<String> naming = Optional.empty();

  @Option(
      names = "--metrics-port",
      paramLabel = "P",
      description =
          "Serve /metrics (Prometheus) and /health on this port, unencrypted; see"
              + " --metrics-listen.")
  private Optional<Integer> metricsPort = Optional.empty();

  @Option(
      names = "--metrics-listen",
      paramLabel = "ADDR",
      description =
          "Address of the metrics port; one that nobody but the monitoring system reaches"
              + " (default: 127.0.0.1).")
  private String metricsListen = "127.0.0.1";

  @Option(
      names = "--audit",
      paramLabel = "FILE",
      description = "Append who did what to this file, one JSON object per line.")
  private Optional<Path> audit = Optional.empty();

  @Mixin private TlsOption tls = new TlsOption();

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws InterruptedException {
    if (capacity < 0) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE + " --capacity is " + capacity + "; it must be 0 or more");
    }
    int grace = hosting.graceSeconds();
    ServerSettings settings =
        new ServerSettings(
            listen.address(),
            listen.port(DEFAULT_PORT),
            hosting.of(name, capacity),
            policy(),
            iorFile,
            naming,
            tls.identity(),
            metricsPort.map(ListenOptions::usable).map(this::metricsAddress),
            audit);
    try (MechServerProcess server = MechServerProcess.start(settings)) {
      spec.commandLine().getOut().println(server.url());
      server.warmUp();
      ServingProcess.untilEnded(() -> server.stop(grace), grace, server::awaitShutdown);
    }
    return ExitStatus.DONE;
  }

  private InetSocketAddress metricsAddress(int port) {
    InetSocketAddress address = new InetSocketAddress(metricsListen, port);
    if (address.isUnresolved()) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE + " --metrics-listen " + metricsListen + ": no such host");
    }
    return address;
  }

  private PlacementPolicy policy() {
    return PlacementPolicy.named(placement)
        .orElseThrow(
            () ->
                new UsageException(
                    MessageCode.OPTION_UNUSABLE
                        + " --placement is \""
                        + placement
                        + "\"; there are "
                        + PlacementPolicy.labels()));
  }
}
