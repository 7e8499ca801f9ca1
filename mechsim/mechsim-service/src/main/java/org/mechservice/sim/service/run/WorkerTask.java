package org.mechservice.sim.service.run;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.worker.Confinement;
import org.mechservice.sim.worker.WorkerBounds;
import org.mechservice.sim.worker.WorkerOrder;
import org.mechservice.sim.worker.WorkerProcess;
import org.mechservice.sim.worker.WorkerResult;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.simulation.Simulation;

/** Computes in a process of its own, the only place where classes of users are loaded. */
final class WorkerTask implements RunTask {
  private final CompiledModel compiled;
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
  WorkerTask(CompiledModel compiled, RunRequest request, WorkerBounds bounds) {
    this(
        compiled,
        compiled.describing().parameters(),
        Map.of(),
        request,
        bounds,
        new RunCheckpoints(compiled::sha256, Simulation.canBeSaved(compiled.describing().model())));
  }

  private WorkerTask(
      CompiledModel compiled,
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
  public WorkerResult run(ResultSink sink, RunControl control) throws IOException {
    var own = new TreeMap<>(compiled.classFiles());
    own.keySet().removeAll(compiled.userClassFiles().keySet());
    checkpoints.ofParameters(parameters);
    return worker.run(
        new WorkerOrder(
            compiled.generated().className(), own, compiled.userClassFiles(), values, request),
        sink,
        control,
        checkpoints);
  }
}
