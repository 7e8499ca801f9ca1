package org.mechservice.client;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.mechservice.client.failure.InvalidModelException;
import org.mechservice.client.failure.InvalidOptionException;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.client.run.CheckpointStore;
import org.mechservice.client.run.ControlledRun;
import org.mechservice.client.run.RemoteRun;
import org.mechservice.client.run.ReportReader;
import org.mechservice.client.run.RunProgress;
import org.mechservice.client.run.RunResult;
import org.mechservice.guard.UserCode;
import org.mechservice.idl.ModelReading;
import org.mechservice.idl.OPT_T_STEP;
import org.mechservice.report.measure.Effort;
import org.mechservice.report.measure.ReportProgress;
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
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.catalogue.AnalysisKind;
import org.mechservice.solver.system.LinearSystem;
import org.mechservice.solver.system.SystemTable;
import org.mechservice.solver.text.ResultFile;

/**
 * A model at a server with the settings of its run: the verbs of {@code MechModel} of the library
 * in process, with the same names, arguments and results to the bit. A program goes to a server
 * when it takes its model from {@link MechConnection#read} instead of {@code MechModel.read}.
 *
 * <p>Runs and analyses are computed at the server, and their rows come in blocks. Three verbs bring
 * the compiled model and the server's solver to this machine: {@link #stepped}, whose steps would
 * otherwise each wait for the network, {@link #instances} and {@link #writeJar}; {@link #report}
 * brings it with each method.
 *
 * <p>Immutable: each change returns another model of the same session. May be used by several
 * threads.
 */
public final class RemoteModel {
  /** The report of the server about a model before it runs. */
  public record CheckText(String text, String json) {}

  private final MechSession session;
  private final String source;
  private final SimulationOptions options;

  RemoteModel(MechSession session, String source) {
    this(session, source, SimulationOptions.asInFile());
  }

  private RemoteModel(MechSession session, String source, SimulationOptions options) {
    this.session = session;
    this.source = source;
    this.options = options;
  }

  private RemoteModel with(SimulationOptions other) {
    return new RemoteModel(session, source, other);
  }

  /** Returns the model with options that decide how its file is read; the server checks them. */
  private RemoteModel reread(SimulationOptions other) {
    reading(other);
    return with(other);
  }

  private ModelReading reading(SimulationOptions asked) {
    synchronized (session) {
      return session.read(asked);
    }
  }

  /** Returns the model's name. */
  public String name() {
    synchronized (session) {
      return session.model().name();
    }
  }

  /** Returns the parameters of the file in its order, with their present values. */
  public List<ModelParameter> parameters() {
    return Stream.of(reading(options).parameters)
        .map(p -> new ModelParameter(p.name, p.unit, p.value, p.tunable))
        .toList();
  }

  /** Returns the names of the simulations of the file, in its order; empty where one has none. */
  public List<String> simulations() {
    return List.of(reading(options).simulations);
  }

  /**
   * Returns the model with another value of a parameter.
   *
   * @param value in the unit that the file gives the parameter
   * @throws InvalidModelException if there is no such parameter, or the model cannot be used so
   */
  public RemoteModel set(String parameter, double value) {
    return set(parameter, Double.toString(value));
  }

  /**
   * Returns the model with another value of a parameter.
   *
   * @param value number or expression of the file's language, in the unit that the file gives it
   * @throws InvalidModelException if there is no such parameter, or the model cannot be used so
   */
  public RemoteModel set(String parameter, String value) {
    return reread(options.parameter(parameter, value));
  }

  /**
   * Returns the model with other values of some parameters.
   *
   * @param given values in the units that the file gives the parameters, by name
   * @throws InvalidModelException if there is no such parameter, or the model cannot be used so
   */
  public RemoteModel set(Map<String, Double> given) {
    SimulationOptions more = options;
    for (Map.Entry<String, Double> one : given.entrySet()) {
      more = more.parameter(one.getKey(), Double.toString(one.getValue()));
    }
    return reread(more);
  }

