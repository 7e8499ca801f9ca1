package org.mechservice.library;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.mechservice.guard.Confinement;
import org.mechservice.guard.UserCode;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.SimulationTask;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.Element;
import org.mechservice.report.ModelReport;
import org.mechservice.report.measure.Effort;
import org.mechservice.report.measure.ReportProgress;
import org.mechservice.report.method.MethodBuilds;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.robot.RobotExport;
import org.mechservice.sim.check.CheckReport;
import org.mechservice.sim.compile.ReusedCode;
import org.mechservice.sim.model.ModelColumns;
import org.mechservice.sim.packaging.JarImage;
import org.mechservice.sim.packaging.ModelJars;
import org.mechservice.sim.scene.forecast.RunForecast;
import org.mechservice.sim.user.UserClasses;
import org.mechservice.solver.api.ModelParameter;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.program.RowMemory;
import org.mechservice.solver.api.program.RunFailedException;
import org.mechservice.solver.api.program.SteppedModel;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Accuracy;
import org.mechservice.solver.catalogue.AnalysisKind;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.simulation.RuntimeSolver;
import org.mechservice.solver.system.LinearSystem;
import org.mechservice.solver.system.SystemTable;
import org.mechservice.solver.text.ResultFile;
import org.mechservice.solver.text.Sha256;

/**
 * A model with the settings of its run, to be changed, checked, simulated and analysed in this
 * process. It runs what {@code mech simulate} runs: the rows are the same to the bit.
 *
 * <pre>{@code
 * MechModel car = MechModel.read(Path.of("car.xml")).set("k", 2.1e4).until(5).every(0.01);
 * System.out.println(car.check().text());
 * Trajectory motion = car.simulate();
 * double[] time = motion.time();
 * double[] height = motion.column("height.q");
 * System.out.println(motion.unit("height.q") + " " + motion.report().steps());
 * Trajectory modes = car.modes();
 * car.simulate(Path.of("car.csv"));
 * car.writeJar(Path.of("car.jar"));
 * Path page = car.report(Path.of("pages"), Effort.QUICK, ReportProgress.SILENT);
 * }</pre>
 *
 * <ul>
 *   <li>It is made by {@link #read}, {@link #of} and {@link #importRobot}.
 *   <li>Values and settings are changed by {@link #set}, {@link #tunable}, {@link #simulation},
 *       {@link #until}, {@link #every}, {@link #integrator}, {@link #tolerances}, {@link
 *       #formulation}, {@link #closure}, {@link #accuracy} and {@link #columns(ColumnGroup...)};
 *       what ends a run and which warnings it gives by {@link #strict}, {@link #maxDrift} and
 *       {@link #silence}.
 *   <li>It is checked by {@link #check} and run by {@link #simulate()} and {@link
 *       #stepped(double)}; programs that run it themselves take {@link #instances()} and {@link
 *       #request}.
 *   <li>Analyses are {@link #equilibrium}, {@link #modes}, {@link #linearise}, {@link
 *       #linearSystem}, {@link #kinematics} and {@link #inverseDynamics}.
 *   <li>Files are written by {@link #report(Path)}, {@link #writeJar}, {@link #writeUrdf} and
 *       {@link #writeMjcf}.
 * </ul>
 *
 * <p>Immutable: each change returns another model. Code is generated once, when it is first needed.
 * May be used by several threads.
 */
public final class MechModel {
  /** Settings of the program beyond those of the file. */
  private record Choices(
      ReadOptions reading,
      UnaryOperator<SimulationSettings> changes,
      boolean strict,
      OptionalDouble maxDrift) {
    static final Choices NONE =
        new Choices(ReadOptions.NONE, settings -> settings, false, OptionalDouble.empty());

    Choices reading(ReadOptions other) {
      return new Choices(other, changes, strict, maxDrift);
    }

    Choices and(UnaryOperator<SimulationSettings> change) {
      return new Choices(reading, old -> change.apply(changes.apply(old)), strict, maxDrift);
    }

    Choices endingAtWarnings() {
      return new Choices(reading, changes, true, maxDrift);
    }

    Choices endingAtDrift(double part) {
      return new Choices(reading, changes, strict, OptionalDouble.of(part));
    }
  }

