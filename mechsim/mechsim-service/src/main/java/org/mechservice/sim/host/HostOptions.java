package org.mechservice.sim.host;

import java.nio.file.Path;
import java.util.Optional;
import org.mechservice.sim.service.limits.HostLimits;

/**
 * The options of a host.
 *
 * @param name its name, unique at its servers
 * @param capacity simulations it runs at once
 * @param limits of its clients
 * @param spool folder in which ended runs outlive the process; empty: they do not
 * @param userCode whether classes of users may be compiled and run here
 */
public record HostOptions(
    String name, int capacity, HostLimits limits, Optional<Path> spool, boolean userCode) {
  /** A host that runs no classes of users. */
  public HostOptions(String name, int capacity, HostLimits limits, Optional<Path> spool) {
    this(name, capacity, limits, spool, false);
  }

  /** A host with default limits and without a spool folder. */
  public HostOptions(String name, int capacity) {
    this(name, capacity, HostLimits.DEFAULT, Optional.empty());
  }

  /** Returns the same host, which may run classes of users or not. */
  public HostOptions withUserCode(boolean allowed) {
    return new HostOptions(name, capacity, limits, spool, allowed);
  }
}