  /**
   * Returns the model with parameters that stay inputs of its code: {@link #instances} sets them
   * without generating code again.
   *
   * @throws InvalidModelException if there is no such parameter, or what depends on it is settled
   *     when the file is read (M-017)
   */
  public RemoteModel tunable(Set<String> parameters) {
    SimulationOptions more = options;
    for (String name : parameters) {
      more = more.tunable(name);
    }
    return reread(more);
  }

  /**
   * Returns the model with another simulation of its file.
   *
   * @param nameOrNumber its name, or its number from 1
   * @throws InvalidModelException if there is none of that name
   */
  public RemoteModel simulation(String nameOrNumber) {
    return reread(options.simulation(nameOrNumber));
  }

  /** Returns the model with runs that end at another time, s. */
  public RemoteModel until(double tEnd) {
    return with(options.endTime(tEnd));
  }

  /** Returns the model with another distance of the rows, s. */
  public RemoteModel every(double tStep) {
    return with(options.outputStep(tStep));
  }

  /** Returns the model with another integrator, such as {@code ode15s}, or {@code auto}. */
  public RemoteModel integrator(String name) {
    return with(options.integrator(name));
  }

  /**
   * Returns the model with other tolerances.
   *
   * @param relative of each step, relative to the state
   * @param absolute one for all states, SI, or four: of displacements, angles, velocities, angular
   *     velocities
   */
  public RemoteModel tolerances(double relative, double... absolute) {
    if (absolute.length != 1 && absolute.length != 4) {
      throw new IllegalArgumentException(
          "there is one absolute tolerance or four, not " + absolute.length);
    }
    String each =
        Arrays.stream(absolute).mapToObj(Double::toString).collect(Collectors.joining(";"));
    return with(options.relativeTolerance(relative).absoluteTolerances(each));
  }

  /** Returns the model with another formulation: {@code auto}, {@code DTR}, {@code RR} etc. */
  public RemoteModel formulation(String name) {
    return with(options.formulation(name));
  }

  /**
   * Returns the model with another closure of loops: {@code auto}, {@code projection} or {@code
   * penalty}, with numbers of its own {@code penalty:alpha=1e7,omega=10,mu=1}.
   */
  public RemoteModel closure(String name) {
    return with(options.closure(name));
  }

  /**
   * Returns the model with another relation of the final error to the tolerances: {@code standard},
   * or {@code strict}, which makes errors smaller at the same tolerances.
   */
  public RemoteModel accuracy(String name) {
    return with(options.accuracy(name));
  }

  /** Returns the model with runs that put out these columns besides time and the joints' states. */
  public RemoteModel columns(ColumnGroup... groups) {
    EnumSet<ColumnGroup> all = EnumSet.of(ColumnGroup.JOINTS);
    all.addAll(Arrays.asList(groups));
    return with(options.columns(all));
  }

  /** Returns the model with runs that end at their first warning. */
  public RemoteModel strict() {
    return with(options.strict());
  }

  /**
   * Returns the model with runs that end where their energy balance drifts by more than a part of
   * the energy scale.
   */
  public RemoteModel maxDrift(double part) {
    return with(options.maxDrift(part));
  }

  /**
   * Returns the model without some warnings, those of its check and those of its runs.
   *
   * @param warnings their names or codes, such as {@code no-gravity} or {@code M-090}
   * @throws InvalidModelException if there is no such warning
   */
  public RemoteModel silence(String... warnings) {
    SimulationOptions more = options;
    for (String warning : warnings) {
      more = more.silence(warning);
    }
    return reread(more);
  }

  /** Returns what is known about the model before it runs, as {@code mech check} tells it. */
  public CheckText check() {
    synchronized (session) {
      return new CheckText(session.checkReport(options, false), session.checkReport(options, true));
    }
  }

  /**
   * Runs the simulation that the file describes.
   *
   * @return its rows
   * @throws RunFailedException if it could not go on to its end; has the rows up to there
   * @throws InvalidOptionException if a setting does not fit the model; says why
   * @throws ServiceException if the server is lost or has no place
   */
  public Trajectory simulate() {
    return rows(options, Optional.empty());
  }