  private final MechmlFile file;
  private final Choices choices;
  private final MechmlModel model;
  private final UserClasses userClasses;
  private final ModelCode code;

  private MechModel(MechmlFile file, Choices choices, MechmlModel model, UserClasses userClasses) {
    this.file = file;
    this.choices = choices;
    this.model = model;
    this.userClasses = userClasses;
    this.code = new ModelCode(model, userClasses, choices.changes);
  }

  /**
   * Reads a model without classes of users.
   *
   * @param file MechML file
   * @throws IOException if a file cannot be read
   * @throws MechmlException if the model cannot be used; says what, where and what to write instead
   */
  public static MechModel read(Path file) throws IOException, MechmlException {
    return read(file, UserCode.NONE);
  }

  /**
   * Reads a model whose forces may be classes of users. They are verified, and run in confined
   * processes.
   *
   * @param file MechML file
   * @param consent the folders whose classes may run; code beside the file does not run unasked
   * @throws IOException if a file cannot be read
   * @throws MechmlException if the model cannot be used; says what, where and what to write instead
   */
  public static MechModel read(Path file, UserCode consent) throws IOException, MechmlException {
    return read(file.toString(), file, consent);
  }

  /**
   * Reads a model under a name of its own.
   *
   * @param name of the file in messages and in the generated code, whose bytes then do not depend
   *     on the folder
   * @param file MechML file
   * @param consent the folders whose classes of forces may run
   * @throws IOException if a file cannot be read
   * @throws MechmlException if the model cannot be used; says what, where and what to write instead
   */
  public static MechModel read(String name, Path file, UserCode consent)
      throws IOException, MechmlException {
    return read(MechmlFile.of(name, file, consent));
  }

  /**
   * Reads a model that is no file.
   *
   * @param name its name in messages
   * @param mechml its text
   * @throws MechmlException if it cannot be used
   */
  public static MechModel of(String name, String mechml) throws MechmlException {
    try {
      return read(MechmlFile.of(name, mechml));
    } catch (IOException e) {
      throw new IllegalStateException("no file is read", e);
    }
  }

  /**
   * Reads a robot.
   *
   * @param robot file in URDF, SDF or MJCF
   * @return its model, as {@code mech import} translates it
   * @throws IOException if the file cannot be read
   * @throws MechmlException if it is no robot, or no mechanism
   */
  public static MechModel importRobot(Path robot) throws IOException, MechmlException {
    return read(MechmlFile.ofRobot(robot));
  }

  private static MechModel read(MechmlFile file) throws IOException, MechmlException {
    MechmlModel model = file.model(ReadOptions.NONE);
    return new MechModel(file, Choices.NONE, model, file.userClasses(model.mechanism()));
  }

  /** Returns the model's name. */
  public String name() {
    return model.mechanism().name();
  }

  /** Returns what was read: the mechanism and its settings. */
  public MechmlModel content() {
    return model;
  }

  /** Returns the outermost element of what was read, with the files that it includes. */
  public Element file() {
    try {
      return file.root();
    } catch (MechmlException e) {
      throw new IllegalStateException("what was read before is read again", e);
    }
  }

  /**
   * Returns the text of what was read, with the files that it includes; that of a robot in MechML.
   * Values and settings of the program are not in it.
   */
  public String mechml() {
    return file.text();
  }

  /** Returns the folder of the file; empty if the model is no file. */
  public Optional<Path> folder() {
    return file.folder();
  }

  /** Returns the parameters of the file, as it gives them, in its order. */
  public List<ModelParameter> parameters() {
    return model.parameters();
  }

  /** Returns the names of the simulations of the file, in its order; empty where one has none. */
  public List<String> simulations() {
    return model.simulations().stream().map(SimulationSettings::name).toList();
  }

  /** Returns the groups of columns that runs put out. */
  public Set<ColumnGroup> columns() {
    return EnumSet.copyOf(ModelColumns.shown(code.settings()));
  }

