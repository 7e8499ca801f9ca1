package org.mechservice.sim.service.session;

import java.util.concurrent.Executor;
import org.mechservice.guard.UserCodePolicy;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.sim.service.contract.DenialLog;
import org.mechservice.sim.service.contract.Journal;
import org.mechservice.sim.service.limits.CurrentLimits;
import org.mechservice.sim.service.results.RunStore;

/**
 * Services that the sessions of a host share.
 *
 * @param orb serves their objects
 * @param hostName the host's name at its server
 * @param limits what the host allows now
 * @param journal where what happens is written down
 * @param denials where refused calls are written down
 * @param store where ended runs go
 * @param callbacks threads that call clients back
 * @param userCode where classes of users run
 */
record HostServices(
    ServiceOrb orb,
    String hostName,
    CurrentLimits limits,
    Journal journal,
    DenialLog denials,
    RunStore store,
    Executor callbacks,
    UserCodePolicy userCode) {}
