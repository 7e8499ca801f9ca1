package org.mechservice.client;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.mechservice.client.failure.InvalidModelException;
import org.mechservice.client.failure.InvalidOptionException;
import org.mechservice.client.failure.InvalidStateException;
import org.mechservice.client.failure.JarRefusedException;
import org.mechservice.client.failure.LimitExceededException;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.client.failure.RemoteCalls;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.client.failure.SetUpCalls;
import org.mechservice.client.jar.BuiltJar;
import org.mechservice.client.jar.JarFetch;
import org.mechservice.client.jar.LocalModel;
import org.mechservice.client.jar.LocalRuns;
import org.mechservice.client.run.HostedRun;
import org.mechservice.client.run.LeaseRenewal;
import org.mechservice.client.run.ListenerCallbacks;
import org.mechservice.client.run.LocalRun;
import org.mechservice.client.run.RemoteRun;
import org.mechservice.client.run.RowCursor;
import org.mechservice.client.run.RunListener;
import org.mechservice.guard.UserCode;
import org.mechservice.guard.worker.WorkerProcess;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MAX_MECHML_BYTES;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.ModelReading;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NameValueSeqHolder;
import org.mechservice.idl.OPT_CONTINUES;
import org.mechservice.idl.RunSetUp;
import org.mechservice.idl.RuntimeInfo;
import org.mechservice.orb.connection.LimitedBuffers;
import org.mechservice.solver.api.program.SteppedModel;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.ModelFiles;

/**
 * One model at a server: load it once, then check it, run it at the server, fetch it and run it on
 * this machine, or build a JAR of it. The session is kept alive until it is closed. For one thread.
 */
public final class MechSession implements AutoCloseable {
  /**
   * Largest model text, such that the message with all arguments is within the bound of the ORB.
   */
  private static final int MOST_SENT_BYTES = LimitedBuffers.MAX_MESSAGE_BYTES - (1 << 20);

  private final RemoteCalls calls;
  private final SetUpCalls setUp;
  private final MechConnection connection;
  private final ServiceDescription service;
  private final MechSim session;
  private final LeaseRenewal.Hold hold;
  private final double openSeconds;
  private double loadSeconds;
  private ModelFile modelLoaded = new ModelFile("", new byte[0]);
  private ModelFile[] classesLoaded = {};
  private UnaryOperator<ModelMessage> locating = UnaryOperator.identity();
  private List<ModelMessage> warningsOfFile = List.of();
  private UserCode consent = UserCode.NONE;
  private List<ModelMessage> warnings = List.of();

  /** Server times of the session at the last set-up of a run. */
  private ServerTimes soFar = ServerTimes.NONE;

  /**
   * @param service the server that opened it
   * @param openSeconds time to open it, s
   */
  MechSession(
      MechConnection connection,
      RemoteCalls calls,
      ServiceDescription service,
      MechSim session,
      double openSeconds) {
    this.connection = connection;
    this.calls = calls;
    setUp = connection.setUpCalls(calls, session);
    this.service = service;
    this.session = session;
    this.openSeconds = openSeconds;
    hold = connection.leases().hold(session);
  }

  /** Returns the session's identity at the server. */
  public String id() {
    return calls.get(session::sessionId);
  }

  /** Returns the name of the session's host. */
  public String hostName() {
    return calls.get(session::hostName);
  }

  /**
   * Sends a model without classes of users to the server, which reads and checks it.
   *
   * @see #loadModel(Path, UserCode)
   */
  public List<ModelMessage> loadModel(Path file) throws IOException {
    return loadModel(file, UserCode.NONE);
  }

