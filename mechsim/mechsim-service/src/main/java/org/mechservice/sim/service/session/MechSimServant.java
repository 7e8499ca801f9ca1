package org.mechservice.sim.service.session;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.LongSupplier;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.Channel;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.InvalidModel;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.InvalidState;
import org.mechservice.idl.JarInfoHolder;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MAX_WAIT_MILLIS;
import org.mechservice.idl.MechSimOperations;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.ModelInfo;
import org.mechservice.idl.ModelReading;
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
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.sim.check.CheckReport;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.scene.forecast.RunForecast;
import org.mechservice.sim.service.contract.ContractErrors;
import org.mechservice.sim.service.contract.ContractTypes;
import org.mechservice.sim.service.library.LoadedModel;
import org.mechservice.sim.service.library.ModelLibrary;
import org.mechservice.sim.service.library.ModelWarnings;
import org.mechservice.sim.service.library.RequestOptions;
import org.mechservice.sim.service.library.SetUpTimes;
import org.mechservice.sim.service.library.SimulationRequest;
import org.mechservice.sim.service.limits.AdmissionControl;
import org.mechservice.sim.service.limits.HostLimit;
import org.mechservice.sim.service.run.RunFactory;
import org.mechservice.sim.user.UserFile;
import org.mechservice.solver.catalogue.SourceLanguage;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Servant of one session: reads a model file, creates simulations and makes JARs of it. */
final class MechSimServant implements MechSimOperations {
  private static final Logger LOG = LoggerFactory.getLogger(MechSimServant.class);

  private final Session session;
  private final ModelLibrary library;
  private final AdmissionControl admission;
  private final LongSupplier modelsOfClient;
  private final Runnable destroyed;
  private final SetUpTimes times = new SetUpTimes();
  private final RunCreation creation;
  private final SignedJars jars;
  private final LongTexts longTexts = new LongTexts();
  private volatile Optional<LoadedModel> loaded = Optional.empty();

  /**
   * @param admission decides whether one more simulation is allowed
   * @param modelsOfClient returns the size of the models in all sessions of the client, B
   * @param destroyed called when the client ends the session
   */
  MechSimServant(
      Session session,
      ModelLibrary library,
      RunFactory runs,
      AdmissionControl admission,
      LongSupplier modelsOfClient,
      Runnable destroyed) {
    this.admission = admission;
    this.session = session;
    this.library = library;
    this.modelsOfClient = modelsOfClient;
    this.destroyed = destroyed;
    creation = new RunCreation(session, library, runs, times);
    jars = new SignedJars(session, library, times);
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
    long bytes = requireAllowedSize(mechml, userFiles);
    admission.requireModelRoom(modelsOfClient.getAsLong() - session.modelBytes(), bytes);
    session.holdsModel(bytes);
    long start = System.nanoTime();
    try {
      LoadedModel read =
          LoadedModel.read(
              mechml.fileName,
              mechml.content,
              Stream.of(userFiles).map(file -> new UserFile(file.fileName, file.content)).toList(),
              session.host().userCode().compiles());
      times.addTreating(System.nanoTime() - start);
      loaded = Optional.of(read);
      generateAhead(read);
      return ContractTypes.diagnostics(read.warnings());
    } catch (MechmlException e) {
      throw ContractErrors.model(e.diagnostics());
    }
  }

  /** Returns the size of a model with its files, B. */
  private long requireAllowedSize(ModelFile mechml, ModelFile[] userFiles) throws LimitExceeded {
    long bytes = mechml.content.length;
    for (ModelFile file : userFiles) {
      bytes += file.content.length;
    }
    long most = session.limits().of(HostLimit.MODEL_BYTES);
    if (bytes > most) {
      throw HostLimit.MODEL_BYTES.refusal(
          most, bytes, "the model has " + bytes + " bytes; this server takes at most " + most);
    }
    return bytes;
  }

