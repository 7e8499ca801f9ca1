package org.mechservice.solver.simulation;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.MomentumBalance;
import org.mechservice.solver.api.capability.ResultColumns;
import org.mechservice.solver.api.capability.ResultTable;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.api.run.StepwiseRun;
import org.mechservice.solver.catalogue.IntegrationMethod;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorFactory;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.simulation.equations.EquationForm;
import org.mechservice.solver.simulation.equations.ExplicitForm;
import org.mechservice.solver.simulation.equations.ModelEquations;
import org.mechservice.solver.simulation.equations.RunEvents;

/**
 * Runs models with one integrator: takes steps, writes rows at the output times, monitors the
 * energy balance and obeys the control.
 */
public final class Simulation implements Solver {
  private final IntegratorFactory integrators;
  private final EquationForm form;

  /**
   * @param integrators creates the integrator of each run
   * @param form form of the equations for it
   */
  public Simulation(IntegratorFactory integrators, EquationForm form) {
    this.integrators = integrators;
    this.form = form;
  }

  /**
   * Returns the columns of a run, in order; the first is time.
   *
   * @param groups column groups besides time and the joints' states
   * @throws IllegalArgumentException if the model was built without one of the groups, or has no
   *     explicit form (S-061)
   */
  public static List<Variable> columns(Model model, Set<ColumnGroup> groups) {
    if (model instanceof ResultTable table) {
      return table.columns();
    }
    ModelParts parts = ModelParts.of(model);
    return new RowLayout(ExplicitForm.explicit(parts.equations()), parts.columns(), groups)
        .columns();
  }

  /** Returns whether runs of a model can write checkpoints. */
  public static boolean canBeSaved(Model model) {
    return CheckpointWriter.canBeSaved(ModelParts.of(model).equations());
  }

  /**
   * Rejects column groups that a model was built without.
   *
   * @param built groups it was built with
   * @throws IllegalArgumentException S-060 naming the first, and how to build the model with it
   */
  public static void requireColumns(Model model, Set<ColumnGroup> asked, Set<ColumnGroup> built) {
    for (ColumnGroup group : ColumnGroup.values()) {
      if (asked.contains(group) && !built.contains(group)) {
        throw RowLayout.builtWithout(model, group);
      }
    }
  }

  /**
   * Rejects a bound on the energy drift of a model that has no energy balance.
   *
   * @throws IllegalArgumentException S-166 with the reason
   */
  public static void requireBalance(Model model, RunRequest request) {
    if (request.maxDrift().isPresent()) {
      EnergyMonitor.requireBalance(ModelParts.of(model).equations());
    }
  }

  @Override
  public RunReport run(Model model, RunRequest request, ResultSink sink, RunControl control)
      throws IOException {
    return run(model, request, sink, control, Checkpoints.NONE);
  }

  @Override
  public RunReport run(
      Model model, RunRequest request, ResultSink sink, RunControl control, Checkpoints checkpoints)
      throws IOException {
    return begun(model, request, sink, control, checkpoints).toEnd();
  }

  private Run begun(
      Model model, RunRequest request, ResultSink sink, RunControl control, Checkpoints checkpoints)
      throws IOException {
    OutputTimes.requireUsable(request.settings());
    requireBalance(model, request);
    ModelParts parts = ModelParts.of(model);
    ModelEquations equations = form.of(parts.equations());
    RunEvents events = form.events(parts, equations, request.settings());
    return new Run(equations, events, parts.columns(), request, sink, control, checkpoints);
  }

  @Override
  public StepwiseRun stepped(Model model, RunRequest request, ResultSink sink, String modelHash)
      throws IOException {
    RunControl control = new RunControl();
    Run run = begun(model, request, sink, control, new SteppedRun.Saving(modelHash));
    run.breakAtRows();
    return new SteppedRun(run, control);
  }

  /** One run in progress. */
  final class Run {
    private final ExplicitModel model;
    private final RunSettings settings;
    private final RunControl control;
    private final boolean strict;
    private final Integrator integrator;
    private final ModelEquations equations;
    private final RunEvents events;
    private final OutputTimes outputTimes;
    private final RowWriter rows;
    private final WorkMeter work;
    private final StepWork stepWork;
    private final EnergyNet energyNet;
    private final Set<MessageCode> silenced;
    private final CheckpointWriter checkpoints;
    private final RunNoteCollector notes;
    private final RunFailures failures;
    private final Optional<MomentumBalance> momentum;
    private final ChosenState chosen;

    /** Of integrators whose stability has a limit. */
    private final Optional<StiffnessSamples> stiffness;

    private final double[] y;
    private final double[] yDot;

    private final long startedAt = System.nanoTime();
    private double timeReached;
    private long nextRow;
    private long steps;