  /**
   * Returns the model with another value of a parameter.
   *
   * @param value in the unit that the file gives the parameter
   * @throws MechmlException if there is no such parameter, or the model cannot be used so
   */
  public MechModel set(String parameter, double value) throws MechmlException {
    return set(parameter, Double.toString(value));
  }

  /**
   * Returns the model with another value of a parameter.
   *
   * @param value number or expression of the file's language, in the unit that the file gives it
   * @throws MechmlException if there is no such parameter, or the model cannot be used so
   */
  public MechModel set(String parameter, String value) throws MechmlException {
    Map<String, String> values = new LinkedHashMap<>(choices.reading.values());
    values.put(parameter, value);
    return reread(choices.reading.with(values));
  }

  /**
   * Returns the model with other values of some parameters.
   *
   * @param given values in the units that the file gives the parameters, by name
   * @throws MechmlException if there is no such parameter, or the model cannot be used so
   */
  public MechModel set(Map<String, Double> given) throws MechmlException {
    Map<String, String> values = new LinkedHashMap<>(choices.reading.values());
    given.forEach((name, value) -> values.put(name, Double.toString(value)));
    return reread(choices.reading.with(values));
  }

  /**
   * Returns the model with parameters that stay inputs of its code: {@link #instances} sets them
   * without generating code again.
   *
   * @throws MechmlException if there is no such parameter, or what depends on it is settled when
   *     the file is read (M-017)
   */
  public MechModel tunable(Set<String> parameters) throws MechmlException {
    Set<String> all = new LinkedHashSet<>(choices.reading.tunable());
    all.addAll(parameters);
    return reread(choices.reading.withTunable(all));
  }

  /**
   * Returns the model with another simulation of its file.
   *
   * @param nameOrNumber its name, or its number from 1
   * @throws MechmlException if there is none of that name
   */
  public MechModel simulation(String nameOrNumber) throws MechmlException {
    return reread(choices.reading.withSimulation(nameOrNumber));
  }

  private MechModel reread(ReadOptions other) throws MechmlException {
    return new MechModel(file, choices.reading(other), file.model(other), userClasses);
  }

  /** Returns the model with runs that end at another time, s. */
  public MechModel until(double tEnd) {
    return run(run -> run.withOutput(tEnd, run.tStep()));
  }

  /** Returns the model with another distance of the rows, s. */
  public MechModel every(double tStep) {
    return run(run -> run.withOutput(run.tEnd(), tStep));
  }

  /** Returns the model with another integrator, such as {@code ode15s}, or {@code auto}. */
  public MechModel integrator(String name) {
    return run(run -> run.withIntegrator(name));
  }

  /**
   * Returns the model with other tolerances.
   *
   * @param relative of each step, relative to the state
   * @param absolute one for all states, SI, or four: of displacements, angles, velocities, angular
   *     velocities
   */
  public MechModel tolerances(double relative, double... absolute) {
    if (absolute.length != 1 && absolute.length != 4) {
      throw new IllegalArgumentException(
          "there is one absolute tolerance or four, not " + absolute.length);
    }
    List<Double> each = Arrays.stream(absolute).boxed().toList();
    return run(run -> run.withRelativeTolerance(relative).withTolerances(each));
  }

  private MechModel run(UnaryOperator<RunSettings> change) {
    return changed(old -> old.with(change.apply(old.run())));
  }

  /** Returns the model with another formulation: {@code auto}, {@code DTR}, {@code RR} etc. */
  public MechModel formulation(String name) {
    return changed(old -> old.withFormulation(name));
  }

  /**
   * Returns the model with another closure of loops: {@code auto}, {@code projection} or {@code
   * penalty}, with numbers of its own {@code penalty:alpha=1e7,omega=10,mu=1}.
   */
  public MechModel closure(String name) {
    return changed(old -> old.withClosure(name));
  }

