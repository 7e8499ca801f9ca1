package org.mechservice.sim.service.run;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.mechservice.guard.Confinement;
import org.mechservice.guard.UserCode;
import org.mechservice.guard.WorkerBounds;
import org.mechservice.guard.worker.WorkerLostException;
import org.mechservice.guard.worker.WorkerModel;
import org.mechservice.guard.worker.WorkerOrder;
import org.mechservice.guard.worker.WorkerProcess;
import org.mechservice.guard.worker.WorkerResult;
import org.mechservice.sim.model.ModelClasses;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.simulation.Simulation;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Computes in a process of its own, the only place where classes of users are loaded. */
final class WorkerTask implements RunTask {
  private static final Logger LOG = LoggerFactory.getLogger(WorkerTask.class);

  private final ModelClasses compiled;
  private final Model described;
  private final List<TunableParameter> parameters;
  private final Map<String, String> values;
  private final RunRequest request;
  private final WorkerBounds bounds;
  private final RunCheckpoints checkpoints;
  private final WorkerProcess worker;

  /**
   * @param bounds what the process may use at most
   */
  WorkerTask(ModelClasses compiled, RunRequest request, WorkerBounds bounds) {
    this(
        compiled,
        compiled.describing().parameters(),
        Map.of(),
        request,
        bounds,
        new RunCheckpoints(compiled::sha256, Simulation.canBeSaved(compiled.describing().model())));
  }

  private WorkerTask(
      ModelClasses compiled,
      List<TunableParameter> parameters,
      Map<String, String> values,
      RunRequest request,
      WorkerBounds bounds,
      RunCheckpoints checkpoints) {
    this.compiled = compiled;
    this.parameters = parameters;
    this.values = values;
    this.request = request;
    this.bounds = bounds;
    this.checkpoints = checkpoints;
    described = compiled.describing().model(values);
    worker = new WorkerProcess(Confinement.ofThisMachine(), bounds);
  }

  /** Returns the model, with names and columns but without what its users have written. */
  @Override
  public Model model() {
    return described;
  }

  @Override
  public List<TunableParameter> parameters() {
    return parameters;
  }

  @Override
  public RunTask with(Map<String, String> changed) {
    return new WorkerTask(
        compiled,
        LocalTask.changed(compiled.describing().parameters(), changed),
        changed,
        request,
        bounds,
        checkpoints);
  }

  @Override
  public List<Variable> columns() {
    List<Variable> known = Simulation.columns(described, request.columns());
    return request.columns().contains(ColumnGroup.FORCES)
        ? columnsWithValuesOfForces().orElse(known)
        : known;
  }

  /**
   * Computes the first row in a process of its own. If there is none, the reason is the same that
   * will end the run, which reports it.
   *
   * @throws CancellationException if the thread is interrupted: its session has ended
   */
  private Optional<List<Variable>> columnsWithValuesOfForces() {
    RunSettings settings = request.settings();
    RunRequest first =
        new RunRequest(settings.withOutput(settings.tStart(), settings.tStep()), request.columns());
    try (WorkerProcess other = new WorkerProcess(Confinement.ofThisMachine(), bounds)) {
      return Optional.of(other.columns(order(first)));
    } catch (IOException | IllegalArgumentException | WorkerLostException e) {
      LOG.debug("no columns from the classes of users", e);
      return Optional.empty();
    }
  }

  @Override
  public ModelDescription description() {
    return described.description();
  }

  @Override
  public RunSettings settings() {
    return request.settings();
  }

  @Override
  public void initialState(double[] y) {
    described.initialState(y);
  }

  @Override
  public RunCheckpoints checkpoints() {
    return checkpoints;
  }

  @Override
  public long cpuNanos() {
    return worker.cpuNanos();
  }

  @Override
  public void lowerPriority() {
    worker.lowerPriority();
  }

  @Override
  public WorkerResult run(ResultSink sink, RunControl control) throws IOException {
    checkpoints.ofParameters(parameters);
    return noting(worker.run(order(request), sink, control, checkpoints));
  }

  /** A run that nothing confines says so. */
  private static WorkerResult noting(WorkerResult result) {
    Optional<String> warning = UserCode.NONE.unconfined().warning(Confinement.ofThisMachine());
    if (warning.isEmpty()) {
      return result;
    }
    return result.with(new RunNotes.Note(MessageCode.USER_CODE_UNCONFINED, 0, true, warning.get()));
  }

  private WorkerOrder order(RunRequest asked) {
    return new WorkerOrder(
        new WorkerModel(
            compiled.generated().className(), compiled.files().own(), compiled.files().ofUsers()),
        values,
        asked);
  }
}