    Run(
        ModelEquations equations,
        RunEvents events,
        ResultColumns further,
        RunRequest request,
        ResultSink sink,
        RunControl control,
        Checkpoints store)
        throws IOException {
      this.equations = equations;
      this.events = events;
      this.model = equations.model();
      this.settings = request.settings();
      this.control = control;
      strict = request.strict();
      integrator = events.watch(createIntegrator());
      outputTimes = new OutputTimes(settings);
      checkpoints = new CheckpointWriter(model, request, store);
      rows = new RowWriter(model, further, request, sink);
      momentum =
          request.columns().contains(ColumnGroup.MOMENTUM) ? further.momentum() : Optional.empty();
      momentum.ifPresent(MomentumBalance::begin);
      momentum.ifPresent(events::setMomentumBalance);
      work =
          new WorkMeter(
              equations, integrator, model, rows.measuresWork(), momentum, settings.tStart());
      double tolerance = settings.relativeTolerance();
      stepWork = StepWork.of(equations, integrator, model, !rows.measuresWork(), tolerance);
      energyNet = new EnergyNet(model, tolerance);
      silenced = request.silenced();
      notes = new RunNoteCollector(model, rows, events, integrator, momentum, request.silenced());
      failures =
          new RunFailures(
              equations, events, integrator, rows, momentum, request, () -> isStiff(false));
      stiffness =
          IntegrationMethod.find(settings.integrator())
              .filter(IntegrationMethod::stabilityHasLimit)
              .map(method -> new StiffnessSamples(model, equations.dimension(), settings));
      chosen = new ChosenState(equations, settings);
      y = new double[equations.dimension()];
      yDot = new double[equations.dimension()];
      timeReached = settings.tStart();
    }

    private Integrator createIntegrator() {
      try {
        return integrators.create(
            new IntegratorSettings(
                settings.relativeTolerance(),
                settings.hasOneTolerance()
                    ? List.of(settings.absoluteTolerance())
                    : equations.absoluteTolerances(settings),
                settings.maxStep(),
                settings.initialStep(),
                settings.maxOrder(),
                Long.MAX_VALUE,
                control::stopRequested,
                mode()));
      } catch (IllegalArgumentException e) {
        throw new IllegalArgumentException(
            MessageCode.INTEGRATOR_SETTINGS + " " + e.getMessage(), e);
      }
    }

    private IntegratorSettings.Mode mode() {
      return switch (settings.accuracy()) {
        case STANDARD -> IntegratorSettings.Mode.STANDARD;
        case STRICT -> IntegratorSettings.Mode.STRICT;
      };
    }

    RunReport toEnd() throws IOException {
      try {
        return report(integrate());
      } finally {
        control.setStates(Optional.empty());
      }
    }

    /** Copies the state in the form of a row. */
    private void copyState(double[] state) {
      if (steps > 0) {
        integrator.interpolate(timeReached, y, yDot);
        equations.closeLoops(timeReached, y);
      }
      rows.copyState(y, state);
    }

    private Outcome integrate() throws IOException {
      Optional<byte[]> saved = checkpoints.saved();
      if (saved.isPresent()) {
        return goOnFrom(saved.get());
      }
      Optional<Outcome> ended = begin();
      return ended.isPresent() ? ended.get() : stepToEnd();
    }

    /** Begins the integration and writes the first row; empty if the run goes on. */
    Optional<Outcome> begin() throws IOException {
      model.initialState(y);
      events.begin(settings.tStart(), y);
      StepResult result = equations.start(integrator, settings.tStart(), y, settings.tEnd());
      if (result == StepResult.FAILED) {
        return Optional.of(failures.atStart(y, yDot));
      }
      if (strict && notes.firstWarning().isPresent()) {
        return Optional.of(failures.ofWarning(notes.firstWarning().get()));
      }
      double first = outputTimes.time(nextRow);
      energyNet.begin(first, y);
      int badColumn = rows.write(first, first, y, 0, 0, false);
      if (badColumn != RowWriter.ALL_FINITE) {
        return Optional.of(failures.ofRow(first, badColumn));
      }
      nextRow++;
      stiffness.ifPresent(samples -> samples.begin(y));
      control.setStates(Optional.of(this::copyState));
      if (!control.proceed(settings.tStart(), 0, 0, 0)) {
        if (result == StepResult.ADVANCED) {
          keepIfDue(true);
        }
        return Optional.of(new Outcome.Stopped());
      }
      return result == StepResult.ADVANCED
          ? Optional.empty()
          : Optional.of(new Outcome.Completed());
    }

    private Outcome goOnFrom(byte[] saved) throws IOException {
      checkpoints.restore(saved, this::transfer);
      control.setStates(Optional.of(this::copyState));
      return goOn() ? stepToEnd() : new Outcome.Stopped();
    }