  /**
   * Returns the model with another relation of the final error to the tolerances: {@code standard},
   * or {@code strict}, which makes errors smaller at the same tolerances.
   *
   * @throws IllegalArgumentException if there is none of that name
   */
  public MechModel accuracy(String name) {
    Accuracy accuracy = Accuracy.of(name);
    return run(run -> run.withAccuracy(accuracy));
  }

  /** Returns the model with runs that put out these columns besides time and the joints' states. */
  public MechModel columns(ColumnGroup... groups) {
    List<String> labels = Stream.of(groups).map(ColumnGroup::label).toList();
    List<String> shown = labels.isEmpty() ? List.of(ColumnGroup.JOINTS.label()) : labels;
    return changed(old -> old.withColumns(shown));
  }

  private MechModel changed(UnaryOperator<SimulationSettings> change) {
    return chosen(choices.and(change));
  }

  private MechModel chosen(Choices other) {
    return new MechModel(file, other, model, userClasses);
  }

  /**
   * Returns the model with runs that take warnings for errors, as {@code mech simulate --strict}:
   * one of a model with warnings in its {@link #check} does not begin, and a run ends at its first
   * warning.
   */
  public MechModel strict() {
    return chosen(choices.endingAtWarnings());
  }

  /**
   * Returns the model with runs that end where their energy balance drifts by more than a part of
   * the energy scale.
   */
  public MechModel maxDrift(double part) {
    return chosen(choices.endingAtDrift(part));
  }

  /**
   * Returns the model without some warnings, those of its check and those of its runs.
   *
   * @param warnings their names or codes, such as {@code no-gravity} or {@code M-090}
   * @throws MechmlException if there is no such warning
   */
  public MechModel silence(String... warnings) throws MechmlException {
    Set<String> all = new LinkedHashSet<>(choices.reading.silenced());
    all.addAll(List.of(warnings));
    return reread(choices.reading.silencing(all));
  }

  /** Returns the consent to classes of forces with which the model was read. */
  public UserCode userCode() {
    return file.consent();
  }

  /**
   * Returns the class files of the classes that forces need, by binary name; not to be modified.
   */
  public SortedMap<String, byte[]> userClasses() {
    return code.userClassFiles();
  }

  /** Returns what is known about the model before it runs, as {@code mech check} tells it. */
  public CheckReport check() {
    SimulationSettings asked = code.settings();
    return CheckReport.of(model, asked.formulation(), asked.closure(), asked.run());
  }

  private void requireNoWarningsIfStrict() {
    SimulationSettings asked = code.settings();
    List<Diagnostic> warnings =
        choices.strict
            ? RunForecast.warnings(model, asked.formulation(), asked.closure(), asked.run())
            : List.of();
    if (!warnings.isEmpty()) {
      throw new IllegalArgumentException(
          warnings.stream()
              .map(Diagnostic::toString)
              .collect(
                  Collectors.joining(
                      "\n",
                      MessageCode.WARNINGS_REFUSED
                          + " the model has warnings, and strict was set:\n",
                      "")));
    }
  }

  /**
   * Runs the simulation that the file describes.
   *
   * @return its rows
   * @throws RunFailedException if it could not go on to its end; has the rows up to there
   * @throws IllegalArgumentException if a setting does not fit the model, or the model is strict
   *     and has warnings (S-164); says why
   */
  public Trajectory simulate() {
    return simulate(new RunControl());
  }

  /**
   * Runs the simulation that the file describes, under control.
   *
   * @param control stops the run, which then returns the rows up to there, pauses it and shows its
   *     progress to other threads
   * @throws RunFailedException if it could not go on to its end; has the rows up to there
   */
  public Trajectory simulate(RunControl control) {
    RowMemory rows = new RowMemory();
    try {
      RunReport report = run(rows, control, Checkpoints.NONE);
      Trajectory trajectory = new Trajectory(rows, report);
      RunFailedException.throwIfFailed(report, Optional.of(trajectory));
      return trajectory;
    } catch (IOException e) {
      throw new IllegalStateException("rows in memory are not written", e);
    }
  }