  /** Generates the model with the settings of its file; a later request reports errors. */
  private void generateAhead(LoadedModel read) {
    SimulationSettings settings = read.model().settings();
    try {
      BuildOptions asInFile = SimulationRequest.asInFile(read.model()).forRun(settings);
      library.generated(read, asInFile, times);
    } catch (InvalidOption | IllegalArgumentException e) {
      LOG.debug("the model cannot be run as its file says", e);
    }
  }

  private LoadedModel requireModel() throws InvalidState {
    return loaded.orElseThrow(
        () ->
            ContractErrors.state(SimState.SIM_CREATED, "no model is loaded; call loadModel first"));
  }

  /**
   * A parsed request, with the model read as it wants it.
   *
   * @param sourcePart index of the source file wanted
   * @param language its language
   */
  private record Parsed(
      LoadedModel model, SimulationRequest request, int sourcePart, SourceLanguage language) {}

  private Parsed parsed(NameValue[] options) throws InvalidState, InvalidOption, InvalidModel {
    LoadedModel present = requireModel();
    RequestOptions given = RequestOptions.of(options);
    try {
      LoadedModel model = present.with(given.reading());
      return new Parsed(
          model,
          SimulationRequest.of(given, model.model()),
          SimulationRequest.sourcePart(given),
          SimulationRequest.sourceLanguage(given));
    } catch (MechmlException e) {
      throw ContractErrors.model(e.diagnostics());
    }
  }

  /** Returns a parsed request; refuses a strict one if there are warnings before its run. */
  private Parsed parsedToBuild(NameValue[] options)
      throws InvalidState, InvalidOption, InvalidModel {
    Parsed parsed = parsed(options);
    SimulationRequest asked = parsed.request();
    if (asked.strict()) {
      ContractErrors.requireNoWarnings(
          RunForecast.warnings(
              parsed.model().model(), asked.formulation(), asked.closure(), asked.settings()));
    }
    return parsed;
  }

  @Override
  public ModelInfo getModelInfo() throws InvalidState {
    return requireModel().info();
  }

  @Override
  public Parameter[] parameters() throws InvalidState {
    return parametersOf(requireModel().model());
  }

  private static Parameter[] parametersOf(MechmlModel model) {
    return model.parameters().stream()
        .map(p -> new Parameter(p.name(), p.unit(), p.value(), p.tunable()))
        .toArray(Parameter[]::new);
  }

  @Override
  public RoadmapEntry[] roadmap() throws InvalidState {
    return requireModel().roadmap();
  }

  @Override
  public String checkReport(boolean asJson) throws InvalidState {
    MechmlModel model = requireModel().model();
    return longTexts.of(List.of(model, asJson), () -> text(CheckReport.of(model), asJson));
  }

  private static String text(CheckReport report, boolean asJson) {
    return asJson ? report.json() : report.text();
  }

  @Override
  public ModelReading readWith(NameValue[] options)
      throws InvalidModel, InvalidOption, InvalidState {
    MechmlModel model = parsed(options).model().model();
    return new ModelReading(
        parametersOf(model),
        model.simulations().stream().map(SimulationSettings::name).toArray(String[]::new),
        model.outputs().stream().map(o -> new Channel(o.name(), o.unit())).toArray(Channel[]::new));
  }

  @Override
  public String checkReportWith(NameValue[] options, boolean asJson)
      throws InvalidModel, InvalidOption, InvalidState {
    Parsed parsed = parsed(options);
    MechmlModel model = parsed.model().model();
    SimulationRequest asked = parsed.request();
    OptionalInt part = SimulationRequest.textPart(RequestOptions.of(options));
    String text =
        longTexts.of(
            List.of(model, asJson, asked.formulation(), asked.closure(), asked.settings()),
            () ->
                text(
                    CheckReport.of(model, asked.formulation(), asked.closure(), asked.settings()),
                    asJson));
    return part.isEmpty() ? text : LongTexts.part(text, part.getAsInt());
  }

  @Override
  public ModelFile generatedSource(NameValue[] options)
      throws InvalidModel, InvalidOption, InvalidState, NotAvailable, ServerFailure {
    Parsed parsed = parsed(options);
    List<ModelFile> sources = sources(parsed);
    return parsed.sourcePart() < sources.size()
        ? sources.get(parsed.sourcePart())
        : new ModelFile("", new byte[0]);
  }

