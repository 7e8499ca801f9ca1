package org.mechservice.sim.service.session;

import org.mechservice.orb.ListenAddress;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.sim.host.HostOptions;
import org.mechservice.sim.host.SimHost;
import org.mechservice.sim.service.library.ClassLibrary;
import org.mechservice.sim.service.limits.CurrentLimits;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.sim.service.setup.SetUpWorkers;
import org.mechservice.solver.api.Solver;

/** A host in a process of its own: made ready, prints the reference of a session, then waits. */
final class WarmHostMain {
  private WarmHostMain() {}

  @SuppressWarnings("SystemOut") // how the test learns of the session
  public static void main(String[] arguments) throws Exception {
    Solver solver = SimHost.installedSolver();
    try (ServiceOrb orb = ServiceOrb.host(new ListenAddress("127.0.0.1", 0));
        SimHost host = new SimHost(orb, new HostOptions("warm", 1), solver, () -> {});
        SetUpWorkers setUps =
            new SetUpWorkers(new CurrentLimits(HostLimits.OWN), new ClassLibrary());
        WarmUp warmUp = new WarmUp(orb, solver, setUps)) {
      warmUp.run();
      System.out.println(orb.toIor(host.createSession("first", null)));
      System.in.read();
    }
  }
}