    /** Saves or restores the run between two steps. */
    private void transfer(SavedState state) {
      timeReached = state.number(timeReached);
      nextRow = state.integer(nextRow);
      steps = state.integer(steps);
      rows.transfer(state);
      work.transfer(state);
      stepWork.transfer(state);
      energyNet.transfer(state);
      notes.transfer(state);
      momentum.ifPresent(balance -> ModelEquations.transfer(balance, state));
      stiffness.ifPresent(samples -> samples.transfer(state));
      if (state.restoring()) {
        equations.resume(integrator, state.bytes(new byte[0]));
      } else {
        state.bytes(integrator.save());
      }
    }

    private Outcome stepToEnd() throws IOException {
      Optional<Outcome> ended = Optional.empty();
      while (ended.isEmpty()) {
        ended = step();
      }
      return ended.get();
    }

    /** Takes one step of the integrator and writes its rows; empty if the run goes on. */
    private Optional<Outcome> step() throws IOException {
      StepResult result = integrator.step();
      if (result == StepResult.FAILED) {
        return Optional.of(integratorFailed());
      }
      if (result == StepResult.STOPPED) {
        return Optional.of(new Outcome.Stopped());
      }
      steps++;
      if (stiffness.isPresent() && stiffness.get().stepped(integrator, steps, yDot)) {
        control.setStiff(isStiff(false));
      }
      stepWork.advance(result != StepResult.ADVANCED || dueRow() <= integrator.time());
      if (!rows.measuresWork()) {
        balance(result != StepResult.ADVANCED);
      }
      int badColumn = writeRowsOfStep();
      if (badColumn != RowWriter.ALL_FINITE) {
        return Optional.of(failures.ofRow(dueRow(), badColumn));
      }
      if (rows.measuresWork()) {
        balance(result != StepResult.ADVANCED);
      }
      if (events.failure().isPresent()) {
        return Optional.of(new Outcome.Failed(events.failure().get()));
      }
      if (strict && notes.firstWarning().isPresent()) {
        return Optional.of(failures.ofWarning(notes.firstWarning().get()));
      }
      double added = events.workOfEvents();
      work.add(added);
      stepWork.add(added);
      if (!proceed(result == StepResult.ADVANCED)) {
        return Optional.of(new Outcome.Stopped());
      }
      return result == StepResult.ADVANCED
          ? Optional.empty()
          : Optional.of(new Outcome.Completed());
    }

    /** Looks at the balance of energy at the end of the last step where that is due. */
    private void balance(boolean last) {
      double done = rows.measuresWork() ? work.work() : stepWork.work();
      if (energyNet.isDue(last, !Double.isNaN(done))) {
        double t = integrator.time();
        integrator.interpolate(t, y, yDot);
        energyNet.look(equations.evaluationTime(t), y, done, turnover());
      }
    }

    private double turnover() {
      return rows.measuresWork() ? work.turnover() : stepWork.turnover();
    }

    /** Looks at the balance in a row, where the energies are known. */
    private void lookAtRow(double t) {
      if (model instanceof Energies) {
        EnergyMonitor energy = rows.energyMonitor();
        double done = rows.measuresWork() ? work.work() : stepWork.work(t);
        energyNet.look(t, energy.kinetic(), energy.potential(), done, turnover());
      }
    }

    /** Makes steps end exactly at the rows. */
    void breakAtRows() {
      equations.alsoBreakAt(
          index -> index + 1 < outputTimes.count() ? outputTimes.time(index + 1) : Double.NaN);
    }

    /** Steps until the next output time has its row; empty if the run goes on from there. */
    Optional<Outcome> stepToRow() throws IOException {
      long row = nextRow;
      Optional<Outcome> ended = Optional.empty();
      while (ended.isEmpty() && nextRow == row) {
        ended = step();
      }
      // Inputs may be others from here on.
      stepWork.addWaiting();
      return ended;
    }

    double timeReached() {
      return timeReached;
    }

    ModelEquations equations() {
      return equations;
    }

    /** Writes the unknowns from which the run goes on. */
    void copyUnknowns(double[] unknowns) {
      if (events.stateAfter(timeReached, unknowns)) {
        return;
      }
      if (steps > 0) {
        integrator.interpolate(timeReached, y, yDot);
        equations.closeLoops(timeReached, y);
      }
      System.arraycopy(y, 0, unknowns, 0, y.length);
    }