  /**
   * Runs the simulation that the file describes, under control.
   *
   * @param control stops the run, which then returns the rows up to there, pauses it and shows its
   *     progress to other threads; the server learns it within 0.1 s
   * @throws RunFailedException if it could not go on to its end; has the rows up to there
   */
  public Trajectory simulate(RunControl control) {
    return rows(options, Optional.of(control));
  }

  private Trajectory rows(SimulationOptions asked, Optional<RunControl> control) {
    RowMemory rows = new RowMemory();
    try {
      RunReport report = run(asked, rows, control, CheckpointStore.NONE);
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
      RunReport report = run(options, file, Optional.empty(), CheckpointStore.NONE);
      file.keep();
      return completed(report);
    }
  }

  /**
   * Runs the simulation and hands each row to a sink as it arrives.
   *
   * @param control stops and pauses the run
   * @param checkpoints keeps what a run needs to be taken up again with the same bits; the server
   *     identifies the model itself, so that {@link Checkpoints#modelHash} is not used
   * @return what happened
   * @throws IOException if the sink or the checkpoints throw it
   * @throws RunFailedException if the run could not go on to its end
   */
  public RunReport simulate(ResultSink sink, RunControl control, Checkpoints checkpoints)
      throws IOException {
    return completed(run(options, sink, Optional.of(control), CheckpointStore.of(checkpoints)));
  }

  private static RunReport completed(RunReport report) {
    RunFailedException.throwIfFailed(report, Optional.empty());
    return report;
  }

  private RunReport run(
      SimulationOptions asked, ResultSink sink, Optional<RunControl> control, CheckpointStore store)
      throws IOException {
    try (RemoteRun run = prepared(asked)) {
      RunResult result =
          control.isPresent()
              ? new ControlledRun(run, control.get()).toEnd(sink, store)
              : run.toEnd(sink, store);
      RunProgress reached = run.progress();
      return ReportReader.of(result, reached.startTime(), reached.endTime(), rowDistance(asked));
    }
  }

  private RemoteRun prepared(SimulationOptions asked) {
    synchronized (session) {
      return session.prepareRemoteRun(asked);
    }
  }

  private double rowDistance(SimulationOptions asked) {
    synchronized (session) {
      String key = OPT_T_STEP.value;
      String text =
          asked.text(key).orElseGet(() -> session.model().settings().getOrDefault(key, "0"));
      return Double.parseDouble(text);
    }
  }

  /**
   * Begins a run that is stepped from outside: between two steps the inputs of the model, also
   * those with a table, are set, and within a step they are constant. The server compiles the
   * model; the steps are taken on this machine, by the solver of this program, in a process that
   * confines the model's classes. A step that takes more than ten minutes ends it, and so does an
   * interrupt of the thread that waits for a step: the run has then failed (S-157).
   *
   * @param step time between two steps, s
   * @return the run at its start
   * @throws InvalidModelException if the model cannot be used so
   * @throws InvalidOptionException if a setting does not fit the model
   * @throws IllegalArgumentException S-195 if the simulation is not integrated in time
   * @throws RunFailedException if the run cannot begin
   * @throws JarRefusedException if the model's classes cannot be confined on this machine
   * @throws UncheckedIOException if no process can be started for it
   */
  public SteppedModel stepped(double step) {
    return SteppedModel.begin(outside(step));
  }

  /**
   * Goes on with a run that was stepped from outside and saved; its further rows are then the same
   * to the bit.
   *
   * @param step as of the saved run
   * @param saved from {@link SteppedModel#save} of a model of this or another server
   * @throws IllegalArgumentException S-071 if the bytes do not belong to such a run of this model
   * @throws UncheckedIOException if no process can be started for it
   */
  public SteppedModel stepped(double step, byte[] saved) {
    return SteppedModel.restored(outside(step), saved);
  }

