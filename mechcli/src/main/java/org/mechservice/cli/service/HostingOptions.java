package org.mechservice.cli.service;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import org.mechservice.sim.host.HostOptions;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.sim.worker.UserCodePolicy;
import picocli.CommandLine.Option;

/** Limits, spool folder and user code of a process that runs simulations. */
final class HostingOptions {
  @Option(
      names = "--limit",
      paramLabel = "NAME=VALUE",
      description =
          "What clients may use at most, such as sessions, wallTime or memory; -1: unlimited; may"
              + " be given several times (docs/service.md lists them).")
  private Map<String, Long> limits = Map.of();

  @Option(
      names = "--spool",
      paramLabel = "DIR",
      description = "Keep ended runs in this folder, where they outlive the process.")
  private Optional<Path> spool = Optional.empty();

  @Option(
      names = "--allow-user-code",
      arity = "0..1",
      paramLabel = "confined|unconfined",
      fallbackValue = "confined",
      description =
          "Compile and run the classes of user forces that clients send: confined by the operating"
              + " system, which needs bubblewrap, or (unconfined) also where that is not to be"
              + " had.")
  private UserCodePolicy userCode = UserCodePolicy.REFUSED;

  /**
   * Returns the options of the host.
   *
   * @throws IllegalArgumentException with code S-015 if a limit is unknown or makes no sense
   */
  HostOptions of(String name, int capacity) {
    HostLimits all = HostLimits.DEFAULT;
    for (Map.Entry<String, Long> limit : limits.entrySet()) {
      all = all.with(limit.getKey(), limit.getValue());
    }
    return new HostOptions(name, capacity, all, spool, userCode);
  }
}
