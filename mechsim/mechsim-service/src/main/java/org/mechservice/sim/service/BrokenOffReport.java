package org.mechservice.sim.service;

import java.util.LinkedHashMap;
import java.util.Map;
import org.mechservice.solver.api.RunControl;
import org.mechservice.solver.api.RunSettings;

/** What is reported of a run whose solver has not lived, or was not waited for, to report. */
final class BrokenOffReport {
  private BrokenOffReport() {}

  /**
   * Returns the entries that are known, under the names the solver gives them. It reads as that of
   * a run that was stopped; who knows of a failure says so.
   *
   * @param rows put out so far
   * @param wallSeconds since the start, s
   */
  static Map<String, Object> of(RunPlan plan, RunControl control, long rows, double wallSeconds) {
    RunSettings settings = plan.task().settings();
    Map<String, Object> entries = new LinkedHashMap<>();
    entries.put("scene", plan.identity().modelName());
    entries.put("outcome", "stopped");
    entries.put("formulation", plan.task().description().formulation());
    entries.put("integrator", settings.integrator());
    entries.put("relativeTolerance", settings.relativeTolerance());
    entries.put("absoluteTolerance", settings.absoluteTolerance());
    entries.put("steps", control.steps());
    entries.put("rows", rows);
    entries.put("simulatedTime", timeReached(plan, control) - settings.tStart());
    entries.put("wallTime", wallSeconds);
    return entries;
  }

  /** Returns the simulated time that a run has reached, s; that of its start before it begins. */
  static double timeReached(RunPlan plan, RunControl control) {
    return Double.isNaN(control.time()) ? plan.task().settings().tStart() : control.time();
  }
}