  /**
   * Sends a model to the server, which reads and checks it, and its user force classes.
   *
   * @param file MechML file
   * @param consent the folders whose classes may be sent, and run there or here
   * @return warnings, in the order of the file
   * @throws IOException if the file cannot be read
   * @throws InvalidModelException if the model cannot be used; the messages name the places
   */
  public List<ModelMessage> loadModel(Path file, UserCode consent) throws IOException {
    byte[] content = ModelFiles.inlined(NamedFile.of(file), file);
    String name = String.valueOf(file.getFileName());
    this.consent = consent;
    UserFiles classes = new UserFiles(file, consent);
    while (true) {
      try {
        List<ModelMessage> said = load(new ModelFile(name, content), classes.files());
        locating = message -> located(message, name, file);
        warningsOfFile = said.stream().map(locating).toList();
        warnings = warningsOfFile;
        return warnings;
      } catch (InvalidModelException e) {
        if (!classes.seek(e.messages())) {
          throw new InvalidModelException(
              e.code(),
              String.valueOf(e.getMessage()),
              e.messages().stream().map(said -> located(said, name, file)).toList());
        }
      }
    }
  }

  /** The server only knows the file's name; the user wrote a path. */
  private static ModelMessage located(ModelMessage said, String name, Path file) {
    return said.fileName().equals(name) ? said.inFile(file.toString()) : said;
  }

  /**
   * Sends a model to the server, which reads and checks it.
   *
   * @param fileName name that messages will use
   * @param content the MechML text's bytes
   * @return warnings, in the order of the file
   * @throws InvalidModelException if the model cannot be used; says what and where
   */
  public List<ModelMessage> loadModel(String fileName, byte[] content) {
    return load(new ModelFile(fileName, content), new ModelFile[0]);
  }

  /**
   * Returns the warnings of the run prepared last, which depend on its options such as integrator
   * and end time; before the first run, those of the file.
   */
  public List<ModelMessage> warnings() {
    return warnings;
  }

  private void keepWarnings(SetUpFacts said) {
    warnings =
        said.warnings().map(those -> those.stream().map(locating).toList()).orElse(warningsOfFile);
  }

  private List<ModelMessage> load(ModelFile model, ModelFile[] classes) {
    Stopwatch watch = new Stopwatch();
    var said =
        setUp.get(
            patient -> {
              requireSendable(model, classes);
              return patient.loadModel(model, classes);
            });
    loadSeconds = watch.lap();
    modelLoaded = model;
    classesLoaded = classes;
    soFar = ServerTimes.NONE;
    locating = UnaryOperator.identity();
    warningsOfFile = ModelMessage.listOf(said);
    warnings = warningsOfFile;
    return warnings;
  }

  /** Rejects files that do not fit into a message; a server would close the connection. */
  private static void requireSendable(ModelFile model, ModelFile[] classes) throws LimitExceeded {
    long bytes = model.content.length;
    for (ModelFile file : classes) {
      bytes += file.content.length;
    }
    if (bytes > MOST_SENT_BYTES) {
      throw new LimitExceeded(
          MessageCode.MODEL_TOO_LARGE.code(),
          "the model has " + bytes + " bytes; servers take at most " + MAX_MECHML_BYTES.value,
          "modelBytes",
          MAX_MECHML_BYTES.value,
          bytes);
    }
  }

  /**
   * Returns the server's summary of the model.
   *
   * @throws InvalidStateException if none is loaded
   */
  public ModelSummary model() {
    return ModelSummary.of(calls.get(session::getModelInfo));
  }

  /**
   * Returns the server's report about the model: topology, degrees of freedom, suspicious values.
   *
   * @param asJson whether as one JSON object instead of text
   * @throws InvalidStateException if no model is loaded
   */
  public String checkReport(boolean asJson) {
    return checkReport(SimulationOptions.asInFile(), asJson);
  }

  /**
   * Returns the server's report about the model as options make it.
   *
   * @throws InvalidModelException if the model cannot be used so
   */
  public String checkReport(SimulationOptions options, boolean asJson) {
    NameValue[] asked = options.toNameValues();
    try {
      return asked.length == 0
          ? setUp.get(patient -> patient.checkReport(asJson))
          : setUp.get(patient -> patient.checkReportWith(asked, asJson));
    } catch (LimitExceededException e) {
      if (!e.limit().equals(RemoteCalls.MESSAGE_BYTES)) {
        throw e;
      }
      return checkReportInParts(options, asJson);
    }
  }

