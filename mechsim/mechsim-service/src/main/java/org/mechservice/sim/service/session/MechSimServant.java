package org.mechservice.sim.service.session;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.LongSupplier;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
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
import org.mechservice.idl.OPT_TEXT_PART;
import org.mechservice.idl.Parameter;
import org.mechservice.idl.RoadmapEntry;
import org.mechservice.idl.RunSetUp;
import org.mechservice.idl.RuntimeInfo;
import org.mechservice.idl.ServerFailure;
import org.mechservice.idl.SimEvent;
import org.mechservice.idl.SimState;
import org.mechservice.sim.service.contract.ContractErrors;
import org.mechservice.sim.service.contract.ContractTypes;
import org.mechservice.sim.service.contract.ShortText;
import org.mechservice.sim.service.library.ClassLibrary;
import org.mechservice.sim.service.library.RequestOptions;
import org.mechservice.sim.service.library.SetUpTimes;
import org.mechservice.sim.service.library.SimulationRequest;
import org.mechservice.sim.service.limits.AdmissionControl;
import org.mechservice.sim.service.limits.HostLimit;
import org.mechservice.sim.service.run.RunFactory;
import org.mechservice.sim.service.setup.ModelFiles;
import org.mechservice.sim.service.setup.ReadingBounds;
import org.mechservice.sim.service.setup.SetUps;
import org.mechservice.sim.user.UserFile;

/** Servant of one session: reads a model file, creates simulations and makes JARs of it. */
final class MechSimServant implements MechSimOperations {
  private static final NameValue[] AS_IN_FILE = {};

  /** What a file takes besides its content, B. */
  private static final int BYTES_OF_FILE = 1000;

  private final Session session;
  private final SetUps setUps;
  private final AdmissionControl admission;
  private final LongSupplier modelsOfClient;
  private final Runnable destroyed;
  private final SetUpTimes times = new SetUpTimes();
  private final RunCreation creation;
  private final SignedJars jars;
  private final LongTexts longTexts = new LongTexts();
  private volatile Optional<ModelFiles> loaded = Optional.empty();

  /**
   * @param setUps read and build the models
   * @param classes has the classes of models that were built
   * @param admission decides whether one more simulation is allowed
   * @param modelsOfClient returns the size of the models in all sessions of the client and of those
   *     of its simulations, B
   * @param destroyed called when the client ends the session
   */
  MechSimServant(
      Session session,
      SetUps setUps,
      ClassLibrary classes,
      RunFactory runs,
      AdmissionControl admission,
      LongSupplier modelsOfClient,
      Runnable destroyed) {
    this.admission = admission;
    this.session = session;
    this.setUps = setUps;
    this.modelsOfClient = modelsOfClient;
    this.destroyed = destroyed;
    creation = new RunCreation(session, classes, runs, times);
    jars = new SignedJars(session);
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
    ModelFiles files =
        new ModelFiles(
            ShortText.name(mechml.fileName),
            mechml.content,
            Stream.of(userFiles)
                .map(file -> new UserFile(ShortText.name(file.fileName), file.content))
                .toList(),
            session.host().userCode().compiles(),
            new ReadingBounds(session.limits().bound(HostLimit.MODEL_LOOPS)));
    SetUps.Loaded read = setUps.load(files);
    times.add(read.spent());
    loaded = Optional.of(files);
    return read.warnings();
  }

  /** Returns the size of a model with its files, B. */
  private long requireAllowedSize(ModelFile mechml, ModelFile[] userFiles) throws LimitExceeded {
    long bytes = mechml.content.length;
    for (ModelFile file : userFiles) {
      bytes += BYTES_OF_FILE + file.content.length;
    }
    long most = session.limits().of(HostLimit.MODEL_BYTES);
    if (bytes > most) {
      throw HostLimit.MODEL_BYTES.refusal(
          most, bytes, "the model has " + bytes + " bytes; this server takes at most " + most);
    }
    return bytes;
  }

  private ModelFiles requireModel() throws InvalidState {
    return loaded.orElseThrow(
        () ->
            ContractErrors.state(SimState.SIM_CREATED, "no model is loaded; call loadModel first"));
  }

  /** A question about a model that was read before. */
  @FunctionalInterface
  private interface Question<T> {
    T of(ModelFiles files) throws InvalidModel, LimitExceeded;
  }

