package org.mechservice.cli.service;

import java.util.List;
import java.util.concurrent.Callable;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.TlsOption;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.sim.host.HostSettings;
import org.mechservice.sim.host.SimHostProcess;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code mech simhost}: runs simulations for a server until a signal ends it. */
@Command(
    name = "simhost",
    description = "Runs simulations for a server; prints its own address when it is registered.",
    footer = "mech simhost --server 127.0.0.1:15000 --name workshop --capacity 2",
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class SimhostCommand implements Callable<Integer> {
  private static final int ANY_PORT = 0;

  @Option(
      names = "--server",
      required = true,
      paramLabel = "URL[,URL...]",
      split = ",",
      hideParamSyntax = true,
      description = "Servers to register with, as host:port or URL; one of them must be there.")
  private List<String> servers = List.of();

  @Mixin private ListenOptions listen = new ListenOptions();

  @Option(
      names = "--name",
      paramLabel = "N",
      description = "The host's name at the server (default: host-PROCESS-ID).")
  private String name = "host-" + ProcessHandle.current().pid();

  @Option(
      names = "--capacity",
      paramLabel = "K",
      description = "Simulations it runs at once (default: number of processors).")
  private int capacity = Runtime.getRuntime().availableProcessors();

  @Mixin private HostingOptions hosting = new HostingOptions();

  @Mixin private TlsOption tls = new TlsOption();

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws InterruptedException {
    if (capacity < 1) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE + " --capacity is " + capacity + "; it must be 1 or more");
    }
    int grace = hosting.graceSeconds();
    HostSettings settings =
        new HostSettings(
            servers,
            listen.address(),
            listen.port(ANY_PORT),
            hosting.of(name, capacity),
            tls.identity());
    try (SimHostProcess host = SimHostProcess.start(settings)) {
      spec.commandLine().getOut().println(host.address());
      host.warmUp();
      ServingProcess.untilEnded(() -> host.stop(grace), grace, host::awaitShutdown);
    }
    return ExitStatus.DONE;
  }
}