  /** Returns a report that is larger than a message. */
  private String checkReportInParts(SimulationOptions options, boolean asJson) {
    StringBuilder report = new StringBuilder();
    for (int i = 0; ; i++) {
      NameValue[] next = options.textPart(i).toNameValues();
      String part = setUp.get(patient -> patient.checkReportWith(next, asJson));
      if (part.isEmpty()) {
        return report.toString();
      }
      report.append(part);
    }
  }

  /**
   * Reads the model at the server with options, which it checks.
   *
   * @throws InvalidModelException if the model cannot be used so
   * @throws InvalidOptionException if an option cannot be used
   */
  ModelReading read(SimulationOptions options) {
    return calls.get(() -> session.readWith(options.toNameValues()));
  }

  /**
   * Returns the Java classes that the server generates for the model, the equations first; together
   * they compile to the model. With {@link SimulationOptions#inC} these are the files of the model
   * in C.
   *
   * @throws InvalidOptionException if an option cannot be used
   */
  public List<GeneratedSource> generatedSources(SimulationOptions options) {
    List<GeneratedSource> sources = new ArrayList<>();
    ModelFile source = setUp.get(patient -> patient.generatedSource(options.toNameValues()));
    while (!source.fileName.isEmpty()) {
      String text = new String(source.content, StandardCharsets.UTF_8);
      sources.add(new GeneratedSource(source.fileName, text));
      SimulationOptions next = options.sourcePart(sources.size());
      source = calls.get(() -> session.generatedSource(next.toNameValues()));
    }
    return sources;
  }

  /**
   * Prepares a run at the server.
   *
   * @throws InvalidOptionException if an option cannot be used
   * @throws LimitExceededException if the host takes no more runs
   */
  public RemoteRun prepareRemoteRun(SimulationOptions options) {
    return createRun(options, null, message -> {});
  }

  /**
   * Prepares a run at the server.
   *
   * @param listener receives state, progress and messages of the run
   * @throws InvalidOptionException if an option cannot be used
   * @throws LimitExceededException if the host takes no more runs
   */
  public RemoteRun prepareRemoteRun(SimulationOptions options, RunListener listener) {
    ListenerCallbacks callbacks = new ListenerCallbacks(listener);
    return createRun(options, connection.export(callbacks), callbacks::passOn);
  }

  private RemoteRun createRun(
      SimulationOptions options, @Nullable IMechClient callback, Consumer<ModelMessage> listener) {
    ModelFile model = modelLoaded;
    ModelFile[] classes = classesLoaded;
    HostedRun first = place(options, callback);
    return new RemoteRun(
        first,
        earlierIds -> elsewhere(first, model, classes, options, callback, earlierIds),
        listener);
  }

  /**
   * Sets up a run in a new session, on any host of any server with a free place; on the host that
   * had it, if that goes on and no other takes it.
   */
  private HostedRun elsewhere(
      HostedRun first,
      ModelFile model,
      ModelFile[] classes,
      SimulationOptions options,
      @Nullable IMechClient callback,
      List<String> earlierIds) {
    try {
      return in(connection.openSessionAnywhere(), model, classes, options, callback, earlierIds);
    } catch (ServiceException e) {
      try {
        MechSession same = connection.openSession(first.hostName());
        return in(same, model, classes, options, callback, earlierIds);
      } catch (ServiceException own) {
        e.addSuppressed(own);
        throw e;
      }
    }
  }

  /** Sets up a run in a new session, which ends with it. */
  private static HostedRun in(
      MechSession other,
      ModelFile model,
      ModelFile[] classes,
      SimulationOptions options,
      @Nullable IMechClient callback,
      List<String> earlierIds) {
    try {
      other.load(model, classes);
      SimulationOptions named =
          other.service.findsMovedRuns()
              ? options.with(OPT_CONTINUES.value, String.join(",", earlierIds))
              : options;
      return other.place(named, callback).endingWith(other.hold);
    } catch (ServiceException e) {
      other.close();
      throw e;
    }
  }