  private List<ModelFile> sources(Parsed parsed)
      throws InvalidModel, InvalidOption, NotAvailable, ServerFailure {
    LoadedModel model = parsed.model();
    BuildOptions options = parsed.request().forJar();
    if (parsed.language() == SourceLanguage.C) {
      return ContractErrors.build(() -> ModelFactory.inC(model.model(), options))
          .files()
          .entrySet()
          .stream()
          .map(file -> file(file.getKey(), file.getValue()))
          .toList();
    }
    return ContractErrors.build(() -> library.generated(model, options, times)).sources().stream()
        .map(source -> file(source.className().replace('.', '/') + ".java", source.text()))
        .toList();
  }

  private static ModelFile file(String name, String text) {
    return new ModelFile(name, text.getBytes(StandardCharsets.UTF_8));
  }

  @Override
  public IMechSimRemote createSimulation(NameValue[] options, @Nullable IMechClient client)
      throws InvalidModel, InvalidOption, InvalidState, NotAvailable, LimitExceeded, ServerFailure {
    return created(options, client).reference();
  }

  @Override
  public RunSetUp prepareSimulation(NameValue[] options, @Nullable IMechClient client)
      throws InvalidModel, InvalidOption, InvalidState, NotAvailable, LimitExceeded, ServerFailure {
    RunCreation.Created created = created(options, client);
    try {
      return new RunSetUp(
          created.reference(),
          session.openRows(created.run()),
          ContractTypes.channels(created.run().columns().variables()),
          facts(created.formulationReason(), created.warnings()));
    } catch (LimitExceeded e) {
      session.destroy(created.run());
      throw e;
    }
  }

  /** Returns the entries of the run report about the set-up that this host knows. */
  private NameValue[] facts(String formulationReason, Map<String, String> warnings)
      throws InvalidState {
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("hostName", hostName());
    facts.put("modelSha256", requireModel().sha256());
    facts.put("formulationReason", formulationReason);
    times.asMap().forEach((name, seconds) -> facts.put(name, Double.toString(seconds)));
    facts.putAll(warnings);
    return ContractTypes.nameValues(facts);
  }

  private RunCreation.Created created(NameValue[] options, @Nullable IMechClient client)
      throws InvalidModel, InvalidOption, InvalidState, NotAvailable, LimitExceeded, ServerFailure {
    admission.requirePlace(session.owner(), session.simulationCount());
    Parsed parsed = parsedToBuild(options);
    return creation.create(parsed.model(), parsed.request(), client);
  }

  @Override
  public byte[] compileToJar(NameValue[] options, JarInfoHolder info)
      throws InvalidModel, InvalidOption, InvalidState, NotAvailable, ServerFailure {
    Parsed parsed = parsedToBuild(options);
    return jars.ofModel(parsed.model(), parsed.request(), info);
  }

  @Override
  public byte[] prepareJar(NameValue[] options, JarInfoHolder info, NameValueSeqHolder facts)
      throws InvalidModel, InvalidOption, InvalidState, NotAvailable, ServerFailure {
    Parsed parsed = parsedToBuild(options);
    LoadedModel source = parsed.model();
    SimulationRequest asked = parsed.request();
    byte[] jar = jars.ofModel(source, asked, info);
    facts.value =
        facts(
            "",
            ModelWarnings.ofSetUp(source, asked.formulation(), asked.closure(), asked.settings()));
    return jar;
  }

  @Override
  public RuntimeInfo getRuntimeInfo() {
    return jars.runtime();
  }

  @Override
  public byte[] fetchRuntime(String sha256) throws NotFound {
    return SignedJars.runtime(sha256);
  }

  @Override
  public NameValue[] timings() {
    Map<String, String> texts = new LinkedHashMap<>();
    times.asMap().forEach((name, seconds) -> texts.put(name, Double.toString(seconds)));
    return ContractTypes.nameValues(texts);
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
