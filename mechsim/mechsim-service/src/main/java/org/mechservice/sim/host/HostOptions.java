package org.mechservice.sim.host;

import java.nio.file.Path;
import java.util.Optional;
import org.mechservice.guard.UserCodePolicy;
import org.mechservice.sim.service.limits.HostLimits;

/**
 * The options of a host.
 *
 * @param name its name, unique at its servers
 * @param capacity simulations it runs at once
 * @param limits of its clients
 * @param spool folder in which ended runs outlive the process; empty: they do not
 * @param userCode where classes of users run
 */
public record HostOptions(
    String name, int capacity, HostLimits limits, Optional<Path> spool, UserCodePolicy userCode) {
  /** A host that runs no classes of users. */
  public HostOptions(String name, int capacity, HostLimits limits, Optional<Path> spool) {
    this(name, capacity, limits, spool, UserCodePolicy.REFUSED);
  }

  /** A host with default limits and without a spool folder. */
  public HostOptions(String name, int capacity) {
    this(name, capacity, HostLimits.DEFAULT, Optional.empty());
  }

  /** Returns the same host, which runs classes of users as a policy says. */
  public HostOptions withUserCode(UserCodePolicy policy) {
    return new HostOptions(name, capacity, limits, spool, policy);
  }
}