  private HostedRun place(SimulationOptions options, @Nullable IMechClient callback) {
    Stopwatch watch = new Stopwatch();
    RunSetUp answer =
        setUp.get(patient -> patient.prepareSimulation(options.toNameValues(), callback));
    double seconds = watch.lap();
    LeaseRenewal leases = connection.leases();
    SetUpFacts said = new SetUpFacts(answer.facts);
    keepWarnings(said);
    ServerTimes times = timesOfRun(said);
    Map<String, Object> facts = new LinkedHashMap<>();
    facts.put("where", "remote, host " + said.hostName());
    facts.putAll(said.ofModel());
    facts.put("serverVersion", service.version());
    facts.putAll(
        SetUpReport.remote(loadSeconds, seconds, times, openSeconds + loadSeconds + seconds));
    return new HostedRun(
        calls,
        said.hostName(),
        session,
        answer.simulation,
        leases.hold(answer.simulation),
        RowCursor.over(calls, leases, answer.rows, answer.columns),
        facts,
        Optional.empty());
  }

  /** Returns the server times since the last call. */
  private ServerTimes timesOfRun(SetUpFacts said) {
    ServerTimes now = said.times();
    ServerTimes ofRun = now.since(soFar);
    soFar = now;
    return ofRun;
  }

  /**
   * Prepares a run on this machine: fetches the compiled model and verifies it. It runs with the
   * solver of this program in a process behind the walls of classes of users; where the solver of
   * the server differs and is accepted, with that, in this process.
   *
   * @throws InvalidOptionException if an option cannot be used
   * @throws JarRefusedException if a JAR is not the one announced or does not fit this client, or
   *     its classes cannot be confined here
   * @throws IOException if no process can be started
   */
  public LocalRun prepareLocalRun(SimulationOptions options) throws IOException {
    return withWorker(begun -> prepareLocalRun(options, begun));
  }

  /** What is prepared with a process for the model; empty if the model runs in this one. */
  private interface Preparation<T> {
    T with(Optional<CompletableFuture<WorkerProcess>> begun) throws IOException;
  }

  /** Begins to start a process while the model is on its way; it ends if nothing comes of it. */
  private <T> T withWorker(Preparation<T> preparation) throws IOException {
    if (connection.isOwn()) {
      return preparation.with(Optional.empty());
    }
    CompletableFuture<WorkerProcess> begun = LocalRuns.beginWorker();
    boolean prepared = false;
    try {
      T made = preparation.with(Optional.of(begun));
      prepared = true;
      return made;
    } finally {
      if (!prepared) {
        LocalRuns.end(begun);
      }
    }
  }

  /**
   * Prepares a run on this machine that is stepped from outside, where {@link #prepareLocalRun}
   * would compute it.
   *
   * @param options of a build with inputs from outside
   * @throws InvalidOptionException if an option cannot be used
   * @throws JarRefusedException as of {@link #prepareLocalRun}
   * @throws IOException if no process can be started
   */
  public SteppedModel.Source prepareSteps(SimulationOptions options) throws IOException {
    return withWorker(
        begun -> {
          Fetched fetched = fetched(options);
          LocalRuns runs = localRuns(options, fetched.said());
          if (begun.isPresent() && fetched.runtimeJar().isEmpty()) {
            return runs.confinedSteps(fetched.modelJar(), begun.get());
          }
          begun.ifPresent(LocalRuns::end);
          return runs.stepsHere(fetched.modelJar(), fetched.runtimeJar());
        });
  }

  /** A model that was built for this machine, with the solver it needs, if that is not our own. */
  private record Fetched(BuiltJar modelJar, Optional<byte[]> runtimeJar, SetUpFacts said) {}

  private Fetched fetched(SimulationOptions options) {
    NameValueSeqHolder answer = new NameValueSeqHolder(new NameValue[0]);
    JarFetch jars = jars();
    BuiltJar modelJar = jars.model(options.toNameValues(), answer);
    SetUpFacts said = new SetUpFacts(answer.value);
    keepWarnings(said);
    return new Fetched(modelJar, jars.runtime(modelJar), said);
  }