  /**
   * Runs the simulation and writes a CSV file, and the units beside it in a file that ends in
   * {@code .units.json}.
   *
   * @return what happened
   * @throws IOException if the file cannot be written
   * @throws RunFailedException if it could not go on to its end; the rows up to there are in the
   *     file
   */
  public RunReport simulate(Path csv) throws IOException {
    try (ResultFile file = new ResultFile(csv)) {
      RunReport report = run(file, new RunControl(), Checkpoints.NONE);
      file.keep();
      return completed(report);
    }
  }

  /**
   * Runs the simulation and hands each row to a sink as it arises.
   *
   * @param control stops and pauses the run
   * @param checkpoints keeps what a run needs to be taken up again with the same bits; {@link
   *     Checkpoints#modelHash} may be {@link #sha256}
   * @return what happened
   * @throws IOException if the sink or the checkpoints throw it
   * @throws RunFailedException if the run could not go on to its end
   */
  public RunReport simulate(ResultSink sink, RunControl control, Checkpoints checkpoints)
      throws IOException {
    return completed(run(sink, control, checkpoints));
  }

  /**
   * Begins a run that is stepped from outside: between two steps the inputs of the model, also
   * those with a table, are set, and within a step they are constant.
   *
   * @param step time between two steps, s
   * @return the run at its start
   * @throws MechmlException if the model cannot be used so
   * @throws IllegalArgumentException if a setting does not fit the model, or the simulation is not
   *     integrated in time (S-195), or the model is strict and has warnings (S-164)
   * @throws RunFailedException if the run cannot begin
   */
  public SteppedModel stepped(double step) throws MechmlException {
    requireNoWarningsIfStrict();
    MechModel open = reread(choices.reading.withInputsFromOutside()).every(step);
    return SteppedModel.begin(
        new RuntimeSolver(),
        open.code.compiled().newInstance(),
        open.request(),
        open.sha256(),
        open.inputs());
  }

  /**
   * Goes on with a run that was stepped from outside and saved; its further rows are then the same
   * to the bit.
   *
   * @param step as of the saved run
   * @param saved from {@link SteppedModel#save}
   * @throws MechmlException if the model cannot be used so
   * @throws IllegalArgumentException S-071 if the bytes do not belong to such a run of this model
   */
  public SteppedModel stepped(double step, byte[] saved) throws MechmlException {
    requireNoWarningsIfStrict();
    MechModel open = reread(choices.reading.withInputsFromOutside()).every(step);
    return SteppedModel.restored(
        new RuntimeSolver(),
        open.code.compiled().newInstance(),
        open.request(),
        open.sha256(),
        open.inputs(),
        saved);
  }

  private Set<String> inputs() {
    return model.mechanism().furtherStates().stream()
        .filter(state -> state.role() == FurtherState.Role.INPUT)
        .map(FurtherState::name)
        .collect(Collectors.toSet());
  }

  private static RunReport completed(RunReport report) {
    RunFailedException.throwIfFailed(report, Optional.empty());
    return report;
  }

  private RunReport run(ResultSink sink, RunControl control, Checkpoints checkpoints)
      throws IOException {
    requireNoWarningsIfStrict();
    return noting(
        new RuntimeSolver()
            .run(code.compiled().newInstance(), request(), sink, control, checkpoints));
  }

  /** A run with classes that nothing confines says so. */
  private RunReport noting(RunReport report) {
    return unconfined().map(note -> report.with(note)).orElse(report);
  }

  private Optional<RunNotes.Note> unconfined() {
    return userClasses.isEmpty()
        ? Optional.empty()
        : file.consent()
            .warning(Confinement.ofThisMachine())
            .map(why -> new RunNotes.Note(MessageCode.USER_CODE_UNCONFINED, 0, true, why));
  }

  /**
   * Returns the warning that the classes of forces run unconfined, because the consent says so and
   * this machine cannot confine them; empty if they do not.
   */
  public Optional<String> userCodeWarning() {
    return unconfined().map(note -> note.code() + " " + note.text());
  }

