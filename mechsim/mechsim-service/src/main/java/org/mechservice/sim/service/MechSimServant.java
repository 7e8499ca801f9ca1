package org.mechservice.sim.service;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.InvalidModel;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.InvalidState;
import org.mechservice.idl.JarInfo;
import org.mechservice.idl.JarInfoHolder;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MAX_WAIT_MILLIS;
import org.mechservice.idl.MechSimOperations;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.ModelInfo;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NameValueSeqHolder;
import org.mechservice.idl.NotAvailable;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.Parameter;
import org.mechservice.idl.RoadmapEntry;
import org.mechservice.idl.RunSetUp;
import org.mechservice.idl.RuntimeInfo;
import org.mechservice.idl.ServerFailure;
import org.mechservice.idl.SimEvent;
import org.mechservice.idl.SimState;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.CheckReport;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.model.GeneratedFacts;
import org.mechservice.sim.model.GeneratedModel;
import org.mechservice.sim.model.JarImage;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.model.SourceFile;
import org.mechservice.sim.user.UserFile;
import org.mechservice.solver.api.RunRequest;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.simulation.SolverVersion;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** One client's session: a model file goes in, simulations and JARs come out. */
final class MechSimServant implements MechSimOperations {
  private static final Logger LOG = LoggerFactory.getLogger(MechSimServant.class);

  private final Session session;
  private final ModelLibrary library;
  private final RunFactory runs;
  private final Admission admission;
  private final Runnable destroyed;
  private final SetUpTimes times = new SetUpTimes();
  private volatile Optional<LoadedModel> loaded = Optional.empty();

  /**
   * @param admission decides whether one more simulation is taken
   * @param destroyed runs when the client ends the session
   */
  MechSimServant(
      Session session,
      ModelLibrary library,
      RunFactory runs,
      Admission admission,
      Runnable destroyed) {
    this.admission = admission;
    this.session = session;
    this.library = library;
    this.runs = runs;
    this.destroyed = destroyed;
  }

  @Override
  public String sessionId() {
    return session.id();
  }

  @Override
  public String hostName() {
    return session.host().hostName();
  }

  @Override
  public Diagnostic[] loadModel(ModelFile mechml, ModelFile[] userFiles)
      throws InvalidModel, LimitExceeded {
    requireAllowedSize(mechml, userFiles);
    long start = System.nanoTime();
    try {
      LoadedModel read =
          LoadedModel.read(
              mechml.fileName,
              mechml.content,
              Stream.of(userFiles).map(file -> new UserFile(file.fileName, file.content)).toList(),
              session.host().userCode());
      times.addTreating(System.nanoTime() - start);
      loaded = Optional.of(read);
      generateAhead(read);
      return Wire.diagnostics(read.warnings());
    } catch (MechmlException e) {
      throw Refusal.model(e.diagnostics());
    }
  }

  private void requireAllowedSize(ModelFile mechml, ModelFile[] userFiles) throws LimitExceeded {
    long bytes = mechml.content.length;
    for (ModelFile file : userFiles) {
      bytes += file.content.length;
    }
    long most = session.limits().of(HostLimit.MODEL_BYTES);
    if (bytes > most) {
      throw HostLimit.MODEL_BYTES.refusal(
          most, bytes, "the model has " + bytes + " bytes; this server takes at most " + most);
    }
  }

  /** Most runs are as the file says; what does not fit is said when a run is asked for. */
  private void generateAhead(LoadedModel read) {
    SimulationSettings settings = read.model().settings();
    try {
      RunOptions asInFile =
          RunOptions.parse(new NameValue[0], settings).suiting(read.model().mechanism());
      library.generated(read, asInFile.forRun(settings), times);
    } catch (InvalidOption | IllegalArgumentException e) {
      LOG.debug("the model cannot be run as its file says", e);
    }
  }

  private LoadedModel requireModel() throws InvalidState {
    return loaded.orElseThrow(
        () -> Refusal.state(SimState.SIM_CREATED, "no model is loaded; call loadModel first"));
  }

  /** Returns the model as the options of a request want it read. */
  private LoadedModel requireModel(NameValue[] options)
      throws InvalidState, InvalidOption, InvalidModel {
    try {
      return requireModel().with(ModelOptions.parse(options));
    } catch (MechmlException e) {
      throw Refusal.model(e.diagnostics());
    }
  }

  private static RunOptions suiting(NameValue[] options, LoadedModel model) throws InvalidOption {
    return RunOptions.parse(options, model.model().settings()).suiting(model.model().mechanism());
  }

  @Override
  public ModelInfo getModelInfo() throws InvalidState {
    return ModelFacts.info(requireModel());
  }

