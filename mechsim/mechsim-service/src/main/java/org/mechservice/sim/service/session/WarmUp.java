package org.mechservice.sim.service.session;

import java.io.IOException;
import java.io.InputStream;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.mechservice.guard.UserCodePolicy;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.IMechClientOperations;
import org.mechservice.idl.IMechSimRemoteOperations;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.JarInfoHolder;
import org.mechservice.idl.MechSimOperations;
import org.mechservice.idl.MechSimPOATie;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NameValueSeqHolder;
import org.mechservice.idl.OPT_T_END;
import org.mechservice.idl.OPT_T_STEP;
import org.mechservice.idl.Progress;
import org.mechservice.idl.ResultBlockHolder;
import org.mechservice.idl.ResultCursorOperations;
import org.mechservice.idl.RunSetUp;
import org.mechservice.idl.SimState;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.orb.GuardedServant;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.service.contract.DenialLog;
import org.mechservice.sim.service.contract.Journal;
import org.mechservice.sim.service.library.ClassLibrary;
import org.mechservice.sim.service.library.LoadedModel;
import org.mechservice.sim.service.library.ModelLibrary;
import org.mechservice.sim.service.library.SetUpTimes;
import org.mechservice.sim.service.library.SimulationRequest;
import org.mechservice.sim.service.limits.AdmissionControl;
import org.mechservice.sim.service.limits.CurrentLimits;
import org.mechservice.sim.service.limits.HostLimit;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.sim.service.results.RunStore;
import org.mechservice.sim.service.run.RunFactory;
import org.mechservice.sim.service.run.RunQueue;
import org.mechservice.sim.service.setup.ModelFiles;
import org.mechservice.sim.service.setup.ReadingBounds;
import org.mechservice.sim.service.setup.SetUpWorkers;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.UserException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Loads the classes of a host before its first client needs them: reads, builds, packs, runs and
 * cancels a double pendulum in a session of its own. The session has its own queue, store and
 * journal: it takes no place of a client, is not counted and leaves nothing behind.
 */
public final class WarmUp implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(WarmUp.class);
  static final String MODEL = "warm-up.xml";
  private static final NameValue[] AS_IN_FILE = {};

  /** A run too long to end before it is cancelled, with so few rows that they stay in memory. */
  private static final NameValue[] LONG_RUN = {
    new NameValue(OPT_T_END.value, "1e6"), new NameValue(OPT_T_STEP.value, "1e3")
  };

  /** Steps before the cancel: some of them are rejected, so that the report has those entries. */
  private static final long STEPS = 1000;

  private static final int LOOK_MILLIS = 1;

  private final ServiceOrb orb;
  private final Solver solver;
  private final SetUpWorkers setUps;
  private volatile boolean closed;

  /**
   * @param orb of the host
   * @param solver of the host
   * @param setUps of the host
   */
  public WarmUp(ServiceOrb orb, Solver solver, SetUpWorkers setUps) {
    this.orb = orb;
    this.solver = solver;
    this.setUps = setUps;
  }

  /** Begins in a thread of its own; clients are served meanwhile. */
  public void begin() {
    Thread thread = new Thread(this::runLogged, "mechservice-warm-up");
    thread.setDaemon(true);
    thread.start();
  }

  private void runLogged() {
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

  /** Runs the whole warm-up; returns the final state of its run. */
  SimState run() throws UserException, IOException, InterruptedException {
    CurrentLimits limits = new CurrentLimits(HostLimits.DEFAULT.with(HostLimit.FREE_DISK, 0));
    setUps.prepare(new ModelFiles(MODEL, content(), List.of(), false, ReadingBounds.NONE));
    IMechClient client = orb.export(new SilentClient());
    try (RunQueue queue = new RunQueue(1, limits);
        RunStore store = new RunStore(Optional.empty(), limits)) {
      Journal journal = Journal.unlogged();
      HostServices host =
          new HostServices(
              orb,
              "warm-up",
              limits,
              journal,
              new DenialLog(journal),
              store,
              Runnable::run,
              UserCodePolicy.REFUSED);
      Session session = new Session("warm-up", client, host);
      try {
        RunFactory runs = new RunFactory(solver, queue, store);
        AdmissionControl admission = new AdmissionControl(limits, owner -> 0);
        return cancelled(
            opened(
                session,
                new MechSimServant(
                    session,
                    setUps.setUps(),
                    new ClassLibrary(),
                    runs,
                    admission,
                    () -> 0,
                    session::end)));
      } finally {
        session.end();
      }
    } finally {
      orb.withdraw(client);
    }
  }

  private MechSimOperations opened(Session session, MechSimServant servant) {
    return orb.own(
        session
            .activateSelf(
                new MechSimPOATie(
                    GuardedServant.of(MechSimOperations.class, servant, session.gate())))
            .reference(),
        MechSimOperations.class);
  }

  /** Makes the calls of a remote and a local client. */
  private SimState cancelled(MechSimOperations session)
      throws UserException, IOException, InterruptedException {
    session.loadModel(new ModelFile(MODEL, content()), new ModelFile[0]);
    RunSetUp setUp = session.prepareSimulation(LONG_RUN, null);
    IMechSimRemoteOperations run = orb.own(setUp.simulation, IMechSimRemoteOperations.class);
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
    orb.own(setUp.rows, ResultCursorOperations.class).nextBlock(0, 0, new ResultBlockHolder());
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

  /**
   * Begins to read and build a model in a thread of its own, while a process that serves only
   * itself starts its ORB: each of the two loads about a thousand classes that the other does not
   * need. A server that stays does more, see {@link #begin}.
   */
  public static void beginToBuild() {
    Thread thread = new Thread(WarmUp::buildLogged, "mechservice-head-start");
    thread.setDaemon(true);
    thread.start();
  }

  private static void buildLogged() {
    try {
      build();
    } catch (MechmlException | InvalidOption | IOException | RuntimeException e) {
      LOG.warn(MessageCode.INTERNAL_SERVER_ERROR + " the model will take longer: {}", e.toString());
    }
  }

  /** Reads and builds the model; returns the number of its warnings. */
  static int build() throws MechmlException, InvalidOption, IOException {
    LoadedModel model = LoadedModel.read(MODEL, content(), List.of(), false);
    BuildOptions options =
        SimulationRequest.asInFile(model.model()).forRun(model.model().settings());
    try (ModelLibrary library = new ModelLibrary()) {
      library.compiled(model, options, new SetUpTimes());
    }
    return model.warnings().size();
  }

  /** Stops the warm-up of a host that is closing; its failures are not logged any more. */
  @Override
  public void close() {
    closed = true;
  }

  /** A client whose callbacks do nothing. */
  private static final class SilentClient implements IMechClientOperations {
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