  /** Returns what {@link #simulate} asks of the solver. */
  public RunRequest request() {
    return new RunRequest(
        code.run(),
        ModelColumns.shown(code.settings()),
        choices.strict,
        choices.maxDrift,
        model.silenced());
  }

  /**
   * Returns a source of instances of the generated model, one for each run, with values of its
   * tunable parameters.
   *
   * @throws IllegalArgumentException if the model cannot be built so; says why
   */
  public ModelSource instances() {
    return code.compiled().instances();
  }

  /**
   * Returns a source of instances as {@link #instances()} does, with the classes of an earlier
   * model that differs from this one in numbers only. The bits are the same; the virtual machine
   * has compiled the code already.
   *
   * @param code of one thread, which uses no model of an earlier source any more
   */
  public ModelSource instances(ReusedCode code) {
    return this.code.instances(code);
  }

  /** Returns the SHA-256 of the model's class files, which identifies it to the bit. */
  public String sha256() {
    return code.compiled().classes().sha256();
  }

  /**
   * Finds where the mechanism comes to rest, prescribed motions held as at the start.
   *
   * @return one row, of all columns but those of energy
   * @throws RunFailedException if there is no equilibrium to be found
   */
  public Trajectory equilibrium() {
    return as(AnalysisKind.EQUILIBRIUM)
        .run(run -> run.withOutput(run.tStart(), run.tStep()))
        .simulate();
  }

  /**
   * Computes the frequencies, dampings and shapes of small motions about the start.
   *
   * @return a row for each mode, the slowest first
   * @throws RunFailedException if a force has no derivative there
   */
  public Trajectory modes() {
    return as(AnalysisKind.MODES).simulate();
  }

  /**
   * Computes the matrices of small motions about the start, M z'' + C z' + K z = 0.
   *
   * @return a row for each equation
   * @throws RunFailedException if a force has no derivative there
   */
  public Trajectory linearise() {
    return as(AnalysisKind.LINEARISE).simulate();
  }

  /**
   * Computes the linear system x' = A x + B u, y = C x + D u from the inputs to the outputs of the
   * model about the start. Inputs with a table are inputs here, too.
   *
   * @throws MechmlException if the model cannot be used so
   * @throws RunFailedException if a force has no derivative there
   */
  public LinearSystem linearSystem() throws MechmlException {
    MechModel open = reread(choices.reading.withInputsFromOutside());
    Trajectory table = open.as(AnalysisKind.LINEAR_SYSTEM).simulate();
    List<Variable> outputs = new ArrayList<>();
    open.model.outputs().forEach(o -> outputs.add(new Variable(o.name(), o.unit())));
    return SystemTable.of(table, outputs);
  }

  /** Computes the motion of driven coordinates and of all that depend on them, without forces. */
  public Trajectory kinematics() {
    return as(AnalysisKind.KINEMATICS).simulate();
  }

  /** Computes the forces in the driven coordinates that produce the prescribed motion. */
  public Trajectory inverseDynamics() {
    return as(AnalysisKind.INVERSE_DYNAMICS).simulate();
  }

  private MechModel as(AnalysisKind kind) {
    return new MechModel(file, choices, model.analysed(kind), userClasses);
  }

  /**
   * Measures error against run time of every method that fits the model, and writes the page of
   * {@code mech report} and its data. The methods are timed in this process, and their first runs
   * in Java machines of their own.
   *
   * @param folder for the pages; a report that was interrupted is taken up again there
   * @return the page, {@code folder/NAME.html} of a file {@code NAME.xml}
   * @throws IOException if the page cannot be written
   * @throws InterruptedException if this thread is interrupted while another Java machine runs
   * @throws IllegalArgumentException if the model cannot be built, or its simulation is not
   *     integrated in time (S-008)
   */
  public Path report(Path folder) throws IOException, InterruptedException {
    return report(folder, Effort.FULL, ReportProgress.SILENT);
  }