  @Override
  public Parameter[] parameters() throws InvalidState {
    return requireModel().model().parameters().stream()
        .map(p -> new Parameter(p.name(), p.unit(), p.value(), p.tunable()))
        .toArray(Parameter[]::new);
  }

  @Override
  public RoadmapEntry[] roadmap() throws InvalidState {
    return ModelFacts.roadmap(requireModel());
  }

  @Override
  public String checkReport(boolean asJson) throws InvalidState {
    CheckReport report = CheckReport.of(requireModel().model());
    return asJson ? report.json() : report.text();
  }

  @Override
  public ModelFile generatedSource(NameValue[] options)
      throws InvalidModel, InvalidOption, InvalidState, NotAvailable, ServerFailure {
    LoadedModel model = requireModel(options);
    RunOptions asked = suiting(options, model);
    GeneratedModel generated =
        Built.orRefused(() -> library.generated(model, asked.forJar(), times));
    List<SourceFile> sources = generated.sources();
    int part = RunOptions.sourcePart(options);
    if (part >= sources.size()) {
      return new ModelFile("", new byte[0]);
    }
    SourceFile source = sources.get(part);
    return new ModelFile(
        source.className().replace('.', '/') + ".java",
        source.text().getBytes(StandardCharsets.UTF_8));
  }

  @Override
  public IMechSimRemote createSimulation(NameValue[] options, @Nullable IMechClient client)
      throws InvalidModel, InvalidOption, InvalidState, NotAvailable, LimitExceeded, ServerFailure {
    return created(options, client).reference();
  }

  @Override
  public RunSetUp prepareSimulation(NameValue[] options, @Nullable IMechClient client)
      throws InvalidModel, InvalidOption, InvalidState, NotAvailable, LimitExceeded, ServerFailure {
    Created created = created(options, client);
    try {
      return new RunSetUp(
          created.reference(),
          session.openRows(created.run()),
          Wire.channels(created.run().columns().variables()),
          facts(created.formulationReason(), created.warnings()));
    } catch (LimitExceeded e) {
      session.destroy(created.run());
      throw e;
    }
  }

  /** What the report of a run says of its set-up, as far as this side knows it. */
  private NameValue[] facts(String formulationReason, Map<String, String> warnings)
      throws InvalidState {
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("hostName", hostName());
    facts.put("modelSha256", requireModel().sha256());
    facts.put("formulationReason", formulationReason);
    times.asMap().forEach((name, seconds) -> facts.put(name, Double.toString(seconds)));
    facts.putAll(warnings);
    return Wire.nameValues(facts);
  }

  /** A simulation that was taken in. */
  private record Created(
      SimulationRun run,
      IMechSimRemote reference,
      String formulationReason,
      Map<String, String> warnings) {}

  private Created created(NameValue[] options, @Nullable IMechClient client)
      throws InvalidModel, InvalidOption, InvalidState, NotAvailable, LimitExceeded, ServerFailure {
    admission.requirePlace(session);
    LoadedModel source = requireModel(options);
    SimulationSettings ofFile = source.model().settings();
    RunOptions asked = suiting(options, source);
    requireNoWarnings(source, asked);
    CompiledModel compiled =
        Built.orRefused(() -> library.compiled(source, asked.forRun(ofFile), times));
    requireUserCodeAllowed(compiled, source);
    RunRequest request =
        new RunRequest(asked.settings(), asked.columns(), asked.strict(), asked.maxDrift());
    long memory = session.limits().of(HostLimit.MEMORY);
    RunTask task = Built.orRefused(() -> runs.task(compiled, request, memory));
    RunColumns columns = Built.orRefused(() -> runs.columns(task.model(), request));
    RunFacts facts = RunFacts.of(session.host().hostName(), source, compiled.generated(), times);
    SimulationRun run = runs.create(task, columns, source, facts, session, asked.earlierIds());
    IMechSimRemote reference = session.add(run, client);
    session.said(run, messages(source, compiled.generated(), asked));
    return new Created(
        run,
        reference,
        compiled.generated().formulationReason(),
        RunWarnings.facts(source, asked.formulation(), asked.settings()));
  }

  /** What the file's reader warned of, a strict request takes for errors. */
  private static void requireNoWarnings(LoadedModel source, RunOptions asked) throws InvalidModel {
    if (asked.strict() && !source.model().warnings().isEmpty()) {
      throw Refusal.strict(source.model().warnings());
    }
  }

