package org.mechservice.server;

import org.mechservice.orb.ServiceOrb;
import org.mechservice.sim.host.SimHost;
import org.mechservice.sim.service.limits.CurrentLimits;

/** Opens the host inside the server's own process. */
interface HostFactory {
  /** The host with the solver of this process. */
  HostFactory INSTALLED =
      (orb, settings, limits, shutdown) ->
          new SimHost(orb, settings.host(), limits, SimHost.installedSolver(), shutdown);

  /**
   * Opens the host.
   *
   * @param orb serves its sessions
   * @param settings its name and capacity
   * @param limits what it allows its clients
   * @param shutdown closes the server
   */
  SimHost open(ServiceOrb orb, ServerSettings settings, CurrentLimits limits, Runnable shutdown);
}
