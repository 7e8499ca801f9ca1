package org.mechservice.cli.service;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.guard.UserCodePolicy;
import org.mechservice.sim.host.HostOptions;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Option;

/** Limits, spool folder and user code of a process that runs simulations. */
final class HostingOptions {
  /** Service managers wait longer than this before they kill a process. */
  private static final int GRACE_SECONDS = 10;

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

  @Option(
      names = "--grace",
      paramLabel = "S",
      description =
          "Seconds that active runs have to move to another host or to end when a signal stops the"
              + " process (default: 10).")
  private int grace = GRACE_SECONDS;

  /**
   * Returns the time that active runs have after a termination signal, s.
   *
   * @throws UsageException if it is negative
   */
  int graceSeconds() {
    if (grace < 0) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE + " --grace is " + grace + "; it must be 0 or more");
    }
    return grace;
  }

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