  private void requireUserCodeAllowed(CompiledModel compiled, LoadedModel source)
      throws NotAvailable, InvalidModel {
    if (compiled.hasUserClasses() && !session.host().userCode()) {
      throw new NotAvailable(
          MessageCode.USER_CODE_NOT_ALLOWED.code(),
          "host "
              + hostName()
              + " runs no classes of users, and forces of this model are such classes; run it with"
              + " --mode local or without --server, or ask the operator to start the server with"
              + " --allow-user-code");
    }
    try {
      source.userClasses().requireHarmless();
    } catch (MechmlException e) {
      throw Refusal.model(e.diagnostics());
    }
  }

  private static Diagnostic[] messages(
      LoadedModel source, GeneratedFacts generated, RunOptions asked) {
    Diagnostic[] warnings = Wire.diagnostics(source.model().warnings());
    Diagnostic[] all = new Diagnostic[warnings.length + 1];
    System.arraycopy(warnings, 0, all, 0, warnings.length);
    all[warnings.length] =
        Wire.information(
            MessageCode.SERVER_CHOICE,
            "formulation "
                + generated.formulation()
                + " ("
                + generated.formulationReason()
                + "), integrator "
                + asked.settings().integrator());
    return all;
  }

  @Override
  public byte[] compileToJar(NameValue[] options, JarInfoHolder info)
      throws InvalidModel, InvalidOption, InvalidState, NotAvailable, ServerFailure {
    LoadedModel source = requireModel(options);
    return packed(source, suiting(options, source), info);
  }

  private byte[] packed(LoadedModel source, RunOptions asked, JarInfoHolder info)
      throws InvalidModel, InvalidOption, InvalidState, NotAvailable, ServerFailure {
    requireNoWarnings(source, asked);
    BuildOptions build = asked.forJar();
    CompiledModel compiled = Built.orRefused(() -> library.compiled(source, build, times));
    long start = System.nanoTime();
    JarImage jar =
        asked.standalone()
            ? ModelFactory.standaloneJar(compiled, source.sha256())
            : ModelFactory.modelJar(compiled, source.sha256());
    String runtime = asked.standalone() ? "" : ModelFactory.runtimeJar().sha256();
    times.addPacking(System.nanoTime() - start);
    info.value =
        new JarInfo(
            jar.fileName(),
            jar.mainClass(),
            jar.sha256(),
            jar.bytes().length,
            jar.modelBytes(),
            signature(jar),
            runtime,
            Wire.nameValues(jar.manifest()));
    return jar.bytes();
  }

  @Override
  public byte[] prepareJar(NameValue[] options, JarInfoHolder info, NameValueSeqHolder facts)
      throws InvalidModel, InvalidOption, InvalidState, NotAvailable, ServerFailure {
    LoadedModel source = requireModel(options);
    RunOptions asked = suiting(options, source);
    byte[] jar = packed(source, asked, info);
    facts.value = facts("", RunWarnings.facts(source, asked.formulation(), asked.settings()));
    return jar;
  }

  /** Returns the signature that travels beside a JAR; empty without TLS, where nobody has a key. */
  private byte[] signature(JarImage jar) {
    return session
        .host()
        .orb()
        .identity()
        .map(own -> own.sign(jar.bytes()))
        .orElseGet(() -> new byte[0]);
  }

  @Override
  public RuntimeInfo getRuntimeInfo() {
    JarImage jar = ModelFactory.runtimeJar();
    return new RuntimeInfo(jar.sha256(), jar.bytes().length, signature(jar), SolverVersion.CURRENT);
  }

  @Override
  public byte[] fetchRuntime(String sha256) throws NotFound {
    JarImage jar = ModelFactory.runtimeJar();
    if (!jar.sha256().equals(sha256)) {
      throw Refusal.notFound("this server's runtime JAR is " + jar.sha256() + ", not " + sha256);
    }
    return jar.bytes();
  }

  @Override
  public NameValue[] timings() {
    Map<String, String> texts = new LinkedHashMap<>();
    times.asMap().forEach((name, seconds) -> texts.put(name, Double.toString(seconds)));
    return Wire.nameValues(texts);
  }

  @Override
  public SimEvent[] pollEvents(long afterSeqNo, int maxCount, int waitMillis) {
    try {
      return session
          .events()
          .after(
              afterSeqNo,
              (int) Math.min(Integer.toUnsignedLong(maxCount), Integer.MAX_VALUE),
              Math.min(Integer.toUnsignedLong(waitMillis), MAX_WAIT_MILLIS.value));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return new SimEvent[0];
    }
  }

  @Override
  public int renewLease() {
    return session.limits().leaseSeconds();
  }

  @Override
  public void destroy() {
    destroyed.run();
  }
}