  private <T> T known(Question<T> question) throws InvalidState {
    ModelFiles model = requireModel();
    try {
      return question.of(model);
    } catch (InvalidModel e) {
      throw new IllegalStateException("the model could be read before", e);
    } catch (LimitExceeded e) {
      throw ContractErrors.undeclared(e);
    }
  }

  @Override
  public ModelInfo getModelInfo() throws InvalidState {
    return known(setUps::info);
  }

  @Override
  public Parameter[] parameters() throws InvalidState {
    return known(setUps::parameters);
  }

  @Override
  public RoadmapEntry[] roadmap() throws InvalidState {
    return known(setUps::roadmap);
  }

  @Override
  public String checkReport(boolean asJson) throws InvalidState {
    try {
      return report(AS_IN_FILE, asJson);
    } catch (InvalidModel | InvalidOption e) {
      throw new IllegalStateException("the model could be read before", e);
    }
  }

  private String report(NameValue[] options, boolean asJson)
      throws InvalidModel, InvalidOption, InvalidState {
    ModelFiles model = requireModel();
    List<String> of = new ArrayList<>(List.of(model.sha256(), Boolean.toString(asJson)));
    for (NameValue option : options) {
      of.add(option.key + "=" + option.text);
    }
    Optional<String> kept = longTexts.of(of);
    if (kept.isPresent()) {
      return kept.get();
    }
    try {
      return longTexts.keep(of, setUps.checkReport(model, options, asJson));
    } catch (LimitExceeded e) {
      throw ContractErrors.undeclared(e);
    }
  }

  @Override
  public ModelReading readWith(NameValue[] options)
      throws InvalidModel, InvalidOption, InvalidState {
    try {
      return setUps.reading(requireModel(), options);
    } catch (LimitExceeded e) {
      throw ContractErrors.undeclared(e);
    }
  }

  @Override
  public String checkReportWith(NameValue[] options, boolean asJson)
      throws InvalidModel, InvalidOption, InvalidState {
    OptionalInt part = SimulationRequest.textPart(RequestOptions.of(options));
    NameValue[] others =
        Stream.of(options)
            .filter(option -> !option.key.equals(OPT_TEXT_PART.value))
            .toArray(NameValue[]::new);
    String text = report(others, asJson);
    return part.isEmpty() ? text : LongTexts.part(text, part.getAsInt());
  }

  @Override
  public ModelFile generatedSource(NameValue[] options)
      throws InvalidModel, InvalidOption, InvalidState, NotAvailable, ServerFailure {
    ModelFiles model = requireModel();
    int part = SimulationRequest.sourcePart(RequestOptions.of(options));
    try {
      SetUps.Sources sources = setUps.sources(model, options);
      times.add(sources.spent());
      return part < sources.files().length ? sources.files()[part] : new ModelFile("", new byte[0]);
    } catch (LimitExceeded e) {
      throw ContractErrors.undeclared(e);
    }
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
    ModelFiles model = requireModel();
    admission.requirePlace(session.owner(), session.simulationCount());
    admission.requireModelRoom(modelsOfClient.getAsLong(), model.content().length);
    SetUps.Built built = setUps.build(model, options);
    times.add(built.spent());
    return creation.create(model, built, client);
  }

  @Override
  public byte[] compileToJar(NameValue[] options, JarInfoHolder info)
      throws InvalidModel, InvalidOption, InvalidState, NotAvailable, ServerFailure {
    return jars.ofModel(packed(options), info);
  }

  private SetUps.Packed packed(NameValue[] options)
      throws InvalidModel, InvalidOption, InvalidState, NotAvailable, ServerFailure {
    try {
      SetUps.Packed packed = setUps.pack(requireModel(), options);
      times.add(packed.spent());
      return packed;
    } catch (LimitExceeded e) {
      throw ContractErrors.undeclared(e);
    }
  }

  @Override
  public byte[] prepareJar(NameValue[] options, JarInfoHolder info, NameValueSeqHolder facts)
      throws InvalidModel, InvalidOption, InvalidState, NotAvailable, ServerFailure {
    SetUps.Packed packed = packed(options);
    byte[] jar = jars.ofModel(packed, info);
    facts.value = facts("", packed.warnings());
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
