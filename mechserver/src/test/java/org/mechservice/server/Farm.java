package org.mechservice.server;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.MechAdmin;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.server.hosts.ServerTuning;
import org.mechservice.sim.host.HostSettings;
import org.mechservice.sim.host.SimHost;
import org.mechservice.sim.host.SimHostProcess;
import org.mechservice.sim.service.testing.PacedSolver;
import org.omg.CORBA.UserException;

/** A server, hosts and a client, each with an ORB of its own, in one JVM. */
final class Farm implements AutoCloseable {
  /** Opens a host whose runs never end by themselves. */
  static final HostFactory ENDLESS_HOST =
      (orb, settings, limits, shutdown) ->
          new SimHost(orb, settings.host(), limits, PacedSolver.endless(), shutdown);

  /** Notices within a second what a real server notices within many. */
  static final ServerTuning BRISK =
      new ServerTuning(Duration.ofSeconds(1), Duration.ofMillis(200), Duration.ofSeconds(1));

  /** Has patience with a machine under heavy load, but asks its hosts often. */
  static final ServerTuning STEADY =
      new ServerTuning(Duration.ofHours(1), Duration.ofMillis(200), Duration.ofMinutes(1));

  private final Deque<Runnable> parts = new ArrayDeque<>();
  final MechServerProcess server;
  final ServiceOrb orb = ServiceOrb.client();
  final MechServer service;
  final MechAdmin admin;

  Farm(int ownCapacity) {
    this(ownCapacity, STEADY);
  }

  Farm(int ownCapacity, ServerTuning tuning) {
    server =
        MechServerProcess.start(
            new ServerSettings("own", "127.0.0.1", 0, ownCapacity), tuning, ENDLESS_HOST);
    parts.push(server::close);
    service = orb.connect(server.url());
    admin = orb.connectAdmin(server.url());
    parts.push(orb::close);
  }

  SimHostProcess host(String name, int capacity) {
    SimHostProcess host =
        SimHostProcess.start(
            new HostSettings(server.url(), name, "127.0.0.1", 0, capacity), PacedSolver.endless());
    parts.push(host::close);
    return host;
  }

  MechSim session(String hostName) throws UserException {
    return service.createSession("test", hostName, null);
  }

  static IMechSimRemote running(MechSim session) throws UserException {
    session.loadModel(Pendulum.file(), new ModelFile[0]);
    IMechSimRemote run = session.createSimulation(new NameValue[0], null);
    run.start();
    return run;
  }

  @Override
  public void close() {
    while (!parts.isEmpty()) {
      parts.pop().run();
    }
  }
}