  private LocalRuns localRuns(SimulationOptions options, SetUpFacts said) {
    return new LocalRuns(
        options.columnGroups(), options.isStrict(), options.driftBound(), said.silenced(), consent);
  }

  /**
   * @param begun a process for the model; empty if it runs in this one
   */
  private LocalRun prepareLocalRun(
      SimulationOptions options, Optional<CompletableFuture<WorkerProcess>> begun)
      throws IOException {
    Stopwatch watch = new Stopwatch();
    Fetched fetched = fetched(options);
    BuiltJar modelJar = fetched.modelJar();
    Optional<byte[]> runtimeJar = fetched.runtimeJar();
    SetUpFacts said = fetched.said();
    double fetchSeconds = watch.lap();
    LocalRuns runs = localRuns(options, said);
    LocalRuns.Prepared prepared;
    if (begun.isPresent() && runtimeJar.isEmpty()) {
      prepared = runs.confined(modelJar, begun.get());
    } else {
      begun.ifPresent(LocalRuns::end);
      prepared = runs.here(modelJar, runtimeJar);
    }
    double total = openSeconds + loadSeconds + fetchSeconds + watch.lap();
    Map<String, Object> facts = new LinkedHashMap<>();
    facts.put("where", "local, compiled by host " + said.hostName());
    prepared.formulationReason().ifPresent(reason -> facts.put("formulationReason", reason));
    said.ofModel().forEach(facts::putIfAbsent);
    facts.put("serverVersion", service.version());
    ServerTimes ofRun = timesOfRun(said);
    facts.putAll(SetUpReport.local(loadSeconds, fetchSeconds, ofRun, total));
    facts.put("modelJarBytes", (long) modelJar.bytes().length);
    facts.put("modelClassBytes", modelJar.modelClassBytes());
    facts.put("runtimeJarBytes", runtimeJarBytes());
    return prepared.run(facts);
  }

  /**
   * Fetches the compiled model for callers that run it themselves: its classes have all rights of
   * this program then.
   *
   * @throws InvalidOptionException if an option cannot be used
   * @throws JarRefusedException if a JAR is not the one announced or does not fit this client, or
   *     the server is not part of this program and there is no consent to unconfined code (S-168)
   */
  public LocalModel fetchModel(SimulationOptions options) {
    JarFetch jars = jars();
    BuiltJar modelJar =
        jars.model(options.toNameValues(), new NameValueSeqHolder(new NameValue[0]));
    Optional<byte[]> runtimeJar = jars.runtime(modelJar);
    if (!connection.isOwn() && runtimeJar.isEmpty() && !consent.isUnconfined()) {
      throw new JarRefusedException(
          MessageCode.NO_CONFINEMENT.code(),
          "the classes of the model come from the server and would have all rights of this program"
              + " here; run or step the model, which is confined, or consent with --unconfined (in a"
              + " program, with UserCode.unconfined)");
    }
    return new LocalModel(modelJar, runtimeJar, consent);
  }

  /**
   * Builds a JAR of the model.
   *
   * @param standalone whether it contains the necessary solver classes and starts with {@code java
   *     -jar}
   * @throws InvalidOptionException if an option cannot be used
   * @throws JarRefusedException if what arrives is not what was announced
   */
  public BuiltJar build(SimulationOptions options, boolean standalone) {
    SimulationOptions asked = standalone ? options.standalone() : options;
    return jars().model(asked.toNameValues(), new NameValueSeqHolder(new NameValue[0]));
  }

  private JarFetch jars() {
    return new JarFetch(
        calls,
        setUp,
        session,
        connection.cache(),
        connection.acceptedSolvers(),
        service.version(),
        connection.originOf(session));
  }

  /** Returns the size of the server's runtime JAR, bytes. */
  public long runtimeJarBytes() {
    RuntimeInfo runtime = calls.get(session::getRuntimeInfo);
    return runtime.sizeBytes;
  }

  /** Destroys the session and its objects at the server. */
  @Override
  public void close() {
    hold.close();
  }
}