    /**
     * Goes on from other unknowns; returns the outcome if that is not possible.
     *
     * @param present those that the run has reached; not modified
     * @param unknowns those to go on from: where they are others the loops are closed with them
     *     held; overwritten
     * @throws IllegalArgumentException S-195 if the loops do not close so; nothing has changed
     */
    Optional<Outcome> goOnFrom(double[] present, double[] unknowns) {
      chosen.close(equations.evaluationTime(timeReached), present, unknowns);
      double given = energyNet.change(equations.evaluationTime(timeReached), present, unknowns);
      work.add(given);
      stepWork.add(given);
      events.continueFrom(timeReached);
      StepResult result = integrator.restart(timeReached, unknowns);
      System.arraycopy(unknowns, 0, y, 0, y.length);
      return result == StepResult.ADVANCED
          ? Optional.empty()
          : Optional.of(result == StepResult.FAILED ? integratorFailed() : new Outcome.Completed());
    }

    /**
     * Writes the row of a state from which the run goes on; the outcome if that is not possible.
     */
    Optional<Outcome> writeRow(double[] unknowns) throws IOException {
      boolean unmeasured = !rows.measuresWork() && stepWork.turnover() > 0;
      double t = equations.evaluationTime(timeReached);
      int badColumn =
          rows.write(timeReached, t, unknowns, work.work(), work.turnover(), unmeasured);
      return badColumn == RowWriter.ALL_FINITE
          ? Optional.empty()
          : Optional.of(failures.ofRow(timeReached, badColumn));
    }

    byte[] save() {
      return checkpoints.save(this::transfer);
    }

    void restore(byte[] saved) {
      checkpoints.restore(saved, this::transfer);
    }

    /** Obeys the control between two steps, and stores a checkpoint if one is due. */
    private boolean proceed(boolean unfinished) throws IOException {
      boolean stands =
          control.holdsAt(timeReached, integrator.stepSize(), integrator.order(), steps);
      boolean kept = unfinished && keepIfDue(stands);
      if (goOn() || !unfinished) {
        return true;
      }
      if (!kept) {
        keepIfDue(true);
      }
      return false;
    }

    private boolean keepIfDue(boolean stands) throws IOException {
      return checkpoints.keepIfDue(stands, this::transfer);
    }

    private int writeRowsOfStep() throws IOException {
      timeReached = integrator.time();
      for (double t = dueRow(); t <= timeReached; t = dueRow()) {
        integrator.interpolate(t, y, yDot);
        if (!equations.closeLoops(t, y) || !work.advance(t)) {
          return RunFailures.LOOPS_OPEN;
        }
        boolean unmeasured = !rows.measuresWork() && stepWork.turnover() > 0;
        int badColumn =
            rows.write(t, equations.evaluationTime(t), y, work.work(), work.turnover(), unmeasured);
        if (badColumn != RowWriter.ALL_FINITE) {
          return badColumn;
        }
        lookAtRow(t);
        int drifted = failures.drifted();
        if (drifted != RowWriter.ALL_FINITE) {
          return drifted;
        }
        rowWritten(t);
      }
      return work.advance(timeReached) ? RowWriter.ALL_FINITE : RunFailures.LOOPS_OPEN;
    }

    /** Returns the time of the next row: an output time, or an event. */
    private double dueRow() {
      return Math.min(outputTimes.time(nextRow), events.dueRow());
    }

    private void rowWritten(double t) {
      if (t == events.dueRow()) {
        events.rowWritten();
      }
      if (t == outputTimes.time(nextRow)) {
        nextRow++;
      }
    }

    private boolean goOn() {
      return control.proceed(timeReached, integrator.stepSize(), integrator.order(), steps);
    }

    private Outcome integratorFailed() {
      if (steps > 0) {
        integrator.interpolate(integrator.time(), y, yDot);
      }
      return failures.ofIntegrator(y, yDot);
    }

    private boolean isStiff(boolean completed) {
      return stiffness.isPresent() && stiffness.get().areStiff(integrator, completed);
    }

    RunReport report(Outcome reached) {
      Optional<Note> off = energyNet.note().filter(note -> !silenced.contains(note.code()));
      Outcome outcome =
          strict && reached instanceof Outcome.Completed && off.isPresent()
              ? failures.ofWarning(off.get())
              : reached;
      List<Note> all = notes.all();
      off.ifPresent(all::add);
      IntegrationStatistics done = integrator.statistics();
      EnergyMonitor energy = rows.energyMonitor();
      return new RunReport(
          outcome,
          model.description().name(),
          model.description().formulation(),
          settings,
          done.steps(),
          done.rejectedSteps(),
          done.evaluations(),
          rows.rows(),
          timeReached,
          (System.nanoTime() - startedAt) * 1e-9,
          energy.drift(),
          energy.scale(),
          isStiff(outcome instanceof Outcome.Completed),
          done.jacobians(),
          done.factorisations(),
          failures.limits(done),
          all,
          SolverVersion.CURRENT);
    }
  }
}