  private SteppedModel.Source outside(double step) {
    try {
      synchronized (session) {
        return session.prepareSteps(options.inputsFromOutside().outputStep(step));
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * Returns a source of instances of the generated model for runs in this process, with values of
   * its tunable parameters. They have all rights of this program: the model was read with {@link
   * UserCode#unconfined}, or the server is part of this program.
   *
   * @throws InvalidOptionException if the model cannot be built so; says why
   * @throws JarRefusedException S-168 without that consent
   */
  public ModelSource instances() {
    synchronized (session) {
      return session.fetchModel(options).source();
    }
  }

  /** Returns the SHA-256 of the model's JAR, which identifies model and settings to the bit. */
  public String sha256() {
    synchronized (session) {
      return session.build(options, false).sha256();
    }
  }

  /**
   * Finds where the mechanism comes to rest, prescribed motions held as at the start.
   *
   * @return one row, of all columns but those of energy
   * @throws RunFailedException if there is no equilibrium to be found
   */
  public Trajectory equilibrium() {
    return analysis(AnalysisKind.EQUILIBRIUM);
  }

  /**
   * Computes the frequencies, dampings and shapes of small motions about the start.
   *
   * @return a row for each mode, the slowest first
   * @throws RunFailedException if a force has no derivative there
   */
  public Trajectory modes() {
    return analysis(AnalysisKind.MODES);
  }

  /**
   * Computes the matrices of small motions about the start, M z'' + C z' + K z = 0.
   *
   * @return a row for each equation
   * @throws RunFailedException if a force has no derivative there
   */
  public Trajectory linearise() {
    return analysis(AnalysisKind.LINEARISE);
  }

  /**
   * Computes the linear system x' = A x + B u, y = C x + D u from the inputs to the outputs of the
   * model about the start. Inputs with a table are inputs here, too.
   *
   * @throws InvalidModelException if the model cannot be used so
   * @throws RunFailedException if a force has no derivative there
   */
  public LinearSystem linearSystem() {
    SimulationOptions open = options.inputsFromOutside();
    Trajectory table = rows(open.analysis(AnalysisKind.LINEAR_SYSTEM), Optional.empty());
    List<Variable> outputs =
        Stream.of(reading(open).outputs).map(o -> new Variable(o.name, o.unit)).toList();
    return SystemTable.of(table, outputs);
  }

  /** Computes the motion of driven coordinates and of all that depend on them, without forces. */
  public Trajectory kinematics() {
    return analysis(AnalysisKind.KINEMATICS);
  }

  /** Computes the forces in the driven coordinates that produce the prescribed motion. */
  public Trajectory inverseDynamics() {
    return analysis(AnalysisKind.INVERSE_DYNAMICS);
  }

  private Trajectory analysis(AnalysisKind kind) {
    return rows(options.analysis(kind), Optional.empty());
  }

  /**
   * Measures error against run time of every method that fits the model, and writes the page of
   * {@code mech report} and its data. The server builds the methods; they run, and are timed, on
   * this machine. The project needs {@code org.mechservice:mechreport} for it, which no other verb
   * needs.
   *
   * @param folder for the pages; a report that was interrupted is taken up again there
   * @return the page, {@code folder/NAME.html} of a file {@code NAME.xml}
   * @throws IOException if the page cannot be written
   * @throws InterruptedException if this thread is interrupted while another Java machine runs
   * @throws ServiceException if the model cannot be built; says why
   * @throws IllegalStateException if {@code mechreport} is not on the class path
   */
  public Path report(Path folder) throws IOException, InterruptedException {
    try {
      return report(folder, Effort.FULL, ReportProgress.SILENT);
    } catch (NoClassDefFoundError missing) {
      throw new IllegalStateException(
          "a report is measured in this process: add org.mechservice:mechreport to the project",
          missing);
    }
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
    return new SessionBuilds(session, options).report(Path.of(source), folder, effort, progress);
  }

  /**
   * Writes the model as a JAR that holds the solver too: {@code java -jar} runs it.
   *
   * @throws IOException if it cannot be written
   */
  public void writeJar(Path jar) throws IOException {
    byte[] bytes;
    synchronized (session) {
      bytes = session.build(options, true).bytes();
    }
    Files.write(jar, bytes);
  }

  @Override
  public String toString() {
    return "model \"" + name() + "\" of " + source;
  }
}
