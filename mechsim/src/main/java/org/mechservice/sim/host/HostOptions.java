package org.mechservice.sim.host;

import java.nio.file.Path;
import java.util.Optional;
import org.mechservice.sim.service.HostLimits;

/**
 * What a host is like.
 *
 * @param name its name, unique at its servers
 * @param capacity simulations it runs at once
 * @param limits what it allows
 * @param spool folder in which ended runs outlive the process; empty: they do not
 */
public record HostOptions(String name, int capacity, HostLimits limits, Optional<Path> spool) {
  /** A host with the limits of one nobody configured, which keeps nothing over its end. */
  public HostOptions(String name, int capacity) {
    this(name, capacity, HostLimits.DEFAULT, Optional.empty());
  }
}
