package org.mechservice.sim.service.session;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.MechSimHelper;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.orb.ListenAddress;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.sim.host.HostOptions;
import org.mechservice.sim.host.SimHost;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.solver.api.Solver;
import org.omg.CORBA.UserException;

/** A host and a client of it, each with an ORB of its own, joined by a socket. */
final class HostedClient implements AutoCloseable {
  /** Time, five joint positions, five joint velocities. */
  static final int COLUMNS = 11;

  static final String[] ALL = new String[0];

  final ServiceOrb hostOrb = ServiceOrb.host(new ListenAddress("127.0.0.1", 0));
  final ServiceOrb clientOrb = ServiceOrb.client();
  final CountDownLatch shutDown = new CountDownLatch(1);
  final SimHost host;

  HostedClient(Solver solver, HostLimits limits, int capacity) {
    this(solver, new HostOptions("here", capacity, limits, Optional.empty()));
  }

  HostedClient(Solver solver, HostOptions options) {
    host = new SimHost(hostOrb, options, solver, shutDown::countDown);
  }

  static HostedClient with(Solver solver) {
    return new HostedClient(solver, HostLimits.DEFAULT, 2);
  }

  static HostedClient withInstalledSolver() {
    return with(SimHost.installedSolver());
  }

  static String pendulumText() {
    try (InputStream in =
        Objects.requireNonNull(HostedClient.class.getResourceAsStream("pendulum.xml"))) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static ModelFile pendulum() {
    return new ModelFile("pendulum.xml", pendulumText().getBytes(StandardCharsets.UTF_8));
  }

  MechSim emptySession() throws UserException {
    return seenByClient(host.createSession("test", null));
  }

  MechSim seenByClient(MechSim session) {
    return MechSimHelper.unchecked_narrow(clientOrb.fromIor(hostOrb.toIor(session)));
  }

  MechSim session() throws UserException {
    MechSim session = emptySession();
    session.loadModel(pendulum(), new ModelFile[0]);
    return session;
  }

  IMechSimRemote simulation(NameValue... options) throws UserException {
    return session().createSimulation(options, null);
  }

  @Override
  public void close() {
    host.close();
    clientOrb.close();
    hostOrb.close();
  }
}
