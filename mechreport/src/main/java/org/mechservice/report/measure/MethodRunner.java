package org.mechservice.report.measure;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import org.mechservice.report.method.Candidate;
import org.mechservice.report.solution.Reference;
import org.mechservice.report.solution.RunGrid;
import org.mechservice.report.solution.StateDistance;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;

/** Runs methods over a reference's interval and measures error and cost. */
public final class MethodRunner implements AutoCloseable {
  /** The absolute tolerance as a part of the relative one (per SI unit), unless said otherwise. */
  public static final double ABSOLUTE_PART = 0.01;

  private static final long LOOK_MILLIS = 20;

  /** No run can be stopped sooner, s. */
  static final double SHORTEST_LIMIT = 1e-3 * LOOK_MILLIS;

  /** Beginning of the cause of a run that was stopped for its time. */
  static final String NOT_FINISHED = "not finished within ";

  private final Reference reference;
  private final StateDistance distance;
  private final RunGrid grid;
  private final Optional<LoopForces> loops;
  private final double absolutePart;
  private double clockSeconds;
  private double processorSeconds;
  private final ScheduledExecutorService watch =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread thread = new Thread(task, "report-watch");
            thread.setDaemon(true);
            return thread;
          });

  /**
   * @param grid output times; they meet those of the reference
   */
  public MethodRunner(Reference reference, StateDistance distance, RunGrid grid) {
    this(reference, distance, grid, Optional.empty(), ABSOLUTE_PART);
  }

  /**
   * @param grid output times; they meet those of the reference
   * @param absolutePart the absolute tolerance as a part of the relative one (per SI unit)
   */
  public MethodRunner(
      Reference reference, StateDistance distance, RunGrid grid, double absolutePart) {
    this(reference, distance, grid, Optional.empty(), absolutePart);
  }

  /**
   * @param grid output times; they meet those of the reference
   * @param loops residuals and multipliers of closed loops, at times of the same reference
   */
  public MethodRunner(
      Reference reference, StateDistance distance, RunGrid grid, Optional<LoopForces> loops) {
    this(reference, distance, grid, loops, ABSOLUTE_PART);
  }

  private MethodRunner(
      Reference reference,
      StateDistance distance,
      RunGrid grid,
      Optional<LoopForces> loops,
      double absolutePart) {
    this.reference = reference;
    this.distance = distance;
    this.grid = grid;
    this.loops = loops;
    this.absolutePart = absolutePart;
  }

  /**
   * Runs a method once.
   *
   * @param round number for the record
   * @param limitSeconds processor time after which the run is stopped, s
   */
  public MeasuredRun run(Candidate candidate, double tolerance, int round, double limitSeconds) {
    Model model = candidate.models().get();
    return run(candidate, model, new RunControl(), tolerance, round, limitSeconds);
  }

  /** Runs a method once on a model given. */
  MeasuredRun run(
      Candidate candidate,
      Model model,
      RunControl control,
      double tolerance,
      int round,
      double limitSeconds) {
    RunSettings settings = settings(candidate, model, tolerance);
    Rows rows = new Rows(grid, settings.tEnd());
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    ScheduledFuture<?> alarm = stopAfter(limitSeconds, control, threads);
    long bytes = threads.getCurrentThreadAllocatedBytes();
    // The thread's own time: other processes of the machine do not count.
    long started = threads.getCurrentThreadCpuTime();
    long clock = System.nanoTime();
    RunReport report;
    try {
      RunRequest request = new RunRequest(settings, java.util.Set.of(ColumnGroup.JOINTS));
      report = candidate.solver().run(model, request, rows, control);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } finally {
      alarm.cancel(false);
    }
    double seconds = (threads.getCurrentThreadCpuTime() - started) * 1e-9;
    bytes = threads.getCurrentThreadAllocatedBytes() - bytes;
    clockSeconds += (System.nanoTime() - clock) * 1e-9;
    processorSeconds += seconds;
    return measured(candidate, tolerance, round, limitSeconds, report, rows, seconds, bytes);
  }

  /**
   * Returns how much longer the runs so far took by the clock than in processor time, since there
   * is other work on the machine; at least 1.
   */
  double load() {
    return processorSeconds > 0 ? Math.max(1, clockSeconds / processorSeconds) : 1;
  }

  /** Stops a run when its thread has used the time up. */
  private ScheduledFuture<?> stopAfter(
      double limitSeconds, RunControl control, ThreadMXBean threads) {
    long thread = Thread.currentThread().getId();
    long end = threads.getThreadCpuTime(thread) + (long) (limitSeconds * 1e9);
    return watch.scheduleAtFixedRate(
        () -> {
          if (threads.getThreadCpuTime(thread) > end) {
            control.stop();
          }
        },
        LOOK_MILLIS,
        LOOK_MILLIS,
        TimeUnit.MILLISECONDS);
  }

  /**
   * Accuracy and largest step are the scene's: without a largest step a method may step over a
   * short force.
   */
  private RunSettings settings(Candidate candidate, Model model, double tolerance) {
    double absolute = tolerance * absolutePart;
    RunSettings defaults = model.description().defaults();
    return new RunSettings(
        grid.start(),
        reference.end(),
        grid.step(),
        candidate.method().integrator(),
        tolerance,
        absolute,
        defaults.maxStep(),
        0,
        0,
        absolute,
        absolute,
        absolute,
        defaults.accuracy());
  }

  private MeasuredRun measured(
      Candidate candidate,
      double tolerance,
      int round,
      double limitSeconds,
      RunReport report,
      Rows rows,
      double seconds,
      long bytes) {
    String cause = cause(report.outcome(), limitSeconds);
    if (cause.isEmpty() && !rows.complete()) {
      cause =
          String.format(
              Locale.ROOT, "ended too early: its events stopped it at %.6g s", rows.time());
    }
    return new MeasuredRun(
        candidate.method().name(),
        tolerance,
        round,
        cause,
        seconds,
        bytes,
        report.steps(),
        report.rejectedSteps(),
        report.evaluations(),
        report.jacobians(),
        report.factorisations(),
        cause.isEmpty() ? errors(rows, round == 0) : MeasuredRun.Errors.NONE,
        drift(report),
        limits(report));
  }

  /** Rejected steps by joint: a state is named after its joint, with q or v behind a point. */
  private static Map<String, Long> limits(RunReport report) {
    Map<String, Long> byJoint = new TreeMap<>();
    for (RunReport.Limit limit : report.limits()) {
      String joint = limit.state().replaceFirst("\\.[qv](\\[\\d+])?$", "");
      byJoint.merge(joint, limit.inaccurate() + limit.unsolved(), Long::sum);
    }
    Map<String, Long> mostFirst = new LinkedHashMap<>();
    byJoint.entrySet().stream()
        .sorted(Map.Entry.<String, Long>comparingByValue().reversed())
        .forEach(limit -> mostFirst.put(limit.getKey(), limit.getValue()));
    return mostFirst;
  }

  private static String cause(Outcome outcome, double limitSeconds) {
    if (outcome instanceof Outcome.Failed failed) {
      return failed.failure().message();
    }
    return outcome instanceof Outcome.Stopped
        ? NOT_FINISHED + ReportBudget.inWords(limitSeconds)
        : "";
  }

  private static double drift(RunReport report) {
    double scale = report.energyScale().orElse(Double.NaN);
    double drift = report.energyDrift().orElse(Double.NaN);
    return drift == 0 ? 0 : drift / scale;
  }

  /** Loops are looked at in one run only: the others are there for their time. */
  private MeasuredRun.Errors errors(Rows rows, boolean withLoops) {
    double atEnd = 0;
    double positions = 0;
    double velocities = 0;
    for (int i = 0; i < reference.times().length; i++) {
      double[] y = rows.at(reference.times()[i]);
      double[] expected = reference.states()[i];
      double ofPositions = distance.ofPositions(y, expected);
      double ofVelocities = distance.ofVelocities(y, expected);
      positions = Math.max(positions, ofPositions);
      velocities = Math.max(velocities, ofVelocities);
      atEnd = Math.max(ofPositions, ofVelocities);
    }
    double multipliers = Double.NaN;
    double residual = Double.NaN;
    if (withLoops && loops.isPresent()) {
      double[] openAndApart =
          loops.get().openAndApart(reference, i -> rows.at(reference.times()[i]));
      residual = openAndApart[0];
      multipliers = openAndApart[1];
    }
    return new MeasuredRun.Errors(
        atEnd, Math.max(positions, velocities), positions, velocities, multipliers, residual);
  }

  @Override
  public void close() {
    watch.shutdownNow();
  }

  /** Keeps the rows of a run that are on the grid; events may add others. */
  private static final class Rows implements ResultSink {
    private final RunGrid grid;
    private final double end;
    private double[][] states = new double[0][];
    private double[] last = new double[0];
    private double time = Double.NaN;

    Rows(RunGrid grid, double end) {
      this.grid = grid;
      this.end = end;
    }

    @Override
    public void begin(List<Variable> columns) {
      states = new double[grid.rows()][columns.size() - 1];
    }

    @Override
    public void row(double[] values) {
      time = values[0];
      int row = Math.min(grid.row(time), states.length - 1);
      if (time == end || grid.meets(time)) {
        System.arraycopy(values, 1, states[row], 0, states[row].length);
        last = states[row];
      }
    }

    /** The time of the last row, s. */
    double time() {
      return time;
    }

    /** Whether the run has come to the end of the interval. */
    boolean complete() {
      return time == end;
    }

    double[] at(double time) {
      return time == end ? last : states[grid.row(time)];
    }
  }
}
