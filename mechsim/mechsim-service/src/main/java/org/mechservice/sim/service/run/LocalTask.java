package org.mechservice.sim.service.run;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.List;
import java.util.Map;
import org.mechservice.guard.worker.WorkerResult;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.simulation.Simulation;

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
record LocalTask(
    Solver solver,
    ModelSource source,
    Model model,
    List<TunableParameter> parameters,
    RunRequest request,
    RunCheckpoints checkpoints,
    ThreadClock clock)
    implements RunTask {
  @Override
  public List<Variable> columns() {
    return Simulation.columns(model, request.columns());
  }

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
    return new LocalTask(
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

  /** The processor time of the thread that started it. Thread-safe. */
  static final class ThreadClock {
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final long NOT_STARTED = -1;

    private volatile long threadId = NOT_STARTED;
    private volatile long atStart;

    /** Begins to count, for the thread that calls. */
    void start() {
      long id = Thread.currentThread().getId();
      atStart = now(id);
      threadId = id;
    }

    /** Returns the time since the start, ns; 0 before it, and where it cannot be measured. */
    long nanos() {
      long id = threadId;
      return id == NOT_STARTED ? 0 : Math.max(0, now(id) - atStart);
    }

    private static long now(long id) {
      return THREADS.isThreadCpuTimeSupported() ? THREADS.getThreadCpuTime(id) : 0;
    }
  }
}
