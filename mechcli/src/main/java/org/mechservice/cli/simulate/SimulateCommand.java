package org.mechservice.cli.simulate;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.concurrent.Callable;
import org.mechservice.cli.model.ModelOptions;
import org.mechservice.cli.model.ParameterOption;
import org.mechservice.cli.model.SceneReader;
import org.mechservice.cli.model.UserCodeOption;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.FailureReport;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.ServerOption;
import org.mechservice.cli.shell.ServiceConnection;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.failure.LimitExceededException;
import org.mechservice.client.failure.ServerLostException;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.client.run.CheckpointStore;
import org.mechservice.client.run.PreparedRun;
import org.mechservice.client.run.RemoteRun;
import org.mechservice.client.run.RunProgress;
import org.mechservice.client.run.RunResult;
import org.mechservice.guard.Confinement;
import org.mechservice.idl.OPT_T_STEP;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.view.scene.SceneDescription;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech simulate}: one run of one model, results to files, report to the terminal. */
@Command(
    name = "simulate",
    description = "Runs a model and writes its results.",
    footer = {
      "mech simulate model.xml --out r.csv",
      "mech simulate model.xml --set k=2e4 --rtol 1e-8 --columns energy,reactions --out r.mat",
      "mech simulate model.xml --server sim.example.org --tls keys/ann --out r.csv"
    },
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class SimulateCommand implements Callable<Integer> {
  /** The place where a run is computed. */
  enum Mode {
    REMOTE,
    LOCAL
  }

  @Parameters(paramLabel = "MODEL.xml", description = "Model in MechML.")
  private Path model = Path.of("");

  @Option(
      names = "--mode",
      paramLabel = "remote|local",
      description =
          "Run at the server, or fetch the compiled model and run it here (default: remote).")
  private Mode mode = Mode.REMOTE;

  @Mixin private ServerOption server = new ServerOption();

  @Mixin private UserCodeOption userCode = new UserCodeOption();

  @Option(names = "--host", paramLabel = "NAME", description = "Host of the server to run on.")
  private String host = "";

  @Mixin private ModelOptions method = new ModelOptions();

  @Mixin private ParameterOption parameters = new ParameterOption();

  @Mixin private ToleranceOptions run = new ToleranceOptions();

  @Mixin private ResultOptions results = new ResultOptions();

  @Mixin private CheckpointOptions checkpoints = new CheckpointOptions();

  @Option(
      names = "--strict",
      description = "Take warnings for errors, those before the run and those of the run.")
  private boolean strict;

  @Option(
      names = "--max-drift",
      paramLabel = "R",
      description =
          "End the run as failed where its energy balance drifts by more than R times the energy"
              + " scale.")
  private Optional<Double> maxDrift = Optional.empty();

  /** Pauses while no host of the server takes sessions, ms. */
  private static final long[] NO_HOST_PAUSES_MILLIS = {500, 1500, 3000, 5000};

  /** Pauses before another session is opened, ms; a service manager restarts hosts. */
  private static final long[] SET_UP_PAUSES_MILLIS = {500, 1500, 3000, 5000, 10_000, 10_000};

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException {
    results.requireUsable(true);
    checkpoints.requireUsable(results.files());
    CheckpointStore store = checkpoints.open(lost -> err().println(lost));
    SimulationOptions options = options();
    List<AnimationFile> animations = animations();
    if (mode == Mode.LOCAL && !server.address().isEmpty()) {
      Confinement.probeAhead();
    }
    try (CancelOnInterrupt interrupt = new CancelOnInterrupt();
        ServiceConnection service = ServiceConnection.open(server, userCode.consent());
        Attempt attempt = new Attempt(service.connection())) {
      interrupt.cancels(attempt::close);
      RunFollower news = new RunFollower(this::printNews);
      try (PreparedRun run = attempt.setUp(options, news);
          ResultFiles files = results.open(expectedRows(attempt.session(), run), animations)) {
        interrupt.cancelsRun(run);
        String id = printIdentity(run);
        return simulate(run, id, news, files, store);
      } catch (ServiceException e) {
        if (!interrupt.endsSetUp()) {
          throw e;
        }
        err().println(MessageCode.RUN_STOPPED + " the set-up was stopped; there are no rows.");
        return ExitStatus.INTERRUPTED;
      }
    }
  }

  /** The set-up of the run, which begins again in a new session if its host dies. */
  private final class Attempt implements AutoCloseable {
    private final MechConnection connection;
    private volatile MechSession session;
    private volatile boolean closed;

    Attempt(MechConnection connection) {
      this.connection = connection;
      session = opened();
    }

    /** Opens a session; where no host takes one, waits for those that are coming back just now. */
    private MechSession opened() {
      for (long pause : NO_HOST_PAUSES_MILLIS) {
        try {
          return connection.openSession(host);
        } catch (LimitExceededException e) {
          if (!e.code().equals(MessageCode.NO_PLACE_FOR_SESSION.code())) {
            throw e;
          }
          pauseOr(pause, e);
        }
      }
      return connection.openSession(host);
    }

    private void pauseOr(long millis, ServiceException refused) {
      try {
        Thread.sleep(millis);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw refused;
      }
    }

    MechSession session() {
      return session;
    }

    PreparedRun setUp(SimulationOptions options, RunFollower news) throws IOException {
      for (long pause : SET_UP_PAUSES_MILLIS) {
        try {
          return SimulateCommand.this.setUp(session, options, news);
        } catch (ServerLostException lost) {
          if (closed || server.address().isEmpty()) {
            throw lost;
          }
          printNews(lost.getMessage() + "; the model is set up again");
          renew(lost, pause);
        }
      }
      return SimulateCommand.this.setUp(session, options, news);
    }

    /** Opens a session on a host that is there; hosts may be coming back just now. */
    private void renew(ServerLostException lost, long pause) {
      MechSession gone = session;
      Thread abandoned = new Thread(gone::close, "mech-abandon"); // may wait for its timeout
      abandoned.setDaemon(true);
      abandoned.start();
      pauseOr(pause, lost);
      try {
        session = opened();
      } catch (ServiceException e) {
        lost.addSuppressed(e); // the next attempt fails at once, and waits longer
      }
    }

    @Override
    public void close() {
      closed = true;
      session.close();
    }
  }

  /** Loads the model and prepares its run; shows on a terminal that this is going on. */
  private PreparedRun setUp(MechSession session, SimulationOptions options, RunFollower news)
      throws IOException {
    ProgressDisplay display = ProgressDisplay.ofSetUp(results.talks());
    try {
      session.loadModel(model, userCode.consent());
      return prepare(session, options, news, display);
    } finally {
      display.close();
    }
  }

  /**
   * Prints the run's id: after this process dies, the run can be found by it.
   *
   * @return the id; empty if the run is in this process
   */
  private String printIdentity(PreparedRun run) {
    if (!(run instanceof RemoteRun remote) || server.address().isEmpty()) {
      return "";
    }
    String id = remote.id();
    if (results.talks()) {
      err().println("simulation " + id);
      err().flush();
    }
    return id;
  }

  private void printNews(String news) {
    if (results.talks()) {
      err().println(news);
      err().flush();
    }
  }

  /**
   * Prepares the run and prints the warnings of the model, which are known even if the run is
   * refused.
   */
  private PreparedRun prepare(
      MechSession session, SimulationOptions options, RunFollower news, ProgressDisplay display)
      throws IOException {
    try {
      return switch (mode) {
        case REMOTE -> session.prepareRemoteRun(options, news);
        case LOCAL -> news.watch(session.prepareLocalRun(options));
      };
    } finally {
      display.close();
      if (!results.quiet() && !strict) {
        session.warnings().forEach(warning -> err().println(warning));
      }
    }
  }

  private List<AnimationFile> animations() throws IOException {
    if (results.animated().isEmpty()) {
      return List.of();
    }
    SceneDescription scene = SceneReader.read(model, method.reading(parameters.values()));
    Path folder = Optional.ofNullable(model.toAbsolutePath().getParent()).orElse(model);
    List<AnimationFile> animations =
        results.animated().stream()
            .map(target -> new AnimationFile(target, scene, folder))
            .toList();
    if (!results.quiet()) {
      animations.get(0).warnings().forEach(warning -> err().println(warning));
    }
    return animations;
  }

  /** Animated scenes need the columns of the bodies; alone, they need no others. */
  private SimulationOptions options() throws IOException {
    SimulationOptions options =
        run.addTo(method.addTo(parameters.addTo(SimulationOptions.asInFile())));
    if (!results.animated().isEmpty()) {
      Set<ColumnGroup> groups = EnumSet.of(ColumnGroup.BODIES);
      if (options.columnGroups().isPresent()) {
        groups.addAll(options.columnGroups().get());
      } else if (results.animated().size() < results.files().size()) {
        groups.addAll(SceneReader.columns(model, method.reading(parameters.values())));
      }
      options = options.columns(groups);
    }
    SimulationOptions all = options;
    SimulationOptions watched = maxDrift.map(all::maxDrift).orElse(all);
    return strict ? watched.strict() : watched;
  }

  /**
   * Returns how many rows the run puts out, if a file has a limit and the number is known before
   * the run. The server tells the distance of the rows of the file's first simulation only.
   */
  private OptionalLong expectedRows(MechSession session, PreparedRun prepared) {
    boolean known = run.outputStep().isPresent() || !method.choosesSimulation();
    if (!known || !ResultFiles.haveLimit(results.files())) {
      return OptionalLong.empty();
    }
    double step =
        run.outputStep()
            .orElseGet(() -> Double.valueOf(session.model().settings().get(OPT_T_STEP.value)));
    RunProgress interval = prepared.progress();
    double steps = (interval.endTime() - interval.startTime()) / step;
    return OptionalLong.of(1 + (long) Math.ceil(steps));
  }

  private int simulate(
      PreparedRun run, String id, RunFollower news, ResultFiles files, CheckpointStore store)
      throws IOException {
    RunResult result;
    ProgressDisplay display = ProgressDisplay.of(news, results.talks());
    try {
      result = run.toEnd(files, store);
    } catch (ServiceException e) {
      int status = FailureReport.status(e);
      // Rows that came before a server was lost are good; what bad input left is not.
      err()
          .println(
              e.getMessage()
                  + (status == ExitStatus.SERVER
                      ? fetchAdvice(id) + ResultOptions.keptRows(files)
                      : ""));
      return status;
    } finally {
      display.close();
    }
    if (results.talks()) {
      news.warnings().forEach(warning -> err().println(warning));
    }
    return results.report(result, files);
  }

  /** Returns how the rows of a run are fetched when its lost server is there again. */
  private String fetchAdvice(String id) {
    return id.isEmpty()
        ? ""
        : "; if the server was started with --spool, its rows can be fetched when it runs again:"
            + " mech fetch "
            + id
            + " --server "
            + server.address();
  }

  private PrintWriter err() {
    return spec.commandLine().getErr();
  }
}
