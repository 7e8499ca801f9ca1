package org.mechservice.sim.service.run;

import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntSupplier;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimSummary;
import org.mechservice.orb.ServiceVersion;
import org.mechservice.sim.service.contract.ContractTypes;
import org.mechservice.sim.service.results.RunIdentity;
import org.mechservice.sim.service.results.RunRecord;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Accuracy;

/**
 * The views of one run: its progress for its client, its summary and curves for administrators, its
 * report, and the record of it that stays. Thread-safe.
 */
final class RunStatus {
  private final RunPlan plan;
  private final IntSupplier queuePosition;
  private final RunControl control;
  private final RunLifecycle lifecycle;
  private final RunOutput output;
  private long stepsReported = -1;
  private int placeReported;

  /**
   * @param queuePosition place of the run in its queue, from 1; 0 if it is not there
   * @param control of the solver
   */
  RunStatus(
      RunPlan plan,
      IntSupplier queuePosition,
      RunControl control,
      RunLifecycle lifecycle,
      RunOutput output) {
    this.plan = plan;
    this.queuePosition = queuePosition;
    this.control = control;
    this.lifecycle = lifecycle;
    this.output = output;
  }

  /** Returns the place among the runs that wait, from 1; 0 if the run does not wait. */
  private int place() {
    return lifecycle.waits() ? queuePosition.getAsInt() : 0;
  }

  /** Returns the simulated time reached, s; that of the start before the run begins. */
  private double timeReached() {
    return Double.isNaN(control.time()) ? plan.task().settings().tStart() : control.time();
  }

  /**
   * Returns whether the run has taken a step, or moved up in the queue, since the previous call;
   * samples the curves if it has taken one.
   */
  synchronized boolean hasProgressed() {
    int place = place();
    boolean movedUp = place > 0 && place != placeReported;
    placeReported = place;
    long steps = control.steps();
    boolean stepped = lifecycle.runs() && steps != stepsReported;
    stepsReported = steps;
    if (stepped) {
      output.sampleCurves();
    }
    return movedUp || stepped;
  }

  /** Returns how far the run is. */
  Progress progress() {
    RunSettings settings = plan.task().settings();
    double wall = lifecycle.wallSeconds();
    double reached = timeReached();
    return new Progress(
        plan.identity().simId(),
        lifecycle.state(),
        place(),
        reached,
        settings.tStart(),
        settings.tEnd(),
        control.steps(),
        control.stepSize(),
        control.order(),
        wall > 0 ? (reached - settings.tStart()) / wall : 0,
        output.spool().rows());
  }

  /**
   * Returns the run as administrators see it.
   *
   * @param leaseEnd when its session's lease ends; UTC, ms since 1970-01-01
   */
  SimSummary summary(long leaseEnd) {
    RunIdentity identity = plan.identity();
    return new SimSummary(
        identity.simId(),
        identity.sessionId(),
        identity.hostName(),
        identity.modelName(),
        identity.owner(),
        progress(),
        identity.createdAt(),
        lifecycle.startedAt(),
        lifecycle.endedAt(),
        leaseEnd,
        RunRecord.shown(lifecycle.text()));
  }

  /**
   * Returns the run report as one flat JSON object: the solver's entries, then those of the
   * service. A number that is not finite is null.
   */
  String report(RunOutcome outcome) {
    Map<String, Object> all =
        new LinkedHashMap<>(outcome.report().orElseGet(this::reportWithoutSolver));
    outcome
        .failure()
        .ifPresent(
            failure -> {
              all.put("outcome", "failed");
              all.put("failure", failure.message());
            });
    all.put("where", "remote, host " + plan.identity().hostName());
    all.putAll(plan.setUp());
    all.put("serverVersion", ServiceVersion.CURRENT);
    JsonObject json = new JsonObject();
    all.forEach((key, value) -> add(json, key, value));
    return json.toString();
  }

  private static void add(JsonObject json, String key, Object value) {
    if (value instanceof Double number) {
      json.add(key, Double.isFinite(number) ? new JsonPrimitive(number) : JsonNull.INSTANCE);
    } else if (value instanceof Long number) {
      json.addProperty(key, number);
    } else if (value instanceof Boolean flag) {
      json.addProperty(key, flag);
    } else {
      json.addProperty(key, value.toString());
    }
  }

  /**
   * Returns the entries that are known without the solver's report, under the solver's names. They
   * describe a run that was stopped; {@link #report} adds the failure if there is one.
   */
  private Map<String, Object> reportWithoutSolver() {
    RunSettings settings = plan.task().settings();
    Map<String, Object> entries = new LinkedHashMap<>();
    entries.put("scene", plan.identity().modelName());
    entries.put("outcome", "stopped");
    entries.put("formulation", plan.task().description().formulation());
    entries.put("integrator", settings.integrator());
    entries.put("relativeTolerance", settings.relativeTolerance());
    entries.put("absoluteTolerance", settings.absoluteTolerance());
    if (settings.accuracy() != Accuracy.STANDARD) {
      entries.put(Accuracy.OPTION, settings.accuracy().label());
    }
    entries.put("steps", control.steps());
    entries.put("rows", output.spool().rows());
    entries.put("simulatedTime", timeReached() - settings.tStart());
    entries.put("wallTime", lifecycle.wallSeconds());
    if (control.stiff()) {
      entries.put("stiffness", "suspected");
    }
    return entries;
  }

  /**
   * Returns the record of the run.
   *
   * @param outcome how the run has ended, or will be reported to have ended; empty: it has not
   */
  RunRecord record(Optional<RunOutcome> outcome) {
    Progress last = progress();
    outcome.ifPresent(ended -> last.state = ended.state());
    return new RunRecord(
        plan.identity(),
        plan.columns(),
        plan.task().description().states(),
        last,
        lifecycle.startedAt(),
        lifecycle.endedAt(),
        outcome.map(ended -> ended.text(output.lastTime())).orElseGet(lifecycle::text),
        outcome.map(this::report).orElse(""),
        outcome.flatMap(RunOutcome::failure).map(ContractTypes::failure),
        output.curves());
  }
}
