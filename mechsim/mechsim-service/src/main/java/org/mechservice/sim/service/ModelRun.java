package org.mechservice.sim.service;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import org.mechservice.sim.worker.WorkerResult;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.ResultSink;
import org.mechservice.solver.api.RunControl;
import org.mechservice.solver.api.RunReport;
import org.mechservice.solver.api.RunRequest;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.TunableParameter;

/**
 * Computes in this process.
 *
 * @param solver integrates
 * @param source makes models like the one used
 * @param model used by this run alone
 * @param parameters tunable parameters with the values the model has
 * @param request what is wanted
 * @param checkpoints of the run
 * @param clock of the thread that computes
 */
record ModelRun(
    Solver solver,
    ModelSource source,
    Model model,
    List<TunableParameter> parameters,
    RunRequest request,
    RunCheckpoints checkpoints,
    ThreadClock clock)
    implements RunTask {
  @Override
  public ModelDescription description() {
    return model.description();
  }

  @Override
  public RunSettings settings() {
    return request.settings();
  }

  @Override
  public void initialState(double[] y) {
    model.initialState(y);
  }

  @Override
  public RunTask with(Map<String, String> values) {
    Model changed = source.model(values);
    return new ModelRun(
        solver, source, changed, changed(source.parameters(), values), request, checkpoints, clock);
  }

  /** Returns parameters with other values of some, which are numbers. */
  static List<TunableParameter> changed(
      List<TunableParameter> parameters, Map<String, String> values) {
    return parameters.stream()
        .map(p -> values.containsKey(p.name()) ? changed(p, values.get(p.name())) : p)
        .toList();
  }

  private static TunableParameter changed(TunableParameter parameter, String value) {
    return new TunableParameter(
        parameter.name(), parameter.unit(), Double.parseDouble(value.strip()));
  }

  @Override
  public long cpuNanos() {
    return clock.nanos();
  }

  @Override
  public WorkerResult run(ResultSink sink, RunControl control) throws IOException {
    clock.start();
    checkpoints.ofParameters(parameters);
    RunReport report = solver.run(model, request, sink, control, checkpoints);
    return new WorkerResult(report.asMap(), report.outcome());
  }
}
