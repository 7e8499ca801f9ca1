package org.mechservice.sim.service.setup;

import java.util.LinkedHashMap;
import java.util.Map;
import org.mechservice.idl.Channel;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.DiagnosticSeqHolder;
import org.mechservice.idl.InvalidModel;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.ModelInfo;
import org.mechservice.idl.ModelReading;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NotAvailable;
import org.mechservice.idl.Parameter;
import org.mechservice.idl.RoadmapEntry;
import org.mechservice.idl.ServerFailure;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.sim.check.CheckReport;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.model.GeneratedFacts;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.packaging.JarImage;
import org.mechservice.sim.packaging.ModelJars;
import org.mechservice.sim.packaging.RuntimeJar;
import org.mechservice.sim.scene.forecast.RunForecast;
import org.mechservice.sim.service.contract.ContractErrors;
import org.mechservice.sim.service.contract.ContractTypes;
import org.mechservice.sim.service.library.ClassLibrary;
import org.mechservice.sim.service.library.LoadedModel;
import org.mechservice.sim.service.library.ModelImport;
import org.mechservice.sim.service.library.ModelLibrary;
import org.mechservice.sim.service.library.ModelWarnings;
import org.mechservice.sim.service.library.RequestOptions;
import org.mechservice.sim.service.library.SetUpTimes;
import org.mechservice.sim.service.library.SimulationRequest;
import org.mechservice.sim.service.limits.HostLimit;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.SourceLanguage;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Reads, generates and builds in this process. The latest models stay read. Thread-safe. */
public final class SetUpsHere implements SetUps, AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(SetUpsHere.class);

  /** Models that stay read. */
  private static final int KEPT = 8;

  /** Size of the files of the models that stay read, B; the latest stays whatever its size. */
  private static final long KEPT_BYTES = 4L << 20;

  private final ModelLibrary library = new ModelLibrary();
  private final ClassLibrary classes;

  /** In the order of use, the latest last. */
  private final Map<String, LoadedModel> read = new LinkedHashMap<>(16, 0.75f, true);

  /**
   * A request, with the model read as it wants it.
   *
   * @param given its options
   */
  private record Parsed(LoadedModel model, SimulationRequest request, RequestOptions given) {}

  /**
   * @param classes receives the classes of models that are built
   */
  public SetUpsHere(ClassLibrary classes) {
    this.classes = classes;
  }

  @Override
  public Loaded load(ModelFiles files) throws InvalidModel, LimitExceeded {
    SetUpTimes times = new SetUpTimes();
    LoadedModel loaded = loaded(files, times);
    generateAhead(loaded, times);
    return new Loaded(ContractTypes.diagnostics(loaded.warnings()), times.spent());
  }

  private LoadedModel loaded(ModelFiles files) throws InvalidModel, LimitExceeded {
    return loaded(files, new SetUpTimes());
  }

  private LoadedModel loaded(ModelFiles files, SetUpTimes times)
      throws InvalidModel, LimitExceeded {
    String key = files.key();
    synchronized (read) {
      LoadedModel known = read.get(key);
      if (known != null) {
        return known;
      }
    }
    long start = System.nanoTime();
    try {
      LoadedModel model =
          LoadedModel.read(files.fileName(), files.content(), files.userFiles(), files.compile());
      requireFewLoops(model.model(), files.bounds());
      times.addTreating(System.nanoTime() - start);
      keep(key, model);
      return model;
    } catch (MechmlException e) {
      throw ContractErrors.model(e.diagnostics());
    }
  }

  private static void requireFewLoops(MechmlModel model, ReadingBounds bounds)
      throws LimitExceeded {
    int loops = model.mechanism().closures().size();
    if (loops > bounds.loops()) {
      throw HostLimit.MODEL_LOOPS.refusal(
          bounds.loops(),
          loops,
          "the model has "
              + loops
              + " closed loops; this server takes at most "
              + bounds.loops()
              + " ("
              + HostLimit.MODEL_LOOPS.label()
              + "); leave out loops that repeat others, or divide the model");
    }
  }

  private void keep(String key, LoadedModel model) {
    synchronized (read) {
      read.put(key, model);
      long bytes = read.values().stream().mapToLong(kept -> kept.content().length).sum();
      var oldest = read.values().iterator();
      while (read.size() > 1 && (read.size() > KEPT || bytes > KEPT_BYTES)) {
        bytes -= oldest.next().content().length;
        oldest.remove();
      }
    }
  }

  private void generateAhead(LoadedModel loaded, SetUpTimes times) {
    SimulationSettings settings = loaded.model().settings();
    try {
      BuildOptions asInFile = SimulationRequest.asInFile(loaded.model()).forRun(settings);
      library.generated(loaded, asInFile, times);
    } catch (InvalidOption | IllegalArgumentException e) {
      LOG.debug("the model cannot be run as its file says", e);
    }
  }

  @Override
  public ModelInfo info(ModelFiles files) throws InvalidModel, LimitExceeded {
    return loaded(files).info();
  }

  @Override
  public Parameter[] parameters(ModelFiles files) throws InvalidModel, LimitExceeded {
    return parametersOf(loaded(files).model());
  }

  private static Parameter[] parametersOf(MechmlModel model) {
    return model.parameters().stream()
        .map(p -> new Parameter(p.name(), p.unit(), p.value(), p.tunable()))
        .toArray(Parameter[]::new);
  }

  @Override
  public RoadmapEntry[] roadmap(ModelFiles files) throws InvalidModel, LimitExceeded {
    return loaded(files).roadmap();
  }

  private Parsed parsed(ModelFiles files, NameValue[] options, SetUpTimes times)
      throws InvalidOption, InvalidModel, LimitExceeded {
    RequestOptions given = RequestOptions.of(options);
    try {
      LoadedModel model = loaded(files, times).with(given.reading());
      return new Parsed(model, SimulationRequest.of(given, model.model()), given);
    } catch (MechmlException e) {
      throw ContractErrors.model(e.diagnostics());
    }
  }

  /** Returns a parsed request; refuses a strict one if there are warnings before its run. */
  private Parsed parsedToBuild(ModelFiles files, NameValue[] options, SetUpTimes times)
      throws InvalidOption, InvalidModel, LimitExceeded {
    Parsed parsed = parsed(files, options, times);
    SimulationRequest asked = parsed.request();
    if (asked.strict()) {
      ContractErrors.requireNoWarnings(
          RunForecast.warnings(
              parsed.model().model(), asked.formulation(), asked.closure(), asked.settings()));
    }
    return parsed;
  }

  @Override
  public ModelReading reading(ModelFiles files, NameValue[] options)
      throws InvalidModel, InvalidOption, LimitExceeded {
    MechmlModel model = parsed(files, options, new SetUpTimes()).model().model();
    return new ModelReading(
        parametersOf(model),
        model.simulations().stream().map(SimulationSettings::name).toArray(String[]::new),
        model.outputs().stream().map(o -> new Channel(o.name(), o.unit())).toArray(Channel[]::new));
  }

  @Override
  public String checkReport(ModelFiles files, NameValue[] options, boolean asJson)
      throws InvalidModel, InvalidOption, LimitExceeded {
    CheckReport report;
    if (options.length == 0) {
      report = CheckReport.of(loaded(files).model());
    } else {
      Parsed parsed = parsed(files, options, new SetUpTimes());
      SimulationRequest asked = parsed.request();
      report =
          CheckReport.of(
              parsed.model().model(), asked.formulation(), asked.closure(), asked.settings());
    }
    return asJson ? report.json() : report.text();
  }

  @Override
  public Sources sources(ModelFiles files, NameValue[] options)
      throws InvalidModel, InvalidOption, NotAvailable, LimitExceeded, ServerFailure {
    SetUpTimes times = new SetUpTimes();
    Parsed parsed = parsed(files, options, times);
    LoadedModel model = parsed.model();
    BuildOptions build = parsed.request().forJar();
    ModelFile[] sources =
        SimulationRequest.sourceLanguage(parsed.given()) == SourceLanguage.C
            ? ContractErrors.build(() -> ModelFactory.inC(model.model(), build))
                .files()
                .entrySet()
                .stream()
                .map(file -> ContractTypes.file(file.getKey(), file.getValue()))
                .toArray(ModelFile[]::new)
            : ContractErrors.build(() -> library.generated(model, build, times)).sources().stream()
                .map(
                    source ->
                        ContractTypes.file(
                            source.className().replace('.', '/') + ".java", source.text()))
                .toArray(ModelFile[]::new);
    return new Sources(sources, times.spent());
  }

  @Override
  public Built build(ModelFiles files, NameValue[] options)
      throws InvalidModel, InvalidOption, NotAvailable, LimitExceeded, ServerFailure {
    SetUpTimes times = new SetUpTimes();
    Parsed parsed = parsedToBuild(files, options, times);
    LoadedModel source = parsed.model();
    SimulationRequest asked = parsed.request();
    SimulationSettings ofFile = source.model().settings();
    CompiledModel compiled =
        ContractErrors.build(() -> library.compiled(source, asked.forRun(ofFile), times));
    classes.keep(compiled.classes());
    return new Built(
        compiled.generated(),
        compiled.classes().files(),
        new RunRequest(
            asked.settings(),
            asked.columns(),
            asked.strict(),
            asked.maxDrift(),
            source.model().silenced()),
        asked.earlierIds(),
        messages(source, compiled.generated(), asked),
        ModelWarnings.ofSetUp(source, asked.formulation(), asked.closure(), asked.settings()),
        times.spent());
  }

  private static Diagnostic[] messages(
      LoadedModel source, GeneratedFacts generated, SimulationRequest asked) {
    Diagnostic[] warnings = ContractTypes.diagnostics(source.model().warnings());
    Diagnostic[] all = new Diagnostic[warnings.length + 1];
    System.arraycopy(warnings, 0, all, 0, warnings.length);
    all[warnings.length] =
        ContractTypes.information(
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
  public Packed pack(ModelFiles files, NameValue[] options)
      throws InvalidModel, InvalidOption, NotAvailable, LimitExceeded, ServerFailure {
    SetUpTimes times = new SetUpTimes();
    Parsed parsed = parsedToBuild(files, options, times);
    LoadedModel source = parsed.model();
    SimulationRequest asked = parsed.request();
    CompiledModel compiled =
        ContractErrors.build(() -> library.compiled(source, asked.forJar(), times));
    long start = System.nanoTime();
    JarImage jar =
        asked.standalone()
            ? ModelJars.standalone(compiled, source.sha256())
            : ModelJars.model(compiled, source.sha256());
    String runtime = asked.standalone() ? "" : RuntimeJar.sha256();
    times.addPacking(System.nanoTime() - start);
    return new Packed(
        jar,
        runtime,
        ModelWarnings.ofSetUp(source, asked.formulation(), asked.closure(), asked.settings()),
        times.spent());
  }

  @Override
  public Translated translate(ModelFile foreign) throws InvalidModel, NotAvailable, LimitExceeded {
    DiagnosticSeqHolder losses = new DiagnosticSeqHolder();
    ModelFile model = ModelImport.translate(foreign, losses);
    return new Translated(model, losses.value);
  }

  @Override
  public String reportOf(String fileName, String text) {
    return library.checkReport(fileName, text);
  }

  @Override
  public void close() {
    library.close();
  }
}