  /**
   * Measures error against run time with an effort, and writes the page of {@code mech report}.
   *
   * <pre>{@code
   * Path page = model.report(Path.of("pages"), Effort.QUICK, ReportProgress.SILENT);
   * }</pre>
   *
   * @param folder for the pages; a report that was interrupted is taken up again there
   * @param effort {@link Effort#QUICK} takes about a minute, and up to three for a large mechanism,
   *     as {@code mech report --quick}; {@link Effort#FULL} some minutes, and up to fifteen
   * @param progress is told what is being measured; what it throws ends the report, which keeps
   *     what was measured
   * @return the page
   * @throws IOException if the page cannot be written
   * @throws InterruptedException if this thread is interrupted while another Java machine runs
   */
  public Path report(Path folder, Effort effort, ReportProgress progress)
      throws IOException, InterruptedException {
    return new ModelReport(builds(), folder, effort, progress).write(Path.of(file.name()));
  }

  private MethodBuilds builds() {
    if (!(model.settings().task() instanceof SimulationTask.Dynamic)) {
      throw new IllegalArgumentException(
          MessageCode.OPTION_VALUE
              + " the simulation is <"
              + model.settings().task().element()
              + ">; a report compares methods of <dynamic>, which another simulation may be");
    }
    String asked =
        String.join(
            "; ",
            choices.reading.simulation().toString(),
            new TreeMap<>(choices.reading.values()).toString(),
            new TreeSet<>(choices.reading.tunable()).toString(),
            code.settings().toString());
    String content = file.sha256();
    return new ModelBuilds(
        content + " " + Sha256.of(asked.getBytes(StandardCharsets.UTF_8)),
        content,
        !userClasses.isEmpty(),
        method -> with(method).code.built(),
        method -> with(method).columns(ColumnGroup.CONSTRAINTS).code.built());
  }

  private MechModel with(SimulationMethod method) {
    MechModel chosen = formulation(method.formulation()).integrator(method.integrator());
    return method.closure().equals(MethodNames.NONE)
        ? chosen
        : chosen.changed(old -> old.withClosure(method.closure()));
  }

  /**
   * Writes the model as a JAR that holds the solver too: {@code java -jar} runs it.
   *
   * @throws IOException if it cannot be written
   */
  public void writeJar(Path jar) throws IOException {
    JarImage image = ModelJars.standalone(code.built(), file.sha256());
    Files.write(jar, image.bytes());
  }

  /**
   * Writes the mechanism as a robot in URDF, with the present values of its parameters.
   *
   * @return what URDF cannot express and is left out: warnings M-087; empty if the robot is the
   *     whole mechanism
   * @throws MechmlException M-086 if the mechanism would be another one: closed loops, constraints,
   *     joints of types S, PL and H
   * @throws IOException if the file cannot be written
   */
  public List<Diagnostic> writeUrdf(Path urdf) throws IOException, MechmlException {
    RobotExport robot = urdf();
    Files.writeString(urdf, robot.text());
    return robot.losses();
  }

  /**
   * Returns the mechanism as a robot in URDF with what is left out; {@link #writeUrdf} writes it.
   *
   * @throws MechmlException M-086 if the mechanism would be another one
   */
  public RobotExport urdf() throws MechmlException {
    return RobotExport.of(file.name(), model, file());
  }

  /**
   * Writes the mechanism as a model of MuJoCo, with the present values of its parameters.
   *
   * @return what MJCF cannot express and is left out: warnings M-087
   * @throws MechmlException M-086 as {@link #mjcf}
   * @throws IOException if the file cannot be written
   */
  public List<Diagnostic> writeMjcf(Path mjcf) throws IOException, MechmlException {
    RobotExport robot = mjcf();
    Files.writeString(mjcf, robot.text());
    return robot.losses();
  }

  /**
   * Returns the mechanism as a model of MuJoCo, with the present values of its parameters, and what
   * MJCF cannot express and is left out.
   *
   * @throws MechmlException M-086 if the mechanism would be another one: constraints and joints
   *     that MJCF does not have, moving bodies without mass
   */
  public RobotExport mjcf() throws MechmlException {
    return RobotExport.mjcf(file.name(), model);
  }

  @Override
  public String toString() {
    return "model \"" + name() + "\" of " + file.name();
  }
}
