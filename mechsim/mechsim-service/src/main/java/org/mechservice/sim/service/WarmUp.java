package org.mechservice.sim.service;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.IMechClientOperations;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.JarInfoHolder;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.MechSimHelper;
import org.mechservice.idl.MechSimOperations;
import org.mechservice.idl.MechSimPOATie;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NameValueSeqHolder;
import org.mechservice.idl.OPT_T_END;
import org.mechservice.idl.OPT_T_STEP;
import org.mechservice.idl.Progress;
import org.mechservice.idl.ResultBlockHolder;
import org.mechservice.idl.RunSetUp;
import org.mechservice.idl.SimState;
import org.mechservice.orb.GuardedServant;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.UserException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Makes a host ready before its first client comes: in a session like a client's a double pendulum
 * is read, built, packed, run and cancelled, which loads the classes that the first client, and the
 * first who cancels, otherwise wait for. The session has a queue, a store and a journal of its own:
 * it takes nobody's place, is counted nowhere and leaves nothing behind. A MechSim itself is opened
 * in a millisecond and is not kept in stock.
 */
public final class WarmUp implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(WarmUp.class);
  static final String MODEL = "warm-up.xml";
  private static final NameValue[] AS_IN_FILE = {};

  /** So long that it is cancelled before its end, with so few rows that they need no disk. */
  private static final NameValue[] LONG_RUN = {
    new NameValue(OPT_T_END.value, "1e6"), new NameValue(OPT_T_STEP.value, "1e3")
  };

  /** Among so many steps of this model some are rejected, of which a report has more to say. */
  private static final long STEPS = 1000;

  private static final int LOOK_MILLIS = 1;

  private final ServiceOrb orb;
  private final Solver solver;
  private volatile boolean closed;

  /**
   * @param orb of the host
   * @param solver of the host
   */
  public WarmUp(ServiceOrb orb, Solver solver) {
    this.orb = orb;
    this.solver = solver;
  }

  /** Begins; a client that comes meanwhile is served as ever. */
  public void begin() {
    Thread thread = new Thread(this::tried, "mechservice-warm-up");
    thread.setDaemon(true);
    thread.start();
  }

  private void tried() {
    try {
      run();
    } catch (UserException | IOException | RuntimeException e) {
      if (!closed) {
        LOG.warn(
            MessageCode.INTERNAL_SERVER_ERROR + " the first client will wait longer: {}",
            e.toString());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Does all of it; returns the state the run was left in. */
  SimState run() throws UserException, IOException, InterruptedException {
    LimitsInForce limits = new LimitsInForce(HostLimits.DEFAULT);
    IMechClient client = orb.export(new Deaf());
    try (RunQueue queue = new RunQueue(1, limits);
        RunStore store = new RunStore(Optional.empty(), limits);
        ModelLibrary library = new ModelLibrary()) {
      HostServices host =
          new HostServices(
              orb, "warm-up", limits, Journal.unwritten(), store, Runnable::run, false);
      Session session = new Session("warm-up", client, host);
      try {
        RunFactory runs =
            new RunFactory(
                solver, queue, store, Path.of(System.getProperty("java.io.tmpdir", ".")));
        Admission admission = new Admission(limits, () -> List.of(session));
        return cancelled(
            opened(session, new MechSimServant(session, library, runs, admission, session::end)));
      } finally {
        session.end();
      }
    } finally {
      orb.withdraw(client);
    }
  }

  private static MechSim opened(Session session, MechSimServant servant) {
    return MechSimHelper.unchecked_narrow(
        session
            .activateSelf(
                new MechSimPOATie(
                    GuardedServant.of(MechSimOperations.class, servant, session::renew)))
            .reference());
  }

  /** What clients do, remote and local ones. */
  private SimState cancelled(MechSim session)
      throws UserException, IOException, InterruptedException {
    session.loadModel(new ModelFile(MODEL, content()), new ModelFile[0]);
    RunSetUp setUp = session.prepareSimulation(LONG_RUN, null);
    IMechSimRemote run = setUp.simulation;
    run.start();
    Progress progress = run.getProgress();
    while (progress.stepsDone < STEPS && !hasEnded(progress.state) && !closed) {
      Thread.sleep(LOOK_MILLIS);
      progress = run.getProgress();
    }
    run.checkpoint(); // a cancelled run leaves one if it is between two steps just then
    run.cancel();
    SimState end = run.getProgress().state;
    run.report();
    setUp.rows.nextBlock(0, 0, new ResultBlockHolder());
    run.destroy();
    session.prepareJar(AS_IN_FILE, new JarInfoHolder(), new NameValueSeqHolder());
    session.destroy();
    return end;
  }

  private static boolean hasEnded(SimState state) {
    return state.value() > SimState._SIM_PAUSED;
  }

  static byte[] content() throws IOException {
    try (InputStream in = WarmUp.class.getResourceAsStream(MODEL)) {
      return Objects.requireNonNull(in).readAllBytes();
    }
  }

  /** Says that the host is closing: what fails from now on is not worth a word. */
  @Override
  public void close() {
    closed = true;
  }

  /** A client that is told everything and does nothing. */
  private static final class Deaf implements IMechClientOperations {
    @Override
    public void onStatus(String simId, SimState state, String text) {}

    @Override
    public void onProgress(Progress progress) {}

    @Override
    public void onMessages(String simId, Diagnostic[] messages) {}

    @Override
    public void heartbeat() {}
  }
}
